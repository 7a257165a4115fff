// Defines the types Gear and Pair, which are made from keyword arguments. Every quantity of the
// catalogue is an attribute.
#include <fmt/format.h>
#include <pybind11/stl/filesystem.h>

#include "apps/python/model.hpp"
#include "gearwright/arrange/notes.hpp"
#include "gearwright/catalogue/gear_keys.hpp"
#include "gearwright/catalogue/spec_keys.hpp"
#include "gearwright/job/result_json.hpp"
#include "gearwright/spec/parse_spec.hpp"

namespace gearwright::python {

namespace {

namespace fs = std::filesystem;

// Adds null to `tree` for every None in a dict, because tree_of() omits them.
void add_nulls(py::handle value, Json& tree) {
  if (!PyDict_Check(value.ptr())) return;
  for (const auto& [name, member] : py::reinterpret_borrow<py::dict>(value))
    add_nulls(member, tree[std::string(py::str(name))]);
}

// Converts keyword arguments to changes of a spec. None becomes null, which removes a key.
Json changes_of(const py::kwargs& kwargs) {
  Json changes = Json::object();
  for (const auto& [name, value] : kwargs) {
    const std::string key = py::str(name);
    changes[key] = tree_of(value, key);
    add_nulls(value, changes[key]);
  }
  return changes;
}

// Returns the units after a change: those that the call gives, or those of the object. None stands
// for mm. An unknown word is left to the reader of the spec.
UnitSystem units_after(const py::kwargs& kwargs, UnitSystem own) {
  if (!kwargs.contains(kUnitsKey)) return own;
  const py::object word = kwargs[kUnitsKey];
  if (word.is_none()) return UnitSystem::mm;
  Json given = Json::object();
  given[kUnitsKey] = tree_of(word, kUnitsKey);
  return units_of(given);
}

// Moves the keywords that belong to [pair] into this table. A call may contain both such
// keywords and whole tables of the spec. `units` are the units of the spec after the change.
Json pair_changes(const py::kwargs& kwargs, UnitSystem units) {
  Json spec = Json::object();
  const Json changes = changes_of(kwargs);
  for (const auto& [key, value] : changes.items()) {
    if (key == "pair") {
      for (const auto& [inner, of_pair] : value.items()) spec["pair"][inner] = of_pair;
    } else {
      (spec_keys().find(key) ? spec : spec["pair"])[key] = value;
    }
  }
  const Json word = spec.value(kUnitsKey, Json());
  spec[kUnitsKey] = to_string(units);
  spec = spec_with_keys(std::move(spec));
  spec.erase(kUnitsKey);
  if (!word.is_null() && word != to_string(units))
    spec[kUnitsKey] = word;  // rejected by the reader
  return spec;
}

GearValue gear_value(Json gear, const fs::path& folder) {
  Json spec = Json::object();
  if (const auto units = gear.find(kUnitsKey); units != gear.end()) {
    spec[kUnitsKey] = *units;
    gear.erase(kUnitsKey);
  }
  spec["gear1"] = with_keys(std::move(gear), {&gear_keys()}, units_of(spec));
  auto made = solved_model(std::move(spec), folder, Scope::gears);
  if (!made) raise_of_gear(made.error());
  return {std::move(made).take(), 1};
}

PairValue pair_value(Json spec, const fs::path& folder) {
  return {make_model(std::move(spec), folder, Scope::pair)};
}

GearValue replaced(const GearValue& gear, const py::kwargs& kwargs) {
  const Json own = gear.spec();
  const UnitSystem units = units_after(kwargs, units_of(own));
  Json tree = Json::object();
  if (units == UnitSystem::inch) tree[kUnitsKey] = to_string(units);
  tree.update(gear_with_units(own, units));
  change(tree, with_keys(changes_of(kwargs), {&gear_keys()}, units));
  return gear_value(tree, gear.model->folder);
}

PairValue mounted(const GearValue& gear_1, const GearValue& gear_2, const py::kwargs& kwargs) {
  const Json one = gear_1.spec();
  const UnitSystem units = units_after(kwargs, units_of(one));
  Json spec = Json::object();
  if (units == UnitSystem::inch) spec[kUnitsKey] = to_string(units);
  spec["gear1"] = gear_with_units(one, units);
  spec["gear2"] = gear_with_units(gear_2.spec(), units);
  change(spec, pair_changes(kwargs, units));
  return pair_value(std::move(spec), gear_1.model->folder);
}

PairValue replaced(const PairValue& pair, const py::kwargs& kwargs) {
  const UnitSystem units = units_after(kwargs, units_of(pair.model->spec));
  Json spec = spec_with_units(pair.model->spec, units);
  // A Gear replaces the whole table of the gear. A dict changes only the keys that it contains.
  for (const char* gear : {"gear1", "gear2"})
    if (kwargs.contains(gear) && py::isinstance<GearValue>(kwargs[gear])) spec.erase(gear);
  change(spec, pair_changes(kwargs, units));
  return pair_value(std::move(spec), pair.model->folder);
}

py::object load(const py::object& given) {
  auto [spec, folder] = read_tree(given);
  if (is_path(given)) spec = inherited(spec);
  if (spec.contains("gear2")) return py::cast(pair_value(std::move(spec), folder));
  return py::cast(GearValue{make_model(std::move(spec), folder, Scope::gears), 1});
}

template <class S>
Value value_of(const Quantity& q, const S& s) {
  return Quantities<S>::exists(q, s) ? Quantities<S>::value(q, s) : Value();
}

// Adds every quantity as an attribute. value(self, quantity) returns its value.
template <class Self, class S, class GetValue>
void bind_quantities(py::class_<Self>& type, const Quantities<S>& quantities,
                     const GetValue& value) {
  for (const Quantity& q : quantities.list())
    bind_quantity(type, quantities.table(), q.info,
                  [&q, value](const Self& self) { return by_name(q.info, value(self, q)); });
}

// Returns the quantity of a gear. For a double-helical gear, the result is the quantity of the
// whole gear.
Value value_of_gear(const GearValue& g, const Quantity& q) {
  return g.halves() ? Value(quantity(g.record(), q.info.key)) : value_of(q, g.gear());
}

}  // namespace

std::pair<py::class_<GearValue>, py::class_<PairValue>> bind_gears(py::module_& m) {
  py::class_<GearValue> gear(
      m, "Gear",
      "A cylindrical gear, made from the keys of [gear1] of a spec. A key with its unit "
      "(helix_angle_deg) takes a value in this unit; a key without unit (normal_module, "
      "helix_angle) takes a value in mm or rad. With units=\"inch\", keys of lengths end in _in");
  gear.def(py::init([](const py::kwargs& kwargs) { return gear_value(tree_of(kwargs, ""), {}); }))
      .def(
          "replace", [](const GearValue& g, const py::kwargs& k) { return replaced(g, k); },
          "Returns the gear with changed values; None removes a key")
      .def("__repr__", [](const GearValue& g) {
        const Gear& made = g.gear();
        return fmt::format("Gear(teeth={}, normal_module_mm={:g}, helix_angle_deg={:g}{})",
                           made.spec.teeth, made.spec.normal_module, made.spec.helix_angle.deg(),
                           made.involute()
                               ? fmt::format(", profile_shift={:g}", made.spec.profile_shift)
                               : ", circular arcs");
      });
  bind_made(gear, gear_value);
  bind_value(gear);
  bind_quantities(gear, gear_quantities(), value_of_gear);

  py::class_<PairValue> pair(
      m, "Pair",
      "Two gears in a housing, with the keys of [pair] (center_distance, backlash, …), "
      "and errors=, contact=, compensate=, load=, rating= as tables of a spec");
  pair.def(py::init(&mounted), py::arg("gear1"), py::arg("gear2"))
      .def(
          "replace", [](const PairValue& p, const py::kwargs& k) { return replaced(p, k); },
          "Returns the pair with changed values; gear1= and gear2= take a Gear or a dict of "
          "changes; None removes a key")
      .def(
          "result",
          [](const PairValue& p) { return to_python(job_json(p.model->job, p.verdict())); },
          "Returns gears, pair, warnings and verdict as in the program's JSON")
      .def("__repr__", [](const PairValue& p) {
        if (p.rack())
          return fmt::format("Pair({} / rack, center_distance_mm={:.6g}, contact_ratio={:.4f})",
                             p.rack()->pinion.spec.teeth, p.rack()->center_distance,
                             p.rack()->transverse_contact_ratio() + p.rack()->overlap_ratio);
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
  for (const int which : {1, 2})
    pair.def_property_readonly(
        fmt::format("gear{}", which).c_str(),
        [which](const PairValue& p) {
          return GearValue{which == 2 ? with_two_gears(p.model) : p.model, which};
        },
        "The gear as mounted");
  pair.def_property_readonly(
      "rack",
      [](const PairValue& p) -> py::object {
        if (!p.rack()) return py::none();
        return by_name(rack_quantities().table(), Value(rack_quantities().of(p.rack()->rack)));
      },
      "The quantities of the rack as a Record, or None if gear 2 is not a rack");
  bind_made(pair, pair_value);
  bind_verdict(pair);
  bind_value(pair);
  const auto value = [](const PairValue& p, const auto& q) {
    return p.rack() ? Value(quantity(p.record(), q.info.key)) : value_of(q, p.pair());
  };
  bind_quantities(pair, pair_quantities(), value);
  bind_quantities(pair, rack_pair_quantities(), [](const PairValue& p, const auto& q) {
    return Value(quantity(p.record(), q.info.key));
  });

  m.def("load", &load, py::arg("spec"),
        "Returns the Gear or the Pair of a spec, which is a TOML or JSON file or a dict. Relative "
        "file names start at the folder of the spec");
  return {gear, pair};
}

}  // namespace gearwright::python
