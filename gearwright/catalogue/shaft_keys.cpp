#include "gearwright/catalogue/gear_keys.hpp"

#include <fmt/format.h>

#include <optional>
#include <string>
#include <vector>

#include "gearwright/base/units.hpp"

namespace gearwright {

namespace {

std::optional<KeyFault> check_shaft(Shaft& shaft, const KeyGiven&) {
  const std::size_t diameters = shaft.diameters.size();
  if (shaft.steps.size() + 1 == diameters) return std::nullopt;
  return KeyFault{
      "steps_mm",
      diameters == 1
          ? std::string("needs a list of diameters in diameter_mm, one diameter more than the "
                        "number of steps")
          : fmt::format("must have one entry fewer than diameter_mm ({} entries for {} diameters), "
                        "because its entries are the places at which the diameter changes",
                        diameters - 1, diameters)};
}

void set_bearing_stiffness(Shaft& shaft, const std::vector<double>& newton_per_um) {
  shaft.bearing_stiffness = {newton_per_um.front() / kMmPerUm, newton_per_um.back() / kMmPerUm};
}

}  // namespace

const KeyTable& shaft_keys() {
  static const KeyTable table{
      "shaft",
      "The shaft of a gear on two bearings; positions are measured along the axis from the middle "
      "of the face",
      {Key::number("bearings_mm", "", KeyRange::between(-kMaxInput, kMaxInput), &Shaft::bearings,
                   kRequired,
                   "positions of the two bearings along the axis, from the middle of the face "
                   "towards +z; for an overhung gear both bearings are on the same side")
           .with_list(
               {.least = 2,
                .most = 2,
                .order = {true, "must be in rising order, with the bearing towards −z first"}})
           .with_also({"bearings", "bearing_positions", "supports"}),
       Key::positive(
           "diameter_mm", "d_sh", &Shaft::diameters, kRequired,
           "diameter of the shaft, or diameters of the sections of the shaft, starting at −z; for "
           "a pinion that is integral with the shaft, the root diameter can be used")
           .with_list(KeyList{1, kMostShaftDiameters, true})
           .with_fields({"diameters"})
           .with_also({"diameters", "diameter", "d"}),
       Key::number("steps_mm", "", KeyRange::between(-kMaxInput, kMaxInput), &Shaft::steps,
                   "a shaft with a single diameter",
                   "places at which the diameter changes, one entry fewer than `diameter_mm`")
           .with_list({.least = 1,
                       .most = kMostShaftDiameters - 1,
                       .single = true,
                       .order = {true, "must be in rising order along the shaft, starting at −z"}})
           .with_also({"steps", "shoulders"}),
       Key::positive("youngs_modulus_MPa", "E", &Shaft::youngs_modulus, "206 000, for steel",
                     "Young's modulus of the shaft")
           .with_also({"e", "modulus", "elasticity"}),
       Key::number("poisson_ratio", "ν", KeyRange::between(0, 0.5), &Shaft::poisson_ratio, "0.3",
                   "Poisson's ratio of the shaft")
           .with_also({"nu", "poisson"}),
       Key::positive(
           "bearing_stiffness_N_per_um", "",
           KeyPlace::by<Shaft, std::vector<double>>(set_bearing_stiffness), "rigid bearings",
           "radial stiffness of the bearings, as one number for both bearings or two numbers")
           .with_list(KeyList{1, 2, true})
           .with_also({"bearing_stiffness", "stiffness"}),
       Key::word("torque_from", {"left", "right"}, &Shaft::torque_from, "\"left\"",
                 "side on which the torque enters or leaves the shaft; `left` is towards −z, and "
                 "`right` is towards +z")
           .with_also({"torque_side", "coupling"}),
       Key::flag("shear", &Shaft::shear, "true",
                 "if true, the deflection includes shear deformation (Timoshenko); if false, only "
                 "bending")},
      check_shaft};
  return table;
}

}  // namespace gearwright
