// The contact search of touch.hpp for many positions at once, one in each lane of a vector. The
// search applies to involute flanks whose modifications are polynomials of roll angle and height.
//
//   N   |W|², square of the radius of a point on gear 2, mm²
//                                    theory: docs/theory/08-contact.md, [T8.9]
//
// Every lane does the Newton steps of TouchSearch with the active bounds of its previous step. If
// these bounds do not give a valid step, solve_step() chooses other bounds for this lane. If a lane
// does not converge, its touch counts as not found, and the caller searches this position again.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "gearwright/contact/transmission.hpp"

namespace gearwright::detail {

/// The input columns of a step. They contain constants of the flanks and of the mounting, and the
/// state of the search. The angle of each flank (B1, B2 of touch_lanes.inc) is the polynomial b_0 +
/// b_1 (ξ − ξ_mid) + b_2 (ξ − ξ_mid)² + q_1 z + q_2 z².
// clang-format off
enum class LaneIn : std::size_t {
  r1, c1, s_mid, s_half, z_mid, z_half, b1_0, b1_1, b1_2, q1_1, q1_2,
  over_r2, c2, sign2, xi_mid, b2_0, b2_1, b2_2, q2_1, q2_2,
  m00, m01, m02, m10, m11, m12, m20, m21, m22, shift_x, shift_y, shift_z,
  n_lo, over_n, Z_lo, over_Z, over_s, over_z, rotation_sign, ratio,
  s, z, kind_a, sign_a, kind_b, sign_b, mu_a, mu_b, count
};
enum class LaneOut : std::size_t {
  holds, last, astray, s, z, mu_a, mu_b, te, slope, arm, flat, by_n,
  sigma, zeta, g_s, g_z, h_ss, h_sz, h_zz, n, n_s, n_z, Z, Z_s, Z_z, count
};
// clang-format on
constexpr auto kLaneIn = static_cast<std::size_t>(LaneIn::count);
constexpr auto kLaneOut = static_cast<std::size_t>(LaneOut::count);
constexpr std::size_t kLaneBlock = 8;  ///< positions in a block, for any width of the vectors

struct LaneBlock {
  std::array<std::array<double, kLaneBlock>, kLaneIn> in{};
  std::array<std::array<double, kLaneBlock>, kLaneOut> out{};
};

/// Does one step at all positions of a block.
///
/// Laws      touch_step() and touch_step_scalar() return the same bits
void touch_step(LaneBlock& block);
void touch_step_scalar(LaneBlock& block);

class LaneSearch {
 public:
  /// Returns none if gear 2 is a rack or if a flank is not an involute. Also returns none if its
  /// modifications are not polynomials of second degree.
  static std::optional<LaneSearch> of(const Transmission& transmission);

  /// Searches for touches of tooth pair 0. Each search starts at `touch.s` and `touch.z`. If the
  /// start is a touch, its active bounds are tried first, and otherwise those of the touch found
  /// last. If no touch is found, `fields` is set to −1.
  void solve(std::vector<PairTouch>& touches) const;

 private:
  std::vector<std::array<double, kLaneIn>> fields_;  // for each pair of patches, at rotation 0
  std::vector<std::array<double, 2>> widths_;        // s_mid and the width in u of flank 2
  double turn1_ = 0.0, turn2_ = 0.0;                 // change of B1 and B2 per rad of φ1
};

}  // namespace gearwright::detail
