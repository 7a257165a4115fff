// The search of touching_screws.hpp, where the notation is explained. Section by section, it
// computes the rotation at which flank 2 passes the points of flank 1. It uses the tip and base
// cylinders of both gears but no tangency.
#pragma once

#include <array>
#include <cmath>
#include <limits>

#include "tests/oracle/screw_tangency.hpp"

namespace gearwright::oracle {

inline constexpr double kNone = -std::numeric_limits<double>::infinity();  ///< returned if there is
                                                                           ///< no such point

/// One flank of gear 1 as seen from gear 2. `value(u, z)` is −σ times the rotation of gear 2 at
/// which its flank passes the point. On both sides, the greatest value determines the contact.
class Flank {
 public:
  Flank(const ScrewPair& pair, double rotation_1, int sigma, int tooth);

  double tip_1() const { return tip_1_; }
  double tip_2() const { return tip_2_; }

  /// Equal steps from the lowest string that a tip of gear 2 can reach to the tip of gear 1.
  double node(int i, int steps) const { return low_1_ + (tip_1_ - low_1_) * i / steps; }

  /// String angle on flank 2 of the point (u, z) when flank 2 passes this point; 0 below the base
  /// circle.
  double mate_roll(double u, double z) const;

  double value(double u, double z) const;

  /// The range of z in which the azimuth of the flank can be within `opening` of the direction of
  /// axis 2.
  std::array<double, 2> sections_within(double opening, double reach) const;

 private:
  /// The point (u, z) of flank 1 in the frame of gear 2, which is tilted but not turned.
  Eigen::Vector3d seen(double u, double z) const;

  const ScrewPair& pair_;
  int sigma_;
  double k_1_, k_2_, start_1_, start_2_, cos_, sin_, low_1_, tip_1_, tip_2_;
};

// Number of steps of a golden section. On a smooth peak, rounding of the value limits the position
// to 1e-8 of the bracket, and 0.618^42 = 2e-9. At a corner, where an edge of gear 2 crosses an edge
// of gear 1, the value decreases linearly and there is no point beyond the corner. There 0.618^68 =
// 6e-15 is needed.
inline constexpr int kSmooth = 42, kCorner = 68;

struct Peak {
  double value = kNone;
  double at = 0.0;
};

/// Golden section in [low, high] down to 0.618^steps of the interval. The ends are evaluated too.
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

/// The range of sections in which a point of the flank lies within the cylinders of gear 2, to
/// 1/200 of the range. A smaller overlap, at a corner of two tips, is missed.
std::array<double, 2> overlap(const Flank& flank, std::array<double, 2> range);

/// The greatest value in one section of gear 1, and the u at which it occurs.
Peak best_in_section(const Flank& flank, double z);

}  // namespace gearwright::oracle
