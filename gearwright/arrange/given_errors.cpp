#include "gearwright/arrange/given_errors.hpp"

#include <fmt/format.h>

#include <tuple>

#include "gearwright/arrange/cut_gears.hpp"
#include "gearwright/gear/gear_field.hpp"

namespace gearwright {

Error of_given_gear(Error error, const GivenPair& given, int which) {
  const GearInput& gear = given.gear(which);
  const bool own =
      error.field == "face_width" || error.field == "tip_diameter" || error.field == "teeth";
  if (error.field == "tip_diameter" && !gear.cylindrical.tip_diameter) {
    // The tip diameter is not given. It follows from the profile shift, or from the rack alone.
    const std::string from = gear.profile_shift ? "profile_shift" : "rack.addendum";
    const double value = gear.profile_shift.value_or(addendum_of(gear.cylindrical.rack));
    return following_from(gear_field(which, from), format_number(value), "this value requires",
                          of_gear(which, std::move(error)));
  }
  if (!gear.basic || own) return of_gear(which, std::move(error));
  return following_from(
      gear_field(which, "basic"), "",
      fmt::format("for the rack with a pressure angle of {:.6g}° that describes this gear,",
                  gear.cylindrical.normal_pressure_angle.deg()),
      error);
}

Error of_basic(const Error& error, const GivenPair& given) {
  for (const int which : {1, 2}) {
    const GearInput* const gear = given.find(which);
    if (!gear || !gear->basic) continue;
    const BaseGear<double>& base = *gear->basic;
    for (const auto& [of_rack, own, value] :
         {std::tuple{"normal_module", "basic.base_diameter", 2 * base.radius},
          std::tuple{"helix_angle", "basic.base_helix_angle",
                     Angle::radians(base.helix_angle).deg()},
          std::tuple{"profile_shift", "basic.base_tooth_thickness", base.tooth_thickness}}) {
      if (error.field != gear_field(which, of_rack)) continue;
      return following_from(gear_field(which, own), format_number(value),
                            "for the rack that describes this gear,", error);
    }
  }
  return error;
}

Error of_clearance(const Error& error, const GivenPair& given, int which) {
  const GearInput& gear = given.gear(which);
  if (error.field != gear_field(which, "tip_fillet.end_radius")) return error;
  const double clearance =
      gear.tip_clearance.value_or(default_tip_clearance(gear.cylindrical.normal_module));
  return {
      gear_field(which, "tip_fillet.clearance"), format_number(clearance),
      fmt::format("the tip would have to end at a radius of {} mm: {}", error.value, error.rule)};
}

Error of_distance(const Error& error, const GivenPair& given) {
  for (const int which : {1, 2}) {
    if (error.field != gear_field(which, "profile_shift") || !given.pair.center_distance ||
        given.gear(which).profile_shift)
      continue;
    return not_placed(following_from("pair.center_distance",
                                     format_number(*given.pair.center_distance),
                                     "this value requires", error));
  }
  return error;
}

Error not_placed(Error error) {
  if (error.kind == FailureKind::value) error.kind = FailureKind::placement;
  return error;
}

}  // namespace gearwright
