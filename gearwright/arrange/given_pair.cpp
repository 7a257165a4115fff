#include "gearwright/arrange/given_pair.hpp"

#include "gearwright/gear/gear.hpp"

namespace gearwright {

namespace {

bool of_arcs(const GearInput& gear) { return !is_straight(gear.cylindrical.rack); }

bool cuts_with_arcs(const GearInput& gear) {
  return gear.cut_by && gear.cut_by->cutter && of_arcs(*gear.cut_by->cutter);
}

}  // namespace

bool has_arcs(const GearInput& gear) { return of_arcs(gear) || cuts_with_arcs(gear); }

bool has_arcs(const GivenPair& given) {
  for (const auto& gear : given.gears)
    if (gear && has_arcs(*gear)) return true;
  return false;
}

std::optional<Error> check_arcs(const GivenPair& given) {
  for (const int which : {1, 2}) {
    const GearInput* const gear = given.find(which);
    if (!gear || !gear->cut_by) continue;
    const GearInput* const cutter = given.find(3 - which);
    const bool by_mate = gear->cut_by->gear != 0 && cutter && of_arcs(*cutter);
    if (!by_mate && !cuts_with_arcs(*gear)) continue;
    return Error{
        gear_field(which, "cut_by"), "",
        "a gear with circular-arc teeth cannot be a pinion cutter; give this gear its own rack"};
  }
  if (!given.gears[1]) return std::nullopt;
  if (given.pair.shaft_angle && given.pair.shaft_angle->rad() != 0.0) {
    return refused("pair.shaft_angle", given.pair.shaft_angle->deg(),
                   "circular-arc gears run on parallel axes only; leave out this key");
  }
  if (given.pair.shorten_tips) {
    return Error{"pair.shorten_tips", "true",
                 "is not available for circular-arc gears, which have no profile shifts; give "
                 "`gear1.tip_diameter` and `gear2.tip_diameter` instead"};
  }
  return std::nullopt;
}

}  // namespace gearwright
