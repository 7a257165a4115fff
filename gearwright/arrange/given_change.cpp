#include "gearwright/arrange/given_change.hpp"

#include "gearwright/base/units.hpp"

namespace gearwright {

namespace {

bool set_allowance(GivenPair& given, GearInput& gear, double value) {
  if (gear.allowance_ends || gear.tolerance.says_thickness() || given.pair.wants_backlash())
    return false;
  gear.cylindrical.thickness_allowance = value;
  return true;
}

// If the transverse module is given, changing the helix angle would also change the normal module.
// The function therefore returns false.
bool set_helix(GearInput& gear, double degrees) {
  if (gear.transverse_given) return false;
  gear.cylindrical.helix_angle = Angle::degrees(degrees);
  gear.helix_given = true;
  return true;
}

// `value` is the whole face including the gap of a double-helical gear. `face_width` is the face of
// one half.
void set_face(GearInput& gear, double value) {
  gear.cylindrical.face_width =
      gear.double_helical ? (value - gear.double_helical->gap) / 2 : value;
  gear.face_width_given = true;
}

bool change_gear(GivenPair& given, const SpecChange& change) {
  GearInput& gear = *given.gears[static_cast<std::size_t>(change.gear - 1)];
  const bool has_rack = !gear.basic && !gear.cut_by;
  switch (change.what) {
    case Adjustable::profile_shift: gear.profile_shift = change.value; return has_rack;
    case Adjustable::tip_diameter:
      gear.cylindrical.tip_diameter = change.value;
      return !gear.cylindrical.tip_fillet && !gear.tip_clearance && !gear.tip_clearance_by_rule;
    case Adjustable::thickness_allowance:
      return has_rack && set_allowance(given, gear, change.value);
    case Adjustable::teeth:
      gear.cylindrical.teeth = static_cast<int>(change.value);
      return has_rack;
    case Adjustable::helix_angle: return has_rack && set_helix(gear, change.value);
    case Adjustable::face_width: set_face(gear, change.value); return true;
    case Adjustable::bore:
      if (gear.bore) gear.bore->diameter = change.value;
      return gear.bore.has_value();
    case Adjustable::lead_crowning:
      for (FlankModifications& flank : gear.modifications)
        flank.lead_crowning = kMmPerUm * change.value;
      return true;
    case Adjustable::lead_slope:
      for (FlankModifications& flank : gear.modifications)
        flank.lead_slope = kMmPerUm * change.value;
      return true;
    case Adjustable::center_distance: break;
  }
  return false;
}

}  // namespace

bool make_change(GivenPair& given, const SpecChange& change) {
  if (change.what == Adjustable::center_distance) {
    given.pair.center_distance = change.value;
    return true;
  }
  if (change.gear > 0) return change_gear(given, change);
  return change.what == Adjustable::face_width &&
         change_gear(given, {change.what, 1, change.value}) &&
         change_gear(given, {change.what, 2, change.value});
}

}  // namespace gearwright
