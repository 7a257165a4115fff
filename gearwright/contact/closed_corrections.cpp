// Corrections of circular-arc pairs in closed form, and the lead that removes the slope of the
// transmission error.                                  theory: docs/theory/08-contact.md
#include <cmath>
#include <numbers>

#include "gearwright/base/numbers.hpp"
#include "gearwright/contact/compensation.hpp"
#include "gearwright/contact/contact_setup.hpp"
#include "gearwright/math/root.hpp"
#include "gearwright/pair/arc_contact.hpp"
#include "gearwright/pair/arc_pair.hpp"

namespace gearwright {

namespace {

ArcMeshInput mesh_input(const ArcPair& pair, int convex) {
  const Gear& v = pair.gears[convex - 1];
  const Gear& c = pair.gears[static_cast<std::size_t>(2 - convex)];
  return {convex_arcs(v).front(),
          concave_arcs(c).front(),
          v.reference_diameter / 2,
          c.reference_diameter / 2,
          Angle::radians(std::numbers::pi / 2 - std::abs(v.spec.helix_angle.rad())),
          pair.center_distance};
}

// Changes the lead angle of `gear` by `delta_lambda`, and returns the slope dTE/dφ1 in the middle
// of the mesh of tooth pair 0.
std::optional<double> middle_slope(const ContactSetup& setup, bool gear2_drives, int gear,
                                   Angle delta_lambda) {
  SetupChange change;
  change.cutter_lead[gear - 1] = delta_lambda;
  const auto changed = setup.changed(change);
  if (!changed) return std::nullopt;
  const ContactPair pair = changed->pair(gear2_drives);
  Transmission transmission(pair);
  const PairTouch touch = transmission.of_pair_0(0.0);
  if (!touch.found()) return std::nullopt;
  return rotation_slope(transmission, touch);
}

}  // namespace

std::optional<SettingAnswer> arc_setting(const ArcPair& arcs, const ContactSetup& setup) {
  const auto convex = setup.convex_gear();
  if (!convex) return std::nullopt;
  ArcMeshInput in = mesh_input(arcs, *convex);
  SettingAnswer answer{};
  answer.angle_nominal = contact_angle(in);
  if (!answer.angle_nominal) return std::nullopt;
  const Angle theta = *answer.angle_nominal;
  const double delta = setup.place().errors.center_distance;
  answer.exact = tool_setting_change(in, theta, delta);
  answer.first_order = -delta;  // [T8.21]
  answer.thickness_change = thickness_change(in.convex, theta, answer.exact);
  // Both flanks move along their normals by Δb sin θ.
  answer.backlash_change = 2 * answer.exact * std::sin(theta.rad());
  in.center_distance += delta;
  answer.angle_displaced = contact_angle(in);
  const double b = in.convex.b;
  in.convex.b = b + answer.exact;
  answer.angle_exact = contact_angle(in);
  in.convex.b = b + answer.first_order;
  answer.angle_first_order = contact_angle(in);
  return answer;
}

std::optional<LeadAnswer> lead_without_slope(const ArcPair& arcs, const ContactSetup& setup,
                                             bool gear2_drives) {
  if (setup.gear(1).twist() == 0.0) return std::nullopt;
  const auto nominal = middle_slope(setup, gear2_drives, 1, Angle());
  if (!nominal) return std::nullopt;
  LeadAnswer answer{};
  answer.slope = *nominal;
  for (const int gear : {1, 2}) {
    const auto slope = [&](double d) {
      return middle_slope(setup, gear2_drives, gear, Angle::radians(d));
    };
    constexpr double kReach = 0.01;  // rad; greatest change of the lead angle, more than 0.5°
    const auto lo = slope(-kReach);
    const auto hi = slope(kReach);
    if (!lo || !hi || *lo * *hi > 0.0) continue;
    // If contact is lost, the slope is NaN, and find_root() finds no root.
    const auto or_lost = [&](double d) { return slope(d).value_or(kNoNumber); };
    const Root root = find_root(or_lost, -kReach, kReach);
    if (root.found()) answer.exact[gear - 1] = Angle::radians(root.x);
  }
  if (arcs.contacts.empty()) return answer;
  // Computes the change of the lead angle to first order for all errors together. [T8.22]
  const double theta = arcs.first_contact().at.theta.rad();
  const ContactErrors& e = setup.place().errors;
  const double sin_lambda = std::cos(setup.gear(1).spec.helix_angle.rad());
  const double r1 = setup.gear(1).reference_diameter / 2;
  const double r2 = setup.gear(2).reference_diameter / 2;
  const double hand = setup.gear(1).twist() > 0.0 ? 1.0 : -1.0;
  const double driven = gear2_drives ? -1.0 : 1.0;
  answer.first_order =
      Angle::radians(hand * sin_lambda * sin_lambda *
                         (e.crossing.rad() + e.helix_twist[0] * r1 + e.helix_twist[1] * r2) -
                     hand * driven * sin_lambda * e.intersecting.rad() * std::tan(theta) -
                     e.cutter_lead[0].rad() + e.cutter_lead[1].rad());
  return answer;
}

}  // namespace gearwright
