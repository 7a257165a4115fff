#include "gearwright/job/compensate_forms.hpp"

#include <cmath>
#include <numbers>

#include "gearwright/math/root.hpp"
#include "gearwright/pair/tool_setting.hpp"

namespace gearwright {

namespace {

ArcMeshInput mesh_input(const ArcPair& pair, int convex) {
  const Gear& v = pair.gears[static_cast<std::size_t>(convex - 1)];
  const Gear& c = pair.gears[static_cast<std::size_t>(2 - convex)];
  return {convex_arcs(v).front(),
          concave_arcs(c).front(),
          v.reference_diameter / 2,
          c.reference_diameter / 2,
          Angle::radians(std::numbers::pi / 2 - std::abs(v.spec.helix_angle.rad())),
          pair.center_distance};
}

// dTE/dφ1 of tooth pair 0 in the middle of its mesh, with a changed lead angle of one gear.
std::optional<double> middle_slope(const ContactSetup& setup, bool gear2_drives, int gear,
                                   Angle delta_lambda) {
  SetupChange change;
  change.cutter_lead[static_cast<std::size_t>(gear - 1)] = delta_lambda;
  const auto changed = setup.changed(change);
  if (!changed) return std::nullopt;
  const ContactPair pair = changed->pair(gear2_drives);
  Transmission transmission(pair);
  const PairTouch touch = transmission.of_pair_0(0.0);
  if (!touch.found()) return std::nullopt;
  return rotation_slope(transmission, touch);
}

}  // namespace

std::optional<SettingAnswer> arc_setting(const SolvedJob& job, const ContactSetup& setup) {
  const auto convex = setup.convex_gear();
  const ArcPair* arcs = job.pair->arcs();
  if (!convex || !arcs) return std::nullopt;
  ArcMeshInput in = mesh_input(*arcs, *convex);
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

std::optional<LeadAnswer> lead_without_slope(const SolvedJob& job, const ContactSetup& setup) {
  // An involute pair touches along lines. Its lead is corrected by slopes, which `compensate`
  // computes.
  const ArcPair* arcs = job.pair->arcs();
  if (!arcs || setup.gear(1).twist() == 0.0) return std::nullopt;
  const bool gear2_drives = job.spec.contact.driver == 2;
  const auto nominal = middle_slope(setup, gear2_drives, 1, Angle());
  if (!nominal) return std::nullopt;
  LeadAnswer answer{};
  answer.slope = *nominal;
  for (const int gear : {1, 2}) {
    const auto slope = [&](double d) {
      return middle_slope(setup, gear2_drives, gear, Angle::radians(d));
    };
    constexpr double kReach = 0.01;  // rad: slightly more than half a degree
    const auto lo = slope(-kReach);
    const auto hi = slope(kReach);
    if (!lo || !hi || *lo * *hi > 0.0) continue;
    // If contact is lost in between, the bracket has no root.
    constexpr double kLost = std::numeric_limits<double>::quiet_NaN();
    const auto or_lost = [&](double d) { return slope(d).value_or(kLost); };
    const Root root = find_root(or_lost, -kReach, kReach);
    if (root.found()) answer.exact[static_cast<std::size_t>(gear - 1)] = Angle::radians(root.x);
  }
  if (!arcs->contacts.empty()) {
    // [T8.22], for all errors together.
    const double theta = arcs->first_contact().at.theta.rad();
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
  }
  return answer;
}

}  // namespace gearwright
