// The search of touching_screws.hpp, which contains the notation. It computes section by section
// when flank 2 passes the points of flank 1. It uses the tip and base cylinders of both gears and
// no tangency.
#pragma once

#include <array>
#include <cmath>
#include <limits>

#include "tests/oracle/screw_tangency.hpp"

namespace gearwright::oracle {

inline constexpr double kNone = -std::numeric_limits<double>::infinity();  ///< no point there

/// One flank of gear 1 as seen from gear 2. `value(u, z)` is −σ times the rotation of gear 2 at
/// which its flank passes the point. The greatest value counts, on either side.
class Flank {
 public:
  Flank(const ScrewPair& pair, double rotation_1, int sigma, int tooth);

  double tip_1() const { return tip_1_; }
  double tip_2() const { return tip_2_; }

  /// Equal steps from the lowest string that a tip of gear 2 can reach to the tip of gear 1.
  double node(int i, int steps) const { return low_1_ + (tip_1_ - low_1_) * i / steps; }

  /// String angle on flank 2 of the point (u, z) when flank 2 passes it; 0 below its base circle.
  double mate_roll(double u, double z) const;

  double value(double u, double z) const;

  /// The section of the axis in which the flank can be within `opening` of the direction of axis 2.
  std::array<double, 2> sections_within(double opening, double reach) const;

 private:
  /// The point (u, z) of flank 1 in the tilted but unturned frame of gear 2.
  Eigen::Vector3d seen(double u, double z) const;

  const ScrewPair& pair_;
  int sigma_;
  double k_1_, k_2_, start_1_, start_2_, cos_, sin_, low_1_, tip_1_, tip_2_;
};

// Steps of a golden section. On a smooth peak, rounding of the value limits the position to 1e-8 of
// the bracket, 0.618^42 = 2e-9. At a corner, where an edge of gear 2 crosses one of gear 1, the
// value decreases linearly and beyond it there is no point: 0.618^68 = 6e-15.
inline constexpr int kSmooth = 42, kCorner = 68;

struct Peak {
  double value = kNone;
  double at = 0.0;
};

/// Golden section in [low, high] down to 0.618^steps of it. The ends are evaluated too.
template <class F>
Peak climb(F f, double low, double high, int steps) {
  constexpr double kGolden = 0.6180339887498949;
  Peak best;
  const auto look = [&](double x) {
    const double v = f(x);
    if (v > best.value) best = {v, x};
    return v;
  };
  look(low), look(high);
  double a = high - kGolden * (high - low), b = low + kGolden * (high - low);
  double f_a = look(a), f_b = look(b);
  for (int i = 0; i < steps; ++i) {
    if (f_a > f_b) {
      high = b, b = a, f_b = f_a;
      a = high - kGolden * (high - low), f_a = look(a);
    } else {
      low = a, a = b, f_a = f_b;
      b = low + kGolden * (high - low), f_b = look(b);
    }
  }
  return best;
}

/// The part of these sections in which the cylinders of gear 2 contain a point of the flank, to
/// 1/200 of their range. A smaller overlap, at a corner of two tips, is missed.
std::array<double, 2> overlap(const Flank& flank, std::array<double, 2> range);

/// The greatest value in one section of gear 1, and the u where it is.
Peak best_in_section(const Flank& flank, double z);

}  // namespace gearwright::oracle
