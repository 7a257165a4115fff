#include "gearwright/design/trial_gear.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "gearwright/base/contract.hpp"
#include "gearwright/base/numbers.hpp"
#include "gearwright/design/intervals.hpp"
#include "gearwright/gear/leaf_formulas.hpp"
#include "gearwright/gear/reference.hpp"
#include "gearwright/math/involute.hpp"
#include "gearwright/math/root.hpp"

namespace gearwright {

double tip_thickness(const TrialGear& gear, double x, double k) {
  const double base = 2.0 * std::abs(gear.r_b);
  const double d_a = 2.0 * std::abs(leaf::tip_radius(gear.r, gear.addendum, x, k));
  const double half = gear.reference_half_angle + x * gear.half_angle_per_shift;
  const double s_at =
      tooth_thickness_transverse(gear.teeth, base, base * half, std::max(d_a, base));
  return s_at / leaf::helix_secant(base, gear.tan_base_helix, d_a);
}

namespace {

// Returns the shift at which the tip lies on the base circle, which is the smallest possible shift
// of an external gear and the greatest possible shift of an internal gear.
double shift_of_base_circle(const TrialGear& g, double k) {
  const double x = g.r_b - g.r - g.addendum - k;
  // The tip thickness is evaluated at this shift. The shift is moved by the rounding error, so that
  // the tip is certainly outside the base circle.
  const double ulp = 4.0 * std::numeric_limits<double>::epsilon() * (std::abs(g.r) + 2.0);
  return x + side_of(g.teeth) * ulp;
}

struct Shifts {
  double min, max;
  bool as_a_rule = false;  // true in the usual case: the tip is thick enough at x = 0 and too thin
                           // at a great x
};
// Returns the interval of shifts for which the tip is thick enough. If there are several intervals,
// the function returns the last one.
Shifts thick_enough(const TrialGear& g, double k) {
  const double edge = shift_of_base_circle(g, k);
  // The range of the search. Beyond x = |z|, all tips of external gears are pointed. For an
  // internal gear, the lower limit of x is arbitrary.
  const double far = farthest_shift(g.teeth);
  const double lo = g.teeth > 0 ? edge : -far;
  const double hi = g.teeth > 0 ? edge + far : edge;
  const auto margin = [&](double x) { return tip_thickness(g, x, k) - g.min_tip_thickness; };
  bool as_a_rule = false;
  if (g.teeth > 0) {
    const double start = std::max(edge, 0.0);
    as_a_rule = margin(start) >= 0.0 && margin(hi) < 0.0;
    // If the gear has more than about a hundred teeth, even a tip on the base circle, at the shift
    // `edge`, may be too thin. The general search below then finds the interval.
    if (as_a_rule && margin(edge) >= 0.0) return {edge, find_root(margin, start, hi).x, true};
  }
  const auto pieces = where_not_negative(margin, lo, hi, 64);
  if (pieces.empty()) return {lo, -std::numeric_limits<double>::infinity()};
  return {pieces.back().lo, pieces.back().hi, as_a_rule};
}

// Returns s_an and its derivative with respect to x. The tip of an external gear must lie outside
// the base circle. [T9.3]
Slope<double> tip_thickness_and_slope(const TrialGear& g, double x, double k) {
  const double u = leaf::tip_radius(g.r, g.addendum, x, k);
  const double roll = leaf::curvature_at(u, g.r_b) / g.r_b;  // tan α_a
  const double half = g.reference_half_angle + x * g.half_angle_per_shift;
  const double t = g.tan_base_helix / g.r_b;
  const double secant = std::sqrt(1.0 + t * t * u * u);
  const double angle = half - involute_of_roll(roll);
  const double thickness = 2.0 * u * angle / secant;
  const double slope = (2.0 * angle + 2.0 * u * g.half_angle_per_shift - 2.0 * roll) / secant -
                       thickness * t * t * u / (secant * secant);
  return {thickness, slope};
}

// Returns the upper end of thick_enough() for k < 0. At x = thick_until − k, the tip radius is that
// of thick_until with k = 0, but the tooth is thicker. The end is slightly greater than this x.
double thick_until_with(const TrialGear& g, double k) {
  const auto margin = [&](double x) {
    Slope<double> s = tip_thickness_and_slope(g, x, k);
    s.value -= g.min_tip_thickness;
    return s;
  };
  const double lo = *g.thick_until - k;
  const double hi = lo + farthest_shift(g.teeth);
  return newton_in_bracket<double>(margin, lo, hi, lo, false).x;
}

}  // namespace

double least_max_shift(const SearchProblem& problem, const TrialGear& gear, double k) {
  if (k == 0.0) return gear.x_max;
  const double ceiling = problem.limits.max_shift.value_or(std::numeric_limits<double>::infinity());
  return k < 0.0 && gear.thick_until ? std::min(ceiling, *gear.thick_until - k)
                                     : -std::numeric_limits<double>::infinity();
}

double max_shift(const SearchProblem& problem, const TrialGear& gear, double k) {
  if (k == 0.0) return gear.x_max;
  const double ceiling = problem.limits.max_shift.value_or(std::numeric_limits<double>::infinity());
  return std::min(
      ceiling, k < 0.0 && gear.thick_until ? thick_until_with(gear, k) : thick_enough(gear, k).max);
}

TrialGear trial_gear(const SearchProblem& problem, int teeth, Angle helix, int rack, int which) {
  const SearchRacks& racks = problem.racks[static_cast<std::size_t>(rack)];
  const auto i = static_cast<std::size_t>(which);
  const auto reference = reference_geometry(ReferenceInput<double>{
      teeth, 1.0, problem.normal_pressure_angle.rad(), std::abs(helix.rad()), 0.0, 0.0});
  TrialGear g;
  g.teeth = teeth;
  const double sign = side_of(teeth);
  g.r = sign * reference.reference_diameter / 2.0;
  g.r_b = sign * reference.base_diameter / 2.0;
  g.addendum = racks.rack[i].addendum;
  g.dedendum = racks.rack[i].dedendum;
  g.edge_depth = racks.undercut_depth[i];
  g.flank_depth = racks.flank_depth[i];
  g.sin_transverse = std::sin(reference.transverse_pressure_angle);
  g.cos_base_helix = std::cos(reference.base_helix_angle);
  g.tan_base_helix = std::tan(reference.base_helix_angle);
  g.min_tip_thickness = problem.limits.tip_thickness;
  g.reference_half_angle = reference.base_tooth_thickness / reference.base_diameter;
  g.half_angle_per_shift = 2.0 * std::tan(problem.normal_pressure_angle.rad()) / std::abs(teeth);

  const SearchLimits& limits = problem.limits;
  const Shifts thick = thick_enough(g, 0.0);
  g.x_min = thick.min;
  g.x_max = thick.max;
  if (thick.as_a_rule) g.thick_until = thick.max;
  if (teeth > 0) {
    const double undercut =
        leaf::undercut_limit<double>(g.edge_depth, teeth, g.sin_transverse, std::cos(helix.rad())) +
        limits.undercut_margin;
    g.x_min = std::max(g.x_min, undercut);
  }
  if (limits.min_shift) g.x_min = std::max(g.x_min, *limits.min_shift);
  if (limits.max_shift) g.x_max = std::min(g.x_max, *limits.max_shift);
  return g;
}

TrialGears::TrialGears(const SearchProblem& problem, int least, int greatest, Angle helix, int rack,
                       int which)
    : min_teeth_(least) {
  GW_EXPECTS(least <= greatest);
  gears_.reserve(static_cast<std::size_t>(greatest - least + 1));
  for (int z = least; z <= greatest; ++z)
    gears_.push_back(z == 0 ? TrialGear{} : trial_gear(problem, z, helix, rack, which));
}

const TrialGear& TrialGears::operator[](int teeth) const {
  GW_EXPECTS(teeth >= min_teeth_ && teeth - min_teeth_ < static_cast<int>(gears_.size()));
  return gears_[static_cast<std::size_t>(teeth - min_teeth_)];
}

}  // namespace gearwright
