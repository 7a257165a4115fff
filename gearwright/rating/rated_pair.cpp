#include "gearwright/rating/rated_pair.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>

#include "gearwright/gear/gear.hpp"

namespace gearwright {

namespace {

// Returns the tool that determines the root of a gear. If an internal gear has no given cutter,
// gear/pinion_cut.hpp has chosen a default cutter, which has no profile shift. The smaller of the
// roundings of this cutter and of the gear's rack is used. For a given cutter, the profile shift is
// computed from the generating centre distance, and the tip rounding is the rounding of the
// cutter's tip corners.
RootTool root_tool(const Gear& gear) {
  const StraightRack& rack = gear.spec.straight_rack();
  RootTool tool;
  tool.addendum = rack.addendum;
  tool.dedendum = rack.dedendum;
  tool.fillet =
      std::min(rack.root_fillet_radius, full_radius(rack, gear.spec.normal_pressure_angle));
  tool.protuberance = rack.protuberance;
  if (!gear.cut_by) return tool;
  // The dedendum is computed from the root diameter. The profile shift x_0 of the cutter is
  // computed with  inv α_0 = inv α_t + 2 (x + x_0) tan α_n/(z + z_0)  from the generating
  // centre distance.
  const ReferenceGeometry<double>& r = gear.reference();
  const double m = gear.spec.normal_module;
  tool.dedendum = gear.side() * (r.reference_diameter - gear.root_diameter) / (2 * m) +
                  r.generating_profile_shift;
  tool.cutter_teeth = gear.cut_by->cutter_teeth;
  // The default cutter has this dedendum and no profile shift. Its rounding may be smaller than that
  // of the rack.
  if (gear.cut_by->by_default) {
    tool.fillet = std::min(tool.fillet, gear.cut_by->tip_rounding / m);
    return tool;
  }
  StraightRack reach;  // a rack with this dedendum, whose full radius limits the rounding
  reach.dedendum = tool.dedendum;
  tool.fillet = std::min(gear.cut_by->tip_rounding / m,
                         std::max(0.0, full_radius(reach, gear.spec.normal_pressure_angle)));
  tool.protuberance = 0.0;
  const double sum = gear.spec.teeth + tool.cutter_teeth;
  const double alpha_t = r.transverse_pressure_angle;
  const double alpha_0 = std::acos(std::min(
      1.0, r.transverse_module * std::abs(sum) / 2 * std::cos(alpha_t) / gear.cut_by->distance));
  tool.cutter_shift = (involute(alpha_0) - involute(alpha_t)) * sum /
                          (2 * std::tan(gear.spec.normal_pressure_angle.rad())) -
                      r.generating_profile_shift;
  return tool;
}

RatedGear rated_gear(const Gear& gear, double beta, double beta_b) {
  const ReferenceGeometry<double>& reference = gear.reference();
  RatedGear g;
  g.teeth = gear.spec.teeth;
  g.reference_diameter = reference.reference_diameter;
  g.base_diameter = reference.base_diameter;
  g.tip_form_diameter = 2 * gear.tip_form_radius();
  g.tip_diameter = g.tip_form_diameter;
  g.root_diameter = gear.root_diameter;
  g.tooth_height = std::abs(gear.tip_diameter - gear.root_diameter) / 2;
  g.profile_shift = gear.spec.profile_shift;
  g.generating_shift = reference.generating_profile_shift;
  g.virtual_teeth = virtual_teeth(g.teeth, beta, beta_b);
  g.face_width = gear.spec.face_width;
  if (const auto bore = body_bore(gear)) g.bore = bore->diameter;
  g.tool = root_tool(gear);
  return g;
}

Result<RatedPair> rated(const ArcPair&) {
  return Error{gear_field(1, "rack"), "",
               "cuts circular arcs, but ISO 6336 rates involute gears only"};
}

Result<RatedPair> rated(const CrossedPair&) {
  return Error{"pair.shaft_angle", "",
               "ISO 6336 rates gears on parallel axes only, and these axes cross"};
}

Result<RatedPair> rated(const ParallelPair& pair) {
  const Mesh<double>& mesh = pair.mesh;
  if (!pair.flanks_meet() || !(mesh.true_ratio > 0.0)) {
    return Error{"pair.center_distance", "",
                 "the flanks do not touch, so they carry no load; a smaller centre distance, "
                 "greater tip diameters or, with undercut, a greater profile shift would help"};
  }
  RatedPair r;
  const Gear& first = pair.gears[0];
  const Gear& second = pair.gears[1];
  r.exchanged = std::abs(second.spec.teeth) < first.spec.teeth;
  r.normal_module = first.spec.normal_module;
  r.alpha_n = first.spec.normal_pressure_angle.rad();
  r.beta = std::abs(first.spec.helix_angle.rad());
  r.alpha_t = first.reference().transverse_pressure_angle;
  r.beta_b = std::abs(first.reference().base_helix_angle);
  r.center_distance = pair.center_distance;
  const double sum = second.base_radius() + second.side() * first.base_radius();
  r.alpha_wt = std::acos(std::min(1.0, sum / pair.center_distance));
  for (std::size_t i = 0; i < 2; ++i)
    r.gears[i] = rated_gear(pair.gears[r.exchanged ? 1 - i : i], r.beta, r.beta_b);
  // The tip of a gear has no contact where the mating gear has no usable flank. [T2.19]
  if (mesh.rho1_true_end < mesh.rho1_E)
    r.gears[r.place(1)].tip_diameter = 2 * std::hypot(first.base_radius(), mesh.rho1_true_end);
  if (mesh.rho1_true_begin > mesh.rho1_A)
    r.gears[r.place(2)].tip_diameter =
        2 * std::hypot(second.base_radius(), mesh.rho2(mesh.rho1_true_begin));
  r.u = static_cast<double>(r.gears[1].teeth) / r.gears[0].teeth;
  r.face_width = std::min(first.spec.face_width, second.spec.face_width);
  r.epsilon_alpha = mesh.true_ratio;
  r.epsilon_beta = r.face_width * std::sin(r.beta) / (std::numbers::pi * r.normal_module);
  return r;
}

}  // namespace

double virtual_teeth(int teeth, double beta, double beta_b) {
  const double c = std::cos(beta_b);
  return teeth / (c * c * std::cos(beta));
}

double RatedPair::epsilon_alpha_n() const {
  const double c = std::cos(beta_b);
  return epsilon_alpha / (c * c);
}

Result<RatedPair> rated_pair(const Pair& pair) {
  return pair.visit([](const auto& p) { return rated(p); });
}

FlankTolerances tolerance_edition(RatingEdition edition) {
  return edition == RatingEdition::iso_2006 ? FlankTolerances::iso_1995 : FlankTolerances::iso_2013;
}

Tolerances tolerances(RatingEdition edition, int grade, const RatedGear& gear, double normal_module,
                      double alpha_t) {
  // None of these tolerances depends on the helix angle, so the helix angle is set to 0 here.
  const ToleranceSubject subject{gear.reference_diameter, normal_module, gear.face_width,
                                 std::abs(gear.teeth),    0.0,           alpha_t};
  const FlankToleranceValues t = flank_tolerances(tolerance_edition(edition), grade, subject);
  return {t.single_pitch, *t.base_pitch, t.profile_form, t.helix_slope};
}

}  // namespace gearwright
