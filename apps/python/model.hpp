// A spec and what followed from it: what Gear, Pair and Contact of Python stand on.
//
// Values: nothing changes after it was made, so that threads may share it.
#pragma once

#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "apps/python/values.hpp"
#include "gearwright/catalogue/key.hpp"
#include "gearwright/job/solved_job.hpp"

namespace gearwright::python {

struct Model {
  Json spec;                     ///< by key, as it was given
  std::filesystem::path folder;  ///< where file names in it start
  JobSpec read;                  ///< the same, as it was read
  SolvedJob job;

  const GivenKeys& given() const { return read.given; }
};
using ModelPtr = std::shared_ptr<const Model>;

/// Solves it, without the GIL.   Throws  SpecError
ModelPtr make_model(Json spec, const std::filesystem::path& folder, Scope scope);
JobSpec read_tree_of(const Json& spec, const std::filesystem::path& folder);

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

  const Gear& gear() const { return model->job.gears[static_cast<std::size_t>(which - 1)]; }
  /// The gear's table, of a pair's gear with the shift that followed.
  Json spec() const;
};

struct PairValue {
  ModelPtr model;

  const Pair& pair() const { return *model->job.pair; }
};

/// Every quantity.
ValueRecord record_of(const GearValue& gear);
ValueRecord record_of(const PairValue& pair);
Json spec_of(const GearValue& gear);
Json spec_of(const PairValue& pair);

/// Records with code, message, gear.
py::object warnings_of(const std::vector<Warning>& warnings);

std::pair<py::class_<GearValue>, py::class_<PairValue>> bind_gears(py::module_& m);
void bind_answers(py::module_& m);
void bind_said(py::module_& m);
void bind_search(py::module_& m);
void bind_closed_forms(py::module_& m);

}  // namespace gearwright::python
