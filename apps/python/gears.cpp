// Gear and Pair: made from numbers by name, every quantity of the catalogue an attribute.
#include <fmt/format.h>
#include <pybind11/stl/filesystem.h>

#include <nlohmann/json.hpp>

#include "apps/python/model.hpp"
#include "apps/python/pickles.hpp"
#include "gearwright/arrange/notes.hpp"
#include "gearwright/catalogue/gear_keys.hpp"
#include "gearwright/catalogue/gear_quantities.hpp"
#include "gearwright/catalogue/pair_keys.hpp"
#include "gearwright/catalogue/pair_quantities.hpp"
#include "gearwright/catalogue/spec_keys.hpp"
#include "gearwright/catalogue/verdict_quantities.hpp"
#include "gearwright/job/judgement.hpp"
#include "gearwright/job/result_json.hpp"

namespace gearwright::python {

namespace {

namespace fs = std::filesystem;

// Changes by name; None takes a key out.
Json changes_of(const py::kwargs& kwargs) {
  Json changes = Json::object();
  for (const auto& [name, value] : kwargs) {
    const std::string key = py::str(name);
    changes[key] = tree_of(py::reinterpret_borrow<py::object>(value), key);
  }
  return changes;
}

// Keys of [pair] and of the file itself side by side, as keywords have them.
Json pair_changes(const py::kwargs& kwargs) {
  Json spec = Json::object();
  Json pair = Json::object();
  const Json changes = changes_of(kwargs);
  for (const auto& [key, value] : changes.items())
    (spec_keys().find(key) && key != "pair" ? spec : pair)[key] = value;
  if (pair.contains("pair")) {
    const Json inner = pair["pair"];
    pair.erase("pair");
    change(pair, inner);
  }
  spec = spec_with_keys(std::move(spec));
  if (!pair.empty()) spec["pair"] = with_keys(std::move(pair), {&pair_keys()}, "pair");
  return spec;
}

GearValue make_gear_value(const Json& gear, const fs::path& folder) {
  Json spec = Json::object();
  spec["gear1"] = with_keys(gear, {&gear_keys()});
  JobSpec read = [&] {
    const py::gil_scoped_release free;
    auto result = read_spec(json_text(spec), SpecFormat::json, folder);
    const py::gil_scoped_acquire hold;
    if (!result) raise_of_gear(result.error());
    return std::move(result).take();
  }();
  auto solved = [&] {
    const py::gil_scoped_release free;
    return solve(read, Scope::gears);
  }();
  if (!solved) raise_of_gear(spelled(solved.error(), read.given));
  return {std::make_shared<const Model>(
              Model{std::move(spec), folder, std::move(read), std::move(solved).take()}),
          1};
}

GearValue replaced(const GearValue& gear, const py::kwargs& kwargs) {
  Json tree = gear.spec();
  change(tree, with_keys(changes_of(kwargs), {&gear_keys()}));
  return make_gear_value(tree, gear.model->folder);
}

PairValue make_pair_value(const GearValue& gear_1, const GearValue& gear_2,
                          const py::kwargs& kwargs) {
  Json spec = Json::object();
  spec["gear1"] = gear_1.spec();
  spec["gear2"] = gear_2.spec();
  change(spec, pair_changes(kwargs));
  return {make_model(std::move(spec), gear_1.model->folder, Scope::pair)};
}

PairValue replaced(const PairValue& pair, const py::kwargs& kwargs) {
  Json spec = pair.model->spec;
  for (const char* gear : {"gear1", "gear2"})  // a Gear, unlike a dict, is the whole of it
    if (kwargs.contains(gear) && py::isinstance<GearValue>(kwargs[gear])) spec.erase(gear);
  change(spec, pair_changes(kwargs));
  return {make_model(std::move(spec), pair.model->folder, Scope::pair)};
}

// The gear or the pair of a file, or of a dict.
py::object load(const py::object& given) {
  Json spec;
  fs::path folder;
  if (is_path(given)) {
    const SpecText text = value_or_raise(read_spec_text(path_of(given, "spec")));
    spec = parse_json(value_or_raise(read_spec(text)).tree);
    folder = text.folder;
  } else {
    spec = spec_with_keys(tree_of(given, ""));
  }
  if (spec.contains("gear2"))
    return py::cast(PairValue{make_model(std::move(spec), folder, Scope::pair)});
  return py::cast(GearValue{make_model(std::move(spec), folder, Scope::gears), 1});
}

template <class S, class Class, class Subject>
void say_attributes(Class& type, const Quantities<S>& quantities, const Subject& subject) {
  using Self = typename Class::type;
  for (const Quantity<S>& q : quantities.list()) {
    const std::string name = name_of(q.info);
    if (py::hasattr(type, name.c_str()))
      throw std::logic_error("two attributes are called " + name);
    type.def_property_readonly(
        name.c_str(),
        [&q, subject](const Self& self) -> py::object {
          const S& s = subject(self);
          if (q.exists && !q.exists(s)) return py::none();
          return by_name(q.info, q.get(s));
        },
        docstring(q.info).c_str());
  }
}

py::object verdict_of(const Model& model) {
  return by_name(Value(verdict_quantities().of(judge(model.job))));
}

template <class Class>
void bind_value(Class& type) {
  using Self = typename Class::type;
  type.def(
          "as_dict", [](const Self& s) { return by_key(record_of(s)); },
          "Every quantity by key, each in the unit that its key names: what JSON has")
      .def("__getitem__",
           [](const Self& s, const std::string& key) {
             const py::dict all = by_key(record_of(s));
             if (!all.contains(key)) throw py::key_error(key);
             return py::object(all[py::str(key)]);
           })
      .def_property_readonly(
          "warnings", [](const Self& s) { return warnings_of(s.model->job.warnings); },
          "What a person should know: Records with code, message, gear")
      .def("__eq__",
           [](const Self& a, const py::object& b) {
             return py::isinstance<Self>(b) &&
                    json_text(spec_of(a)) == json_text(spec_of(b.cast<const Self&>()));
           })
      .def("__hash__", [](const Self& s) { return py::hash(py::str(json_text(spec_of(s)))); });
}

}  // namespace

py::object warnings_of(const std::vector<Warning>& warnings) {
  return by_name(Value(warning_quantities().each(warnings)));
}

ValueRecord record_of(const GearValue& g) { return gear_quantities().of(g.gear()); }
ValueRecord record_of(const PairValue& p) { return pair_quantities().of(p.pair()); }
Json spec_of(const GearValue& g) { return g.spec(); }
Json spec_of(const PairValue& p) { return p.model->spec; }

std::pair<py::class_<GearValue>, py::class_<PairValue>> bind_gears(py::module_& m) {
  py::class_<GearValue> gear(
      m, "Gear",
      "A cylindrical gear, made by the keys of [gear1] of a spec: with their unit "
      "(helix_angle_deg) or without, in mm and rad (normal_module, helix_angle)");
  gear.def(py::init(
               [](const py::kwargs& kwargs) { return make_gear_value(tree_of(kwargs, ""), {}); }))
      .def(
          "replace", [](const GearValue& g, const py::kwargs& k) { return replaced(g, k); },
          "The gear with other numbers; None takes one out")
      .def_property_readonly(
          "spec", [](const GearValue& g) { return to_python(g.spec()); },
          "What it was made from, by key")
      .def("__repr__", [](const GearValue& g) {
        const Gear& made = g.gear();
        return fmt::format("Gear(teeth={}, normal_module_mm={:g}, helix_angle_deg={:g}{})",
                           made.spec.teeth, made.spec.normal_module, made.spec.helix_angle.deg(),
                           made.involute()
                               ? fmt::format(", profile_shift={:g}", made.spec.profile_shift)
                               : ", circular arcs");
      });
  bind_copies(
      gear, [](const GearValue& g) { return py::make_tuple(to_python(g.spec()), g.model->folder); },
      [](const py::tuple& state) {
        return make_gear_value(tree_of(state[0], ""), state[1].cast<fs::path>());
      });
  bind_value(gear);
  say_attributes(gear, gear_quantities(),
                 [](const GearValue& g) -> const Gear& { return g.gear(); });

  py::class_<PairValue> pair(
      m, "Pair",
      "Two gears in a housing, with the keys of [pair] (center_distance, backlash, …), "
      "and errors=, contact=, compensate= as tables of a spec");
  pair.def(py::init(&make_pair_value), py::arg("gear1"), py::arg("gear2"))
      .def(
          "replace", [](const PairValue& p, const py::kwargs& k) { return replaced(p, k); },
          "The pair with other numbers; gear1= and gear2= take a Gear, or a dict of changes; None "
          "takes a "
          "key out")
      .def_property_readonly(
          "spec", [](const PairValue& p) { return to_python(p.model->spec); },
          "What it was made from, by key")
      .def_property_readonly(
          "gear1",
          [](const PairValue& p) {
            return GearValue{p.model, 1};
          },
          "As mounted")
      .def_property_readonly(
          "gear2",
          [](const PairValue& p) {
            return GearValue{p.model, 2};
          },
          "As mounted")
      .def_property_readonly(
          "verdict", [](const PairValue& p) { return verdict_of(*p.model); },
          "Whether the pair runs, the worst finding first")
      .def(
          "result",
          [](const PairValue& p) { return to_python(job_json(p.model->job, judge(p.model->job))); },
          "gears, pair, warnings and verdict: the program's JSON")
      .def("__repr__", [](const PairValue& p) {
        const CylindricalSpec& one = p.pair().gear(1).spec;
        const CylindricalSpec& two = p.pair().gear(2).spec;
        const std::string chosen = shifts_follow(p.model->job.spec)
                                       ? fmt::format("profile_shift={:.4g} / {:.4g} (chosen), ",
                                                     one.profile_shift, two.profile_shift)
                                       : "";
        return fmt::format("Pair({} / {}, center_distance_mm={:.6g}, {}contact_ratio={:.4f})",
                           one.teeth, two.teeth, p.pair().center_distance(), chosen,
                           p.pair().contact_ratio());
      });
  bind_copies(
      pair,
      [](const PairValue& p) { return py::make_tuple(to_python(p.model->spec), p.model->folder); },
      [](const py::tuple& state) {
        return PairValue{make_model(tree_of(state[0], ""), state[1].cast<fs::path>(), Scope::pair)};
      });
  bind_value(pair);
  say_attributes(pair, pair_quantities(),
                 [](const PairValue& p) -> const Pair& { return p.pair(); });

  m.def("load", &load, py::arg("spec"),
        "The Gear or the Pair of a spec: of its file, TOML or JSON, beside which files that it "
        "names are looked for, "
        "or a dict");
  return {gear, pair};
}

}  // namespace gearwright::python
