// A model contains a spec and its results. Values of the types Gear, Pair, Contact, Rating and
// Loaded refer to a model.
//
// A model never changes after its construction, so threads may share it.
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
#include "gearwright/catalogue/unit_system.hpp"
#include "gearwright/job/judgement.hpp"
#include "gearwright/job/result_json.hpp"
#include "gearwright/job/solved_job.hpp"

namespace gearwright::python {

struct Model {
  Json spec;                     ///< the given spec, by key
  std::filesystem::path folder;  ///< relative file names in the spec start here
  SolvedJob job;

  const GivenKeys& given() const { return job.spec.given; }
};
using ModelPtr = std::shared_ptr<const Model>;

/// Solves the spec without the GIL. Gear 2 may be a rack.   Errors  with the keys of the spec
Result<ModelPtr> solved_model(Json spec, const std::filesystem::path& folder, Scope scope);
/// Solves the spec and raises any error.   Throws  SpecError
ModelPtr make_model(Json spec, const std::filesystem::path& folder, Scope scope);

/// Returns the model, or raises SpecError if gear 2 is a rack.
ModelPtr with_two_gears(ModelPtr model);

/// Raises SpecError with the keys as the caller has given them.
[[noreturn]] void raise(const Error& error, const Model& model);

/// Converts names without a unit to keys. The value under such a name is in mm or rad, so
/// helix_angle = 0.26 becomes helix_angle_deg = 14.9, and in a spec in inch, face_width = 25.4
/// becomes face_width_in = 1. An unknown name is unchanged, and the reader of the spec rejects it.
Json with_keys(Json tree, const std::vector<const KeyTable*>& tables, UnitSystem units,
               const std::string& path = "");
/// The key of an object that names its units, and the table of a Gear in inch.
inline constexpr const char* kUnitsKey = "units";
/// Returns the units of a spec or of the table of a Gear, which are mm if the key is absent.
UnitSystem units_of(const Json& spec);
/// Returns a whole spec in these units.   Throws  SpecError
Json spec_with_units(Json spec, UnitSystem units);
/// Returns the table of a gear in these units, without the key `units`.   Throws  SpecError
Json gear_with_units(Json gear, UnitSystem units);
/// Returns the spec in which gear 2 has all its keys (spec/inherit.hpp).   Throws  SpecError
Json inherited(const Json& spec);
/// Returns the key with this name, which may lack the unit of the key, or null.
const Key* key_of_name(const KeyTable& table, const std::string& name);
/// Returns an error if the given number is within the range of the key and the converted number is
/// not. The caller has probably forgotten the unit, for example helix_angle = 15 instead of
/// helix_angle_deg = 15. The converted number is then more than twice as great as the limits.
/// `name` is the name of the key in the error.
std::optional<Error> missing_unit(const Key& key, const std::string& name, double given,
                                  double converted);
/// Returns the name of the key without its unit, for example normal_module for the key
/// normal_module_mm. The value under this name is in mm or rad. If there is no such name, returns
/// the key itself.
std::string house_key(const Key& key);
/// Returns the number of units of the key in one mm or one rad.
double units_per_house(const Key& key);
/// Returns the spec with keys in place of names without a unit. If a gear has units of its own, its
/// table is converted to the units of the spec; if the spec has none, they become those of the
/// spec.
Json spec_with_keys(Json tree);

/// Returns the spec of a TOML or JSON file or of a dict, and the folder in which its relative file
/// names start. A dict has no folder.   Throws   FileError, SpecError
std::pair<Json, std::filesystem::path> read_tree(const py::object& given);

/// Returns the quantity with this key, or an empty value if the record does not have this key.
const Value& quantity(const ValueRecord& record, std::string_view key);
/// Returns the member of the record that the attribute `name` shows, or null. Two keys of a table
/// can have the same name. For example, the transmission error of a gear is an angle, and the
/// transmission error of a rack is a length. A record contains only one of the two keys.
const Member* member_of(const ValueRecord& record, const std::string& name);

/// Replaces members of `tree` by the members of `changes`, including the members of nested tables.
/// A null removes a member.
void change(Json& tree, const Json& changes);
/// Sets keys of the table `table` of a spec. If the spec has a value of another type in place of the
/// table, the spec is unchanged, and the reader of the spec rejects it.
void set_keys(Json& spec, const std::string& table, const Json& keys);

/// A single gear, or one gear of a pair.
struct GearValue {
  ModelPtr model;
  int which = 1;

  std::vector<int> gears() const { return {which}; }
  const Gear& gear() const { return model->job.gear(which); }
  /// Returns the halves of a double-helical gear. gear() returns one of these halves.
  const std::optional<Halves>& halves() const { return model->job.halves[which - 1]; }
  /// Returns the table of the gear in the spec, with the values that gear 2 inherits. If the gear
  /// belongs to a pair, the table contains the computed profile shift. A table in inch begins with
  /// the key `units`.
  Json spec() const;
  /// Returns the quantities of the gear and of its halves, if it has any.
  ValueRecord record() const;
};

/// Two gears, or a pinion and its rack.
struct PairValue {
  ModelPtr model;

  std::vector<int> gears() const { return {1, 2}; }
  const std::optional<RackPair>& rack() const { return model->job.rack; }
  /// Domain    two gears
  const Pair& pair() const { return *model->job.pair; }
  const Json& spec() const { return model->spec; }
  ValueRecord record() const { return pair_record(model->job); }
  Verdict verdict() const { return judge(model->job); }
};

/// The result of a verb for a pair. It consists of the spec, which includes the additional input of
/// the verb, and of every quantity of the result.
struct AnswerValue {
  ModelPtr model;  ///< contains the warnings of the result
  std::shared_ptr<const ValueRecord> quantities;
  std::function<Verdict()> verdict;

  const Json& spec() const { return model->spec; }
  const ValueRecord& record() const { return *quantities; }
};
struct ContactValue : AnswerValue {};
struct RatingValue : AnswerValue {};
struct LoadedValue : AnswerValue {};

/// Returns a model of the pair with other errors and modifications, and with `keys` in the
/// table `name` of its spec. If `errors` or `modifications` is None, the errors or
/// modifications of the pair are used.
ModelPtr asked_model(const PairValue& pair, const py::object& errors,
                     const py::object& modifications, const KeyTable& table,
                     const std::string& name, const py::kwargs& keys);

/// Adds the methods that all values with a spec have in common. Unpickling calls `make` with the
/// spec, which gives the same value, bit for bit.
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
          "The values from which the object was made, by key")
      .def_property_readonly(
          "warnings",
          [](const Self& s) {
            return by_name(warning_quantities().table(),
                           Value(warning_quantities().each(s.model->job.warnings)));
          },
          "The warnings: Records with code, message, gear");
}

/// Adds items by key, comparison and hash. Two values are equal if their specs are equal.
template <class Self>
void bind_value(py::class_<Self>& type) {
  type.def("__getitem__",
           [](const Self& s, const std::string& key) {
             const py::dict all = by_key(s.record());
             if (!all.contains(key)) throw py::key_error(key);
             return py::object(all[py::str(key)]);
           })
      .def("__contains__",
           [](const Self& s, const py::object& key) {
             return py::dict(by_key(s.record())).contains(key);
           })
      .def("__iter__", [](const Self& s) { return py::iter(by_key(s.record())); })
      .def("__eq__",
           [](const Self& a, const py::object& b) {
             return py::isinstance<Self>(b) &&
                    json_text(a.spec()) == json_text(b.cast<const Self&>().spec());
           })
      .def("__hash__", [](const Self& s) { return py::hash(py::str(json_text(s.spec()))); });
}

template <class Self>
void bind_verdict(py::class_<Self>& type) {
  type.def_property_readonly(
      "verdict",
      [](const Self& s) {
        return by_name(verdict_quantities().table(), Value(verdict_quantities().of(s.verdict())));
      },
      "The verdict: level, headline and findings, the worst one first");
}

/// Adds a quantity of the table as an attribute if the type does not yet have an attribute with
/// this name. get(self) returns the value of the attribute.
template <class Self, class Get>
void bind_quantity(py::class_<Self>& type, const QuantityTable& table, const QuantityInfo& info,
                   const Get& get) {
  const std::string name = name_of(info);
  if (py::hasattr(type, name.c_str())) return;
  type.def_property_readonly(name.c_str(), get, docstring(table, name).c_str());
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
