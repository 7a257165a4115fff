// A spec and what followed from it: what Gear, Pair, Contact, Rating and Loaded stand on.
//
// Values: nothing changes after it was made, so that threads may share it.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "apps/python/values.hpp"
#include "gearwright/catalogue/gear_quantities.hpp"
#include "gearwright/catalogue/key.hpp"
#include "gearwright/catalogue/pair_quantities.hpp"
#include "gearwright/catalogue/verdict_quantities.hpp"
#include "gearwright/job/judgement.hpp"
#include "gearwright/job/solved_job.hpp"

namespace gearwright::python {

struct Model {
  Json spec;                     ///< by key, as it was given
  std::filesystem::path folder;  ///< where file names in it start
  SolvedJob job;

  const GivenKeys& given() const { return job.spec.given; }
};
using ModelPtr = std::shared_ptr<const Model>;

/// Solves it, without the GIL.   Errors  in the keys of the spec
Result<ModelPtr> solved_model(Json spec, const std::filesystem::path& folder, Scope scope);
/// The same.   Throws  SpecError
ModelPtr make_model(Json spec, const std::filesystem::path& folder, Scope scope);

/// Raises it in the keys of the spec.
[[noreturn]] void raise(const Error& error, const Model& model);

/// Names in mm and rad become keys: helix_angle of 0.26 is helix_angle_deg of 14.9. What the tables do not
/// know stays, for the reader to refuse.
Json with_keys(Json tree, const std::vector<const KeyTable*>& tables, const std::string& path = "");
/// The name in mm and rad of a key: normal_module of normal_module_mm; itself where it names none of our units.
std::string house_key(const Key& key);
/// How many of the key's unit one mm or rad is.
double units_per_house(const Key& key);
/// The same of a whole spec.
Json spec_with_keys(Json tree);

/// Members of `changes` in place of those of `tree`, tables within tables; null takes one out.
void change(Json& tree, const Json& changes);

/// A gear by itself, or one of a pair's.
struct GearValue {
  ModelPtr model;
  int which = 1;

  std::vector<int> gears() const { return {which}; }
  const Gear& gear() const { return model->job.gears[static_cast<std::size_t>(which - 1)]; }
  /// The gear's table, of a pair's gear with the shift that followed.
  Json spec() const;
  ValueRecord record() const { return gear_quantities().of(gear()); }
};

struct PairValue {
  ModelPtr model;

  std::vector<int> gears() const { return {1, 2}; }
  const Pair& pair() const { return *model->job.pair; }
  const Json& spec() const { return model->spec; }
  ValueRecord record() const { return pair_quantities().of(pair()); }
  Verdict verdict() const { return judge(model->job); }
};

/// What a verb finds of a pair: the pair's spec with what was given beside it, and every quantity of the answer.
struct AnswerValue {
  ModelPtr model;  ///< with the warnings of the answer
  std::shared_ptr<const ValueRecord> quantities;
  std::function<Verdict()> verdict;

  const Json& spec() const { return model->spec; }
  const ValueRecord& record() const { return *quantities; }
};
struct ContactValue : AnswerValue {};
struct RatingValue : AnswerValue {};
struct LoadedValue : AnswerValue {};

/// The pair's spec with other errors and modifications, None as they are, and with `keys` in its table of this name.
ModelPtr asked_model(const PairValue& pair, const py::object& errors,
                     const py::object& modifications, const KeyTable& table,
                     const std::string& name, const py::kwargs& keys);

/// What every value of a spec has. Out of a pickle comes what `make` makes of the spec again, bit for bit.
template <class Self, class Make>
void bind_made(py::class_<Self>& type, const Make& make) {
  bind_copies(
      type, [](const Self& s) { return py::make_tuple(to_python(s.spec()), s.model->folder); },
      [make](const py::tuple& state) -> Self {
        return make(tree_of(state[0], ""), state[1].cast<std::filesystem::path>());
      });
  type.def(
          "as_dict", [](const Self& s) { return by_key(s.record()); },
          "Every quantity by key, each in the unit that its key names, as in JSON")
      .def_property_readonly(
          "spec", [](const Self& s) { return to_python(s.spec()); },
          "The values from which it was made, by key")
      .def_property_readonly(
          "warnings",
          [](const Self& s) {
            return by_name(Value(warning_quantities().each(s.model->job.warnings)));
          },
          "The warnings: Records with code, message, gear");
}

template <class Self>
void bind_verdict(py::class_<Self>& type) {
  type.def_property_readonly(
      "verdict", [](const Self& s) { return by_name(Value(verdict_quantities().of(s.verdict()))); },
      "The verdict: level, headline and findings, the worst one first");
}

/// A quantity as an attribute, get(self) its value; where the type has one of this name, that stays.
template <class Self, class Get>
void bind_quantity(py::class_<Self>& type, const QuantityInfo& info, const Get& get) {
  const std::string name = name_of(info);
  if (py::hasattr(type, name.c_str())) return;
  type.def_property_readonly(
      name.c_str(), [&info, get](const Self& s) { return by_name(info, get(s)); },
      docstring(info).c_str());
}

std::pair<py::class_<GearValue>, py::class_<PairValue>> bind_gears(py::module_& m);
py::class_<ContactValue> bind_answers(py::module_& m, py::class_<PairValue>& pair);
void bind_mountings(py::module_& m, py::class_<PairValue>& pair);
void bind_sweep(py::class_<PairValue>& pair);
void bind_files(py::class_<GearValue>& gear, py::class_<PairValue>& pair);
void bind_pictures(py::class_<GearValue>& gear, py::class_<PairValue>& pair,
                   py::class_<ContactValue>& contact);
void bind_catalogue(py::module_& m);
void bind_search(py::module_& m);
void bind_closed_forms(py::module_& m);

}  // namespace gearwright::python
