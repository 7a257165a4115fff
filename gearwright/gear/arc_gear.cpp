
#include <cmath>
#include <numbers>

#include "gearwright/base/error.hpp"
#include "gearwright/gear/finished_gear.hpp"
#include "gearwright/math/root.hpp"

namespace gearwright::detail {

namespace {

std::optional<Error> check_spec(const CylindricalSpec& spec) {
  const std::string why = "cannot be combined with a rack of arcs";
  if (spec.teeth < 0)
    return refused(
        "teeth", spec.teeth,
        "an internal gear cannot have circular-arc teeth, because only a rack cuts such teeth");
  if (spec.profile_shift != 0.0) {
    return refused("profile_shift", spec.profile_shift,
                   why +
                       "; the position of the arc centres (`rack.center_b`) determines the depth "
                       "of the cutter");
  }
  for (const auto* fillet :
       {spec.root_fillet ? "root_fillet" : nullptr, spec.tip_fillet ? "tip_fillet" : nullptr}) {
    if (fillet) return Error{fillet, "", why};
  }
  return std::nullopt;
}

// Returns the diameter at which the two flanks of a tooth meet. Returns none if they do not meet
// within the range that the last arc of the edge cuts.
std::optional<double> pointed_diameter(const RackMotion& motion, const CutterEdge& edge) {
  const auto* last = std::get_if<EdgeCircle>(&edge.arcs.back().shape);
  GW_EXPECTS(last != nullptr);
  const RackTrochoid curve(motion, *last);
  const double a = last->begin_tau.rad();
  const double b = last->end_tau.rad();
  const auto theta = [&](double tau) { return curve.polar_angle(tau); };
  if (!(theta(a) > 0.0 && theta(b) <= 0.0)) return std::nullopt;
  return 2 * curve.point(find_root(theta, std::min(a, b), std::max(a, b)).x).norm();
}

// True if the arc of the flank begins on the root side of its cusp.
bool is_undercut(const EdgeCircle& flank, const std::optional<Angle>& limit) {
  if (!limit) return false;
  return flank.q > 0.0 ? *limit > flank.begin_tau : *limit < flank.begin_tau;
}

// Finds undercut. The gear records the data of an undercut flank arc or, if no arc is undercut, of
// the lowest flank arc. Arcs that join two flanks are not examined, because they have no contact.
void look_for_undercut(Gear& gear, const RackMotion& motion, const CutterEdge& edge) {
  auto& flanks = std::get<ArcTeeth>(gear.flanks);
  bool first = true;
  for (const EdgeArc& arc : edge.arcs) {
    const auto* circle = std::get_if<EdgeCircle>(&arc.shape);
    if (arc.cuts != ArcName::flank || !circle || circle->q == 0.0 || !(first || circle->q > 0.0))
      continue;
    const auto limit = undercut_limit(motion, *circle);
    const bool undercut = is_undercut(*circle, limit);
    if (first || undercut) {
      flanks.flank_begin = circle->begin_tau;
      flanks.undercut_limit = limit;
    }
    gear.undercut = gear.undercut || undercut;
    first = false;
  }
}

}  // namespace

std::optional<Angle> undercut_limit(const RackMotion& motion, const EdgeCircle& circle) {
  const auto f = RackTrochoid(motion, circle).cusp_polynomial();
  const double end = std::sin(circle.end_tau.rad());
  const bool convex = circle.q > 0.0;
  const std::vector<double> sines =
      convex ? polynomial_roots(f, 0.0, end) : polynomial_roots(f, end, 1.0);
  if (sines.empty()) return std::nullopt;
  return Angle::radians(std::asin(convex ? sines.back() : sines.front()));
}

Result<Gear> make_arc_gear(const CylindricalSpec& spec, const Result<RackOfArcs>& rack) {
  if (auto error = check_spec(spec)) return *error;
  if (!rack) return rack.error();
  auto edge = make_edge(*rack, spec.normal_module, spec.thickness_allowance);
  if (!edge) return edge.error();

  Gear gear{};
  gear.spec = spec;
  const double m = spec.normal_module;
  const double beta = spec.helix_angle.rad();
  gear.transverse_module = m / std::cos(beta);
  gear.reference_diameter = gear.transverse_module * spec.teeth;
  const double d = gear.reference_diameter;
  const RackMotion motion{d / 2, std::cos(beta), 0.0};
  ArcTeeth flanks{*rack, std::nullopt, Angle(), std::nullopt};
  if (const auto half = half_thickness_on_datum(*rack))
    flanks.reference_thickness = 2 * *half * m + spec.thickness_allowance;
  gear.flanks = std::move(flanks);
  look_for_undercut(gear, motion, *edge);
  gear.tip_diameter = spec.tip_diameter.value_or(d + 2 * m * rack->addendum);
  gear.root_diameter = d - 2 * m * rack->dedendum;
  gear.lead = beta == 0.0 ? 0.0 : std::numbers::pi * d / std::tan(beta);
  gear.pointed_diameter = pointed_diameter(motion, *edge);
  auto tooth = cut_by_rack(*edge, motion, spec.teeth, gear.tip_diameter / 2);
  if (!tooth) return tooth.error();
  gear.tooth = std::move(tooth).take();
  finish(gear);
  return gear;
}

}  // namespace gearwright::detail
