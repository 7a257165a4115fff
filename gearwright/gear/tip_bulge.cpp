#include "gearwright/gear/tip_bulge.hpp"

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <limits>

#include "gearwright/base/contract.hpp"

namespace gearwright {

namespace {

constexpr double kNoise = 1e-9;  // modules
constexpr int kHalfDigits = std::numeric_limits<double>::digits / 2;

double beyond_involute(const Gear& gear, const Vec2& p) {
  const double r_b = gear.base_radius();
  const double rho = std::max(r_b, p.norm());
  const double involute =
      tooth_thickness_transverse(gear.spec.teeth, 2 * r_b, gear.reference().base_tooth_thickness,
                                 2 * rho) /
      (2 * rho);
  return r_b * (std::atan2(p.y(), p.x()) - involute);
}

double greatest(const Gear& gear, const Arc& arc) {
  constexpr int kSteps = 16;
  const auto less = [&](double u) { return -beyond_involute(gear, arc.point(u)); };
  int best = 0;
  double least = less(0.0);
  for (int i = 1; i <= kSteps; ++i) {
    const double d = less(static_cast<double>(i) / kSteps);
    if (d >= least) continue;
    least = d;
    best = i;
  }
  const double lo = std::max(0, best - 1) / static_cast<double>(kSteps);
  const double hi = std::min(kSteps, best + 1) / static_cast<double>(kSteps);
  return -std::min(least, boost::math::tools::brent_find_minima(less, lo, hi, kHalfDigits).second);
}

}  // namespace

std::optional<TipBulge> tip_bulge(const Gear& gear) {
  GW_EXPECTS(gear.involute() && gear.exists());
  if (!gear.tooth || !gear.tooth->form_radius) return std::nullopt;
  double most = kNoise * gear.spec.normal_module;
  bool any = false;
  bool past_the_flank = false;
  for (const Arc& arc : gear.tooth->outline.arcs) {
    if (arc.name == ArcName::flank) {
      past_the_flank = true;
    } else if (past_the_flank && arc.name == ArcName::tip_fillet) {
      const double d = greatest(gear, arc);
      any = any || d > most;
      most = std::max(most, d);
    }
  }
  if (!any) return std::nullopt;
  return TipBulge{most, 2 * gear.tip_form_radius()};
}

}  // namespace gearwright
