#include "gearwright/contact/recut.hpp"

#include <cmath>
#include <numbers>

#include "gearwright/base/overloaded.hpp"
#include "gearwright/generation/generate.hpp"
#include "gearwright/math/involute.hpp"
#include "gearwright/tool/rack_of_arcs.hpp"
#include "gearwright/tool/straight_rack.hpp"

namespace gearwright {

namespace {

// Returns the parameter near `was` at which the curve has the radius ρ. The bracket grows only
// while the radius is monotone, because beyond a cusp the radius changes in the opposite sense. If
// the bracket does not reach ρ, the function returns its last end.
double same_radius(const Curve& curve, double was, double rho, bool grows, double width) {
  const auto radius = [&](double t) { return curve.point(t).norm(); };
  const double more = rho - radius(was);
  if (more == 0.0) return was;
  const double sense = (more > 0.0) == grows ? 1.0 : -1.0;
  double last = was;
  // The first step, relative to the width of the arc. Usual corrections of the lead move the ends
  // by less than a few such steps. Each distance from `was` is twice the previous one, so 19 steps
  // reach a quarter of the width.
  constexpr double kFirstStep = 1e-6;
  for (double step = kFirstStep * width; step < 0.5 * width; step *= 2) {
    const double next = was + sense * step;
    const double before = radius(last);
    const double here = radius(next);
    if ((here > before) != (more > 0.0)) return last;
    if ((rho - here) * more <= 0.0)
      return more > 0.0 ? curve.parameter_at_radius(rho, last, next)
                        : curve.parameter_at_radius(rho, next, last);
    last = next;
  }
  return last;
}

double changed_cos_beta(const Gear& gear, double delta_lambda) {
  const double r = gear.reference_diameter / 2;
  return std::sin(std::atan2(1.0, r * std::abs(gear.twist())) + delta_lambda);
}

// Returns the cutting edge of the gear's rack. The edge exists, because it has cut the gear.
CutterEdge edge_of(const CylindricalSpec& spec) {
  return std::visit(
      Overloaded{[&](const StraightRack& rack) {
                   return make_edge(rack, spec.normal_module, spec.normal_pressure_angle)->edge;
                 },
                 [&](const auto& rack) {
                   return *make_edge(*arcs_of(rack), spec.normal_module, spec.thickness_allowance);
                 }},
      spec.rack);
}

}  // namespace

double with_cutter_lead(double twist, double pitch_radius, double delta_lambda) {
  if (delta_lambda == 0.0) return twist;
  GW_EXPECTS(twist != 0.0);
  // The twist is 1/(r tan λ) for the pitch radius r. If λ exceeds 90°, the helix changes its hand.
  const double lambda = std::atan2(1.0, pitch_radius * std::abs(twist)) + delta_lambda;
  GW_EXPECTS(lambda > 0.0 && lambda < std::numbers::pi);
  return std::copysign(1.0, twist) / (pitch_radius * std::tan(lambda));
}

Arc recut(const Arc& arc, const Gear& gear, double delta_lambda) {
  if (delta_lambda == 0.0) return arc;
  const double r = gear.reference_diameter / 2;
  const double cos_beta = changed_cos_beta(gear, delta_lambda);
  Arc changed = arc;
  if (const auto* cut = curve_if<RackTrochoid>(*arc.curve)) {
    RackMotion motion = cut->motion();
    EdgeCircle circle = cut->circle();
    circle.center.x() -= motion.shift;
    motion.cos_beta = cos_beta;
    changed.curve = std::make_shared<RackTrochoid>(motion, circle);
  } else {
    const ReferenceGeometry<double>& ref = gear.reference();
    GW_EXPECTS(curve_if<Involute>(*arc.curve) != nullptr);
    const double alpha_n = gear.spec.normal_pressure_angle.rad();
    const double alpha_t = std::atan(std::tan(alpha_n) / cos_beta);
    const double half = ref.reference_tooth_thickness_normal / cos_beta / (2 * r);
    const double side = gear.side();
    changed.curve =
        std::make_shared<Involute>(r * std::cos(alpha_t), half + side * involute(alpha_t));
  }
  const bool grows = (arc.end_point.norm() > arc.begin_point.norm()) == (arc.end > arc.begin);
  const double width = std::abs(arc.end - arc.begin);
  changed.begin = same_radius(*changed.curve, arc.begin, arc.begin_point.norm(), grows, width);
  changed.end = same_radius(*changed.curve, arc.end, arc.end_point.norm(), grows, width);
  changed.begin_point = changed.curve->point(changed.begin);
  changed.end_point = changed.curve->point(changed.end);
  return changed;
}

std::optional<Outline> recut_outline(const Gear& gear, double delta_lambda) {
  const CylindricalSpec& spec = gear.spec;
  if (gear.cut_by || spec.root_fillet || spec.tip_fillet) return std::nullopt;
  if (delta_lambda == 0.0) return gear.tooth->outline;
  const double m = spec.normal_module;
  const double shift = gear.involute() ? gear.reference().generating_profile_shift * m : 0.0;
  const RackMotion motion{gear.reference_diameter / 2, changed_cos_beta(gear, delta_lambda), shift};
  const auto tooth = cut_by_rack(edge_of(spec), motion, spec.teeth, gear.tip_diameter / 2);
  if (!tooth || tooth->outline.arcs.empty() || !tooth->form_radius) return std::nullopt;
  return tooth->outline;
}

}  // namespace gearwright
