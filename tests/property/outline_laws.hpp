// The laws of a finished half tooth (generation/outline.hpp). Each function returns a sentence that
// describes a violation, or an empty text if the law holds.
//
//   ρ, θ   polar coordinates of an outline point; tooth 0 is centred on θ = 0, the space on π/|z|
//
// From root to tip, ρ never decreases (on an internal gear it never increases). Therefore the half
// angle is a function of ρ, and the outline cannot cross itself.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <numbers>
#include <string>

#include <fmt/format.h>

#include "gearwright/generation/generate.hpp"

namespace gearwright::property {

/// mm: 1e-9 for gears up to a metre in diameter. For larger gears it grows in proportion, because
/// the rounding of doubles does.
inline double tolerance(double scale) { return 1e-9 * std::max(1.0, scale / 500.0); }

/// Returns a sentence about the first law that the tooth violates, or an empty text if all laws
/// hold.
///
/// Units     mm; `scale` is the greater of pitch and tip radius
///
/// Points are differences of lengths as large as the pitch radius, rounded a few times. The error
/// of their radii is therefore up to 8 ε of the pitch radius.
inline std::string broken_law(const GeneratedTooth& tooth, int points_per_arc, double scale) {
  const Outline& outline = tooth.outline;
  const double half_pitch = std::numbers::pi / std::abs(outline.teeth);
  const double side = outline.teeth > 0 ? 1.0 : -1.0;
  constexpr double kRounding = 8 * std::numeric_limits<double>::epsilon();
  if (outline.arcs.empty()) return "no arcs";
  const Vec2* before = nullptr;
  double rho_before = side > 0.0 ? 0.0 : std::numeric_limits<double>::infinity();
  for (std::size_t a = 0; a < outline.arcs.size(); ++a) {
    const Arc& arc = outline.arcs[a];
    const std::string where = fmt::format("arc {} ({})", a, to_string(arc.name));
    if (before && arc.begin_point != *before)
      return where + " does not start where the last one ends";
    before = &arc.end_point;
    if (a > 0 && arc.name < outline.arcs[a - 1].name) return where + " is out of order";
    // The stored ends are points of the curve within the tolerance of the solver.
    for (const auto& [t, p] :
         {std::pair(arc.begin, arc.begin_point), std::pair(arc.end, arc.end_point)}) {
      const double off = (arc.curve->point(t) - p).norm();
      if (!(off <= 1e-10 * scale)) return where + fmt::format(" ends {} mm off its curve", off);
    }
    const std::vector<Vec2> points = sample(arc, points_per_arc);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Vec2& p = points[i];
      const double rho = p.norm();
      double theta = std::atan2(p.y(), p.x());
      // For a single tooth, π may be rounded to the other sign.
      if (theta < 0.0 && p.x() < 0.0) theta += 2 * std::numbers::pi;
      const std::string at = where + fmt::format(" point {}", i);
      if (!(std::isfinite(p.x()) && std::isfinite(p.y()))) return at + " is not finite";
      if (!(side * rho >= side * rho_before - kRounding * scale)) {
        return at + fmt::format(": the radius goes from {} to {}", rho_before, rho);
      }
      rho_before = rho;
      const bool first = a == 0 && i == 0;
      const bool last = a + 1 == outline.arcs.size() && i + 1 == points.size();
      if (first && !(std::abs(theta - half_pitch) <= kRounding)) return at + ": not at π/|z|";
      if (last && !(p.y() == 0.0 && p.x() > 0.0)) return at + ": not on the centre line";
      if (!(theta <= half_pitch + kRounding))
        return at + fmt::format(": θ = {} beyond π/|z|", theta);
      if (!last && !(theta > 0.0)) return at + fmt::format(": half angle {} not positive", theta);
    }
  }
  const double tip = before->norm();
  if (!(std::abs(tip - tooth.tip_radius) <= kRounding * scale))
    return "the outline ends off tip_radius";
  return {};
}

}  // namespace gearwright::property
