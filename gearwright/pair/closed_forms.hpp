// Closed forms for columns of numbers, computed with the processor's vector instructions. The
// Python binding calls these functions for arrays.
//
//   y    given value of inv α        s_β  sin β of gear 1     e    thickness allowance, mm
//                                              theory: docs/theory/02-involute-and-pair.md
//
// If a row lies outside the domain, its result is NaN.
//
//   Laws  (1) the vector and the scalar instance give the same inverse involutes, to the last bit,
//             on any machine
//         (2) the backlashes of both instances agree to 1e-12 modules
#pragma once

#include <array>
#include <cstddef>

namespace gearwright {

/// Computes the angle α that satisfies inv α = y, without iteration.
///
/// Formula   α = c + c³ P(c²) with c = ∛(3y) for y < 1.1, otherwise α = π/2 − s − s³ Q(s²) with s =
///           1/(y + π/2); section 2.1
/// Units     rad; the result is an odd function of y
/// Domain    |y| ≤ 1e12, as inverse_involute()
/// Accuracy  ledger row `inverse_involutes`; at most 6 ulp from inverse_involute()
void inverse_involutes(const double* y, double* alpha, std::size_t n);
void inverse_involutes_scalar(const double* y, double* alpha, std::size_t n);

/// Values that all rows of the input share. The axes are parallel.
struct BacklashConstants {
  double normal_module = 1.0;  ///< m_n  mm, > 0
  double tan_alpha = 0.0;      ///< tan α_n, > 0
};

/// The columns from which backlashes are computed. z2 is < 0 for an internal gear.
struct BacklashColumns {
  enum In { z1, z2, x1, x2, sin_beta, allowance_1, allowance_2, center_distance, kIn };
  std::array<const double*, kIn> in{};
};

/// Computes the normal backlash j_n at a centre distance, mm; < 0 if the teeth overlap.
///
/// Formula   j_n cos α_wn = m_n cos α_n (z1 + z2)(inv α_wt − inv α_0); [T2.24], [T2.16]
/// Domain    whole numbers z1 ≥ 1 and z2 ≠ 0, both of magnitude below 1e6; an internal gear has
///           more teeth than its pinion; a > |r_b1 + r_b2|
/// Accuracy  ledger row `normal_backlashes`
void normal_backlashes(const BacklashConstants& constants, const BacklashColumns& columns,
                       double* backlash, std::size_t n);
void normal_backlashes_scalar(const BacklashConstants& constants, const BacklashColumns& columns,
                              double* backlash, std::size_t n);

}  // namespace gearwright
