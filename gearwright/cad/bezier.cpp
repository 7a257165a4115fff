#include "gearwright/cad/bezier.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "gearwright/base/contract.hpp"
#include "gearwright/cad/fitting.hpp"
#include "gearwright/curve/arc_length.hpp"

namespace gearwright {
namespace {

constexpr int kLooks = 16;
constexpr int kVerify = 64;

// The exact curve as a function of x, its relative arc length.
class ByLength {
 public:
  explicit ByLength(const Arc& arc) : arc_(arc), by_length_(*arc.curve, arc.begin, arc.end) {}

  CurvePoint at(double x) const {
    const double t = by_length_.parameter(x * by_length_.length());
    CurvePoint w = arc_.at((t - arc_.begin) / (arc_.end - arc_.begin));
    if (x == 0.0) w.point = arc_.begin_point;
    if (x == 1.0) w.point = arc_.end_point;
    return w;
  }
  double length() const { return by_length_.length(); }

 private:
  const Arc& arc_;
  ArcLength by_length_;
};

using Cubic = std::array<Vec2, 4>;

Cubic cubic_between(const ByLength& curve, double x0, double x1) {
  const CurvePoint a = curve.at(x0);
  const CurvePoint b = curve.at(x1);
  const auto handle = [&](const CurvePoint& w) {
    const double third = (x1 - x0) * curve.length() / 3.0;
    return Vec2(third * std::cos(w.tangent_angle), third * std::sin(w.tangent_angle));
  };
  return {a.point, a.point + handle(a), b.point - handle(b), b.point};
}

double deviation(const ByLength& curve, const Cubic& c, double x0, double x1, int looks) {
  double worst = 0.0;
  for (int k = 0; k < looks; ++k) {
    const double v = (k + 0.5) / looks;
    const double w = 1.0 - v;
    const Vec2 p =
        w * w * w * c[0] + 3 * v * w * w * c[1] + 3 * v * v * w * c[2] + v * v * v * c[3];
    worst = std::max(worst, osculating_distance(curve.at(x0 + (x1 - x0) * v), p));
  }
  return worst;
}

BezierChain chain_of(const Arc& arc, const ByLength& curve, double tolerance) {
  constexpr StepLimits kLimits{1.0 / 4096, 1.0 / 64};
  BezierChain chain{{arc.begin_point}, 0.0};
  double x0 = 0.0;
  double step = 1.0;
  while (x0 < 1.0) {
    const double x1 = longest_step(x0, 1.0, step, kLimits, [&](double x) {
      return deviation(curve, cubic_between(curve, x0, x), x0, x, kLooks) <= tolerance;
    });
    const Cubic cubic = cubic_between(curve, x0, x1);
    chain.points.insert(chain.points.end(), cubic.begin() + 1, cubic.end());
    chain.deviation_mm = std::max(chain.deviation_mm, deviation(curve, cubic, x0, x1, kVerify));
    step = x1 - x0;
    x0 = x1;
  }
  return chain;
}

}  // namespace

BezierChain fit_beziers(const Arc& arc, double tolerance_mm) {
  GW_EXPECTS(tolerance_mm > 0.0);
  // If the error has one hump, 16 samples locate its maximum to 1 %. The final verification covers
  // all other cases.
  const ByLength curve(arc);
  BezierChain chain = chain_of(arc, curve, 0.98 * tolerance_mm);
  if (chain.deviation_mm > tolerance_mm && chain.deviation_mm < 2.0 * tolerance_mm) {
    chain = chain_of(arc, curve, 0.5 * tolerance_mm);
  }
  return chain;
}

}  // namespace gearwright
