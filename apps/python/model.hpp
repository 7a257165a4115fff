// A spec and its results, on which Gear, Pair, Contact, Rating and Loaded are based.
//
// Values never change after construction, so threads may share them.
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
  Json spec;                     ///< the spec as given, by key
  std::filesystem::path folder;  ///< folder of relative file names in the spec
  SolvedJob job;

  const GivenKeys& given() const { return job.spec.given; }
};
using ModelPtr = std::shared_ptr<const Model>;

/// Solves the spec without the GIL.   Errors  with the keys of the spec
Result<ModelPtr> solved_model(Json spec, const std::filesystem::path& folder, Scope scope);
/// The same, but raises the error.   Throws  SpecError
ModelPtr make_model(Json spec, const std::filesystem::path& folder, Scope scope);

/// Raises the error with the keys of the spec.
[[noreturn]] void raise(const Error& error, const Model& model);

/// Converts names in mm and rad to keys: helix_angle = 0.26 becomes helix_angle_deg = 14.9. A name
/// that is not in the tables is unchanged, and the reader rejects it.
Json with_keys(Json tree, const std::vector<const KeyTable*>& tables, const std::string& path = "");
/// Returns the name in mm and rad for a key, such as normal_module for normal_module_mm. If the unit of the
/// key has no such name, it returns the key itself.
std::string house_key(const Key& key);
/// The number of units of the key in one mm or rad.
double units_per_house(const Key& key);
/// Converts all tables of a spec like with_keys.
Json spec_with_keys(Json tree);

/// Replaces members of `tree` by those of `changes`, also in nested tables. Null removes a member.
void change(Json& tree, const Json& changes);

/// A single gear, or one gear of a pair.
struct GearValue {
  ModelPtr model;
  int which = 1;

  std::vector<int> gears() const { return {which}; }
  const Gear& gear() const { return model->job.gears[static_cast<std::size_t>(which - 1)]; }
  /// The halves of a double-helical gear, of which gear() is one.
  const std::optional<Halves>& halves() const {
    return model->job.halves[static_cast<std::size_t>(which - 1)];
  }
  /// The table of the gear. For a gear of a pair it contains the computed profile shift.
  Json spec() const;
  /// The quantities of the gear, and those of its halves.
  ValueRecord record() const;
};

struct PairValue {
  ModelPtr model;

  std::vector<int> gears() const { return {1, 2}; }
  const Pair& pair() const { return *model->job.pair; }
  const Json& spec() const { return model->spec; }
  ValueRecord record() const { return pair_quantities().of(pair()); }
  Verdict verdict() const { return judge(model->job); }
};

/// The result of a verb for a pair. It contains the pair's spec with the additional input, and every quantity
/// of the result.
struct AnswerValue {
  ModelPtr model;  ///< includes the warnings of the result
  std::shared_ptr<const ValueRecord> quantities;
  std::function<Verdict()> verdict;

  const Json& spec() const { return model->spec; }
  const ValueRecord& record() const { return *quantities; }
};
struct ContactValue : AnswerValue {};
struct RatingValue : AnswerValue {};
struct LoadedValue : AnswerValue {};

/// Returns a model of the pair with other errors and modifications, and with `keys` in the table `name` of its
/// spec. None leaves the errors or modifications unchanged.
ModelPtr asked_model(const PairValue& pair, const py::object& errors,
                     const py::object& modifications, const KeyTable& table,
                     const std::string& name, const py::kwargs& keys);

/// Adds the common methods of every value with a spec. Unpickling calls `make` with the spec, which
/// gives the same value bit for bit.
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

/// Adds a quantity as an attribute whose value is get(self), unless the type already has an
/// attribute of this name.
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
void bind_pictures(py::module_& m, py::class_<GearValue>& gear, py::class_<PairValue>& pair,
                   py::class_<ContactValue>& contact);
void bind_catalogue(py::module_& m);
void bind_search(py::module_& m);
void bind_closed_forms(py::module_& m);

}  // namespace gearwright::python
