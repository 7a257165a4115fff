// What a verb of the program answers: solve, verify.
#include <fmt/format.h>
#include <pybind11/stl.h>

#include <algorithm>

#include "apps/python/model.hpp"
#include "apps/python/watched.hpp"
#include "gearwright/catalogue/compensate_keys.hpp"
#include "gearwright/catalogue/compensate_quantities.hpp"
#include "gearwright/catalogue/fit_quantities.hpp"
#include "gearwright/catalogue/spelling.hpp"
#include "gearwright/job/compensate_text.hpp"
#include "gearwright/job/fit_answer.hpp"
#include "gearwright/job/verbs.hpp"
#include "gearwright/job/verify.hpp"

namespace gearwright::python {

namespace {

// The spec of a dict, or of what has one: a Pair, a Gear.
std::pair<Json, std::filesystem::path> spec_and_folder(const py::object& spec) {
  if (py::isinstance<PairValue>(spec)) {
    const auto& pair = spec.cast<const PairValue&>();
    return {pair.model->spec, pair.model->folder};
  }
  if (py::isinstance<GearValue>(spec)) {
    const auto& gear = spec.cast<const GearValue&>();
    if (!gear.model->job.pair) return {gear.model->spec, gear.model->folder};
    Json tree = Json::object();
    tree["gear1"] = gear.spec();
    return {tree, gear.model->folder};
  }
  return {spec_with_keys(tree_of(spec, "")), {}};
}

py::object solve_spec(const py::object& given, const std::string& verb) {
  if (!verb.empty() && find_verb(verb) == nullptr)
    raise({"verb", verb, "must be one of " + verb_names()});
  const auto [tree, folder] = spec_and_folder(given);
  const JobSpec spec = read_tree_of(tree, folder);
  std::optional<Result<Json>> answer;
  Watched watched;
  watch(watched, [&] { answer = answer_json(verb, spec, &watched.progress); });
  if (!*answer) raise(spelled(answer->error(), spec.given));
  return to_python(answer->value());
}

py::object fit(const py::object& given) {
  const auto [tree, folder] = spec_and_folder(given);
  const JobSpec spec = read_tree_of(tree, folder);
  std::optional<Result<FitAnswer>> found;
  Watched watched;
  watch(watched, [&] { found = answer_fit(spec, &watched.progress); });
  if (!*found) raise(spelled(found->error(), spec.given));
  return by_name(Value(fit_quantities().of(fit_view(found->value()))));
}

py::object compensate(const py::object& given, const py::kwargs& kwargs) {
  auto [tree, folder] = spec_and_folder(given);
  const Json changes = with_keys(tree_of(kwargs, "compensate"), {&compensate_keys()}, "compensate");
  for (const auto& [key, value] : changes.items()) tree["compensate"][key] = value;
  const ModelPtr model = make_model(std::move(tree), folder, Scope::pair);
  SolvedJob job = model->job;
  std::optional<Result<CompensateAnswer>> found;
  Watched watched;
  watch(watched, [&] { found = answer_compensate(job, &watched.progress); });
  if (!*found) raise(found->error(), *model);
  return by_name(Value(compensate_quantities().of(compensate_view(found->value()))));
}

py::object verify(const py::object& cases) {
  const Json tree = tree_of(cases, "");
  const std::string text = json_text(tree);
  const auto outcomes = [&] {
    const py::gil_scoped_release free;
    return verify_cases(text);
  }();
  if (!outcomes) raise(outcomes.error());
  py::list all;
  for (const CaseOutcome& c : *outcomes) {
    py::dict one;
    one["id"] = c.id;
    one["values"] = c.values;
    one["differences"] = c.differences;
    all.append(one);
  }
  return all;
}

}  // namespace

void bind_answers(py::module_& m) {
  m.def("solve", &solve_spec, py::arg("spec"), py::arg("verb") = "",
        ("The program's JSON answer as a dict. `spec`: a dict with the tables of a spec file, a "
         "Pair or a Gear; `verb`: one of " +
         verb_names() + "; by default pair where there are two gears")
            .c_str());
  m.def("fit", &fit, py::arg("spec"),
        "What is absent in the spec's gears and [pair] is found: a Record with branches, reason, "
        "nearest; load(branch.spec) "
        "is an answer as a Pair");
  m.def("compensate", &compensate, py::arg("pair"),
        "Corrections against errors, with the keys of [compensate] (corrections=, range=, "
        "centering=): a Record with "
        "corrections, before, after; load(record.spec) is the corrected pair");
  m.def("_verify", &verify, py::arg("cases"));
}

}  // namespace gearwright::python
