// Defines the results of the verbs. They are the types Contact, Rating and Loaded of a pair, and
// the results of the functions solve, fit, compensate, scatter and verify.
#include <fmt/format.h>

#include "apps/python/arrays.hpp"
#include "apps/python/model.hpp"
#include "apps/python/watched.hpp"
#include "gearwright/base/output_file.hpp"
#include "gearwright/base/version.hpp"
#include "gearwright/catalogue/compensate_keys.hpp"
#include "gearwright/catalogue/compensate_quantities.hpp"
#include "gearwright/catalogue/contact_quantities.hpp"
#include "gearwright/catalogue/figure_units.hpp"
#include "gearwright/catalogue/fit_quantities.hpp"
#include "gearwright/catalogue/rating_keys.hpp"
#include "gearwright/catalogue/scatter_quantities.hpp"
#include "gearwright/job/analysis.hpp"
#include "gearwright/job/fit_answer.hpp"
#include "gearwright/job/verbs.hpp"
#include "gearwright/job/verify.hpp"
#include "gearwright/report/report_sections.hpp"
#include "gearwright/spec/parse_spec.hpp"
#include "gearwright/store/parquet.hpp"

namespace gearwright::python {

namespace {

// Runs the analysis and converts its result to a Self. Ctrl-C stops the computation.
template <class Self, class Found>
Self answered(const ModelPtr& asked, const Analysis<Found>& how) {
  const auto model = std::make_shared<Model>(*asked);
  const auto work = [&](Progress* progress) -> Result<AnswerValue> {
    auto found = how.find(model->job, progress);
    if (!found) return found.error();
    const auto answer = std::make_shared<const Found>(std::move(found).take());
    return AnswerValue{model, std::make_shared<const ValueRecord>(how.record(model->job, *answer)),
                       [model, answer, judged = how.judge] { return judged(model->job, *answer); }};
  };
  return Self{watched_result(model->given(), work)};
}

ContactValue contact_of(const PairValue& pair, const py::object& errors,
                        const py::object& modifications, const py::kwargs& keys) {
  return answered<ContactValue>(
      asked_model(pair, errors, modifications, contact_keys(), "contact", keys), kContactAnalysis);
}

RatingValue rating_of(const PairValue& pair, const py::kwargs& keys) {
  return answered<RatingValue>(
      with_two_gears(asked_model(pair, py::none(), py::none(), rating_keys(), "rating", keys)),
      kRatingAnalysis);
}

LoadedValue loaded_of(const PairValue& pair, const py::object& errors,
                      const py::object& modifications, const py::kwargs& keys) {
  return answered<LoadedValue>(
      with_two_gears(asked_model(pair, errors, modifications, load_keys(), "load", keys)),
      kLoadAnalysis);
}

py::array positions_of(const ContactValue& c) {
  return table_array(position_quantities().table(), *quantity(c.record(), "positions").list());
}

// Returns an array of shape (torques, positions) with the quantities of each position.
py::object load_positions_of(const LoadedValue& loaded) {
  const ValueList& torques = *quantity(loaded.record(), "torques").list();
  if (torques.empty()) return py::none();
  ValueList all;
  for (const Value& torque : torques)
    for (const Value& position : *quantity(*torque.record(), "positions").list())
      all.push_back(position);
  return table_array(load_position_quantities().table(), all)
      .attr("reshape")(torques.size(), all.size() / torques.size());
}

// Returns the quantity with this name for all positions, converted to mm and rad. `info` describes
// the quantity if no position has a value.
py::object column(const ContactValue& c, const std::string& name, const QuantityInfo* info) {
  for (const Value& position : *quantity(c.record(), "positions").list())
    if (const Member* found = member_of(*position.record(), name)) info = found->info;
  const py::object one = positions_of(c).attr("__getitem__")(info->key);
  const double unit = house_unit(info->unit);
  return unit == 1.0 ? one : one.attr("__mul__")(unit);
}

std::string repr_of(const ContactValue& c) {
  const Member& span = *member_of(c.record(), "peak_to_peak");
  return fmt::format("Contact({} positions, {}={:.4g})",
                     quantity(c.record(), "positions").list()->size(), span.info->key,
                     span.value.number().value_or(kNoNumber));
}

std::string repr_of(const RatingValue& r) {
  const auto both = [&](const char* key) {
    const ValueList& each = *quantity(r.record(), key).list();
    return fmt::format("{}={:.4g} / {:.4g}", key, *each[0].number(), *each[1].number());
  };
  return "Rating(" + both("S_H") + ", " + both("S_F") + ")";
}

std::string repr_of(const LoadedValue& l) {
  const auto count = [&](const char* key) { return quantity(l.record(), key).list()->size(); };
  return fmt::format("Loaded({} torques, {} probes)", count("torques"), count("probes"));
}

// Defines a type of result. Every quantity of the table is an attribute. Unpickling calls of(pair)
// to compute the result again.
template <class Self>
void bind_answer(py::class_<Self>& type, const QuantityTable& table, Self (*of)(const PairValue&)) {
  bind_made(type, [of](Json spec, const std::filesystem::path& folder) {
    return of({make_model(std::move(spec), folder, Scope::pair)});
  });
  bind_verdict(type);
  bind_value(type);
  type.def_property_readonly("pair", [](const Self& s) { return PairValue{s.model}; })
      .def("__repr__", [](const Self& s) { return repr_of(s); });
  for (const QuantityInfo* info : table.list)
    bind_quantity(type, table, *info, [name = name_of(*info)](const Self& s) -> py::object {
      const Member* found = member_of(s.record(), name);
      return found ? by_name(*found->info, found->value) : py::none();
    });
}

// Returns the spec that a dict, a Pair, a Gear, a Drive or another object contains, and the folder
// of this spec.
std::pair<Json, std::filesystem::path> spec_and_folder(const py::object& spec) {
  if (py::isinstance<PairValue>(spec)) {
    const auto& pair = spec.cast<const PairValue&>();
    return {pair.spec(), pair.model->folder};
  }
  if (py::isinstance<GearValue>(spec)) {
    const auto& gear = spec.cast<const GearValue&>();
    if (!gear.model->job.pair) return {gear.model->spec, gear.model->folder};
    Json tree = Json::object();
    tree["gear1"] = gear.spec();
    return {spec_with_keys(std::move(tree)), gear.model->folder};
  }
  const py::object drive = py::module_::import("gearwright._drives").attr("Drive");
  if (!py::isinstance(spec, drive)) return read_tree(spec);
  const py::object folder = spec.attr("_folder");
  return {spec_with_keys(tree_of(spec.attr("_spec"), "")),
          path_or_none(folder, "folder").value_or("")};
}

JobSpec read_spec_of(const py::object& given, const py::object& own_folder = py::none()) {
  auto [tree, folder] = spec_and_folder(given);
  if (const auto other = path_or_none(own_folder, "folder")) folder = *other;
  return value_or_raise(read_spec_tree(tree, folder));
}

py::object solve_spec(const py::object& given, const std::string& verb, const py::object& folder) {
  if (!verb.empty() && find_verb(verb) == nullptr)
    raise({"verb", verb, "must be one of " + verb_names()});
  const JobSpec spec = read_spec_of(given, folder);
  return to_python(watched_result(
      spec.given, [&](Progress* progress) { return answer_json(verb, spec, progress); }));
}

py::object fit(const py::object& given) {
  const JobSpec spec = read_spec_of(given);
  const FitAnswer found =
      watched_result(spec.given, [&](Progress* progress) { return answer_fit(spec, progress); });
  return by_name(fit_quantities().table(), Value(fit_quantities().of(found)));
}

py::object compensate(const py::object& given, const py::kwargs& kwargs) {
  auto [tree, folder] = spec_and_folder(given);
  const Json changes =
      with_keys(tree_of(kwargs, "compensate"), {&compensate_keys()}, units_of(tree), "compensate");
  set_keys(tree, "compensate", changes);
  const ModelPtr model = with_two_gears(make_model(std::move(tree), folder, Scope::pair));
  SolvedJob job = model->job;
  const CompensateAnswer found = watched_result(
      model->given(), [&](Progress* progress) { return kCompensateAnalysis.find(job, progress); });
  return by_name(compensate_quantities().table(), Value(kCompensateAnalysis.record(job, found)));
}

// Returns the columns of the samples. These are the inputs, such as "errors.crossing_deg" or
// "bearings.bore_a.x_mm", and then the quantities by key.
std::vector<std::string> member_columns(const ScatterAnswer& a) {
  std::vector<std::string> names = coordinate_names(a.task.tolerances);
  for (const ScatterEntry& entry : scatter_entries()) names.emplace_back(entry.key);
  return names;
}

// Calls cell(sample, column, x) for every column of every sample, with an optional number x.
template <class Cell>
void each_member(const ScatterAnswer& a, const Cell& cell) {
  for (std::size_t i = 0; i < a.scatter.samples.size(); ++i) {
    const ScatterSample& sample = a.scatter.samples[i];
    std::size_t column = 0;
    for (const double x : sample.x) cell(i, column++, std::optional(x));
    for (const ScatterEntry& entry : scatter_entries()) {
      auto x = sample.member[entry.quantity];
      if (x) x = entry.shown(*x);
      cell(i, column++, x);
    }
  }
}

py::array members_of(const ScatterAnswer& a) {
  StructuredArray rows;
  for (const std::string& name : member_columns(a)) rows.add(name, "f8");
  rows.allocate(a.scatter.samples.size());
  each_member(a, [&](std::size_t i, std::size_t column, std::optional<double> x) {
    const Value value(x);
    rows.set(i, column, {&value});
  });
  return rows.take();
}

// Writes the rows of members_of() to a Parquet file. A missing value is null.
void write_members(const ScatterAnswer& a, const std::string& spec, const py::object& given_path) {
  const std::filesystem::path path = path_of(given_path, "path");
  const py::gil_scoped_release free;
  std::vector<ParquetColumn> heads;
  for (const std::string& name : member_columns(a))
    heads.push_back({name, ParquetType::float64, true});
  write_file_by(path, [&](const std::filesystem::path& part) {
    ParquetWriter table(part, heads,
                        {{"program", fmt::format("gearwright {}", kVersion)}, {"spec", spec}});
    each_member(a, [&](std::size_t, std::size_t column, std::optional<double> x) {
      if (x) table.set(column, *x);
      if (column + 1 == heads.size()) table.end_row();
    });
    table.close();
  });
}

py::object scatter(const py::object& given, const py::kwargs& kwargs) {
  auto [tree, folder] = spec_and_folder(given);
  const Json changes =
      with_keys(tree_of(kwargs, "scatter"), {&scatter_keys()}, units_of(tree), "scatter");
  set_keys(tree, "scatter", changes);
  const std::string spec = json_text(tree);
  const ModelPtr model = with_two_gears(make_model(std::move(tree), folder, Scope::pair));
  SolvedJob job = model->job;
  const auto found = std::make_shared<const ScatterAnswer>(watched_result(
      model->given(), [&](Progress* progress) { return kScatterAnalysis.find(job, progress); }));
  const ScatterView view = scatter_view(job, *found);
  const py::object record =
      by_name(scatter_quantities().table(), Value(scatter_quantities().of(view)));
  const py::object set = record.attr("_attributes").attr("__setitem__");
  set("members", members_of(*found));
  std::vector<Figure> figures = scatter_figures(view);
  for (Figure& f : figures) f = in_units(job.spec.units(), std::move(f));
  set("figures", py::cast(figures));
  set("to_parquet",
      py::cpp_function([found, spec](const py::object& path) { write_members(*found, spec, path); },
                       py::arg("path")));
  return record;
}

py::object verify(const py::object& cases) {
  const Json file = tree_of(cases, "");
  const auto outcomes = value_or_raise([&] {
    const py::gil_scoped_release free;
    return run_cases(file);
  }());
  py::list all;
  for (const CaseOutcome& c : outcomes) {
    py::dict one;
    one["id"] = c.id;
    one["values"] = c.values;
    one["differences"] = c.differences;
    all.append(one);
  }
  return all;
}

}  // namespace

py::class_<ContactValue> bind_answers(py::module_& m, py::class_<PairValue>& pair) {
  py::class_<ContactValue> contact(
      m, "Contact", "The tooth contact of a pair over one pitch, under the errors of its spec");
  contact.def_property_readonly("positions", &positions_of,
                                "A structured array with a row for each position and a column for "
                                "each quantity, named by its key");
  bind_answer<ContactValue>(contact, contact_quantities().table(), [](const PairValue& p) {
    return contact_of(p, py::none(), py::none(), {});
  });
  for (const Quantity& q : position_quantities().list()) {
    const std::string name = name_of(q.info);
    if (q.info.of || py::hasattr(contact, name.c_str())) continue;
    contact.def_property_readonly(
        name.c_str(),
        [name, info = &q.info](const ContactValue& c) { return column(c, name, info); },
        (docstring(position_quantities().table(), name) +
         " The array has one value for each position.")
            .c_str());
  }
  py::class_<RatingValue> rating(m, "Rating", "The strength of a pair by the standard");
  bind_answer<RatingValue>(rating, rating_quantities().table(),
                           [](const PairValue& p) { return rating_of(p, {}); });
  py::class_<LoadedValue> loaded(m, "Loaded", "A pair under torque with elastic teeth");
  loaded.def_property_readonly(
      "positions", &load_positions_of,
      "A structured array of shape (torques, positions) with a column for each quantity, named by "
      "its key. The number of load shares varies, so they are in torques[i].positions. The value "
      "is None if only probes were requested");
  bind_answer<LoadedValue>(loaded, load_quantities().table(), [](const PairValue& p) {
    return loaded_of(p, py::none(), py::none(), {});
  });

  pair.def("contact", &contact_of, py::arg("errors") = py::none(),
           py::arg("modifications") = py::none(),
           "Computes the tooth contact of the pair under errors over one pitch. errors is a dict "
           "with keys of [errors], or a row of the array that transmission_error accepts; "
           "modifications is {\"gear1\": {…}, \"gear2\": {…}}; other arguments are keys of "
           "[contact], for example positions=64, driver, pattern. Absent values are taken from the "
           "pair's spec")
      .def("rate", &rating_of,
           "Computes the strength by ISO 6336 or VDI 2736. Arguments are keys of [rating], for "
           "example torque_Nm, speed_rpm, quality; absent values are taken from the pair's spec. "
           "Gears need a material, for example material={\"name\": \"18CrNiMo7-6\"}")
      .def("loaded", &loaded_of, py::arg("errors") = py::none(),
           py::arg("modifications") = py::none(),
           "Computes the pair under torque. Arguments are keys of [load], for example "
           "torque_Nm=[100, 200], positions, slices; errors and modifications have the form that "
           "contact() accepts. Absent values are taken from the pair's spec");
  m.def("solve", &solve_spec, py::arg("spec"), py::arg("verb") = "", py::arg("folder") = py::none(),
        ("Returns the program's JSON answer as a dict. `spec` is a dict with the tables of a spec "
         "file, the path of such a file, a Pair, a Gear or a Drive; `verb` is one of " +
         verb_names() +
         "; the default for two gears is the verb `pair`. Relative file names in a dict start at "
         "`folder`")
            .c_str());
  m.def("_in_mm", [](const py::object& spec) {
    return to_python(spec_with_units(spec_with_keys(tree_of(spec, "")), UnitSystem::mm));
  });
  m.def("_read", [](const py::object& path) {
    const auto [tree, folder] = read_tree(path);
    return py::make_tuple(to_python(tree), folder);
  });
  m.def("fit", &fit, py::arg("spec"),
        "Computes the values that are absent in the gears and in [pair] of the spec. Returns a "
        "Record with branches (the solutions), reason (why there is no solution) and nearest (the "
        "nearest values that have a solution); load(branch.spec) returns the Pair of a branch");
  m.def("compensate", &compensate, py::arg("pair"),
        "Computes corrections for errors; arguments are keys of [compensate] (corrections=, "
        "range=, centering=). Returns a Record with the attributes `corrections`, `before` (scores "
        "without corrections) and `after` (scores with corrections); load(record.spec) returns the "
        "corrected pair");
  m.def("scatter", &scatter, py::arg("pair"),
        "Computes the effect of tolerances on a pair; arguments are keys of [scatter] (errors=, "
        "gear1=, samples=, robust=). Returns a Record with a distribution for each quantity, and "
        "with the attributes `probability`, `indices`, `worst` and `robust`. The attribute "
        "`members` of the Record is a "
        "structured array with a row for each sample and a column for each input and quantity, "
        "named by its key. The method to_parquet(path) of the Record writes these rows to a "
        "Parquet file. The attribute `figures` contains the figures of the report and, with "
        "pattern=True, the density of the contact pattern");
  m.def("_verify", &verify, py::arg("cases"));
  return contact;
}

}  // namespace gearwright::python
