// Computes those objectives of a search that follow from the other values of a design: the balance
// of the safety factors, the relative cost, and an estimate of the noise.
//
//   R_H, R_F   load reserves of flank and root: (S_H/S_Hmin)², S_F/S_Fmin
//   δ          mean deflection of the teeth along the line of action, µm
//   λ          length of the contact lines (pair/contact_lines.hpp)
//                                              theory: docs/theory/09-design-search.md, 9.8
#pragma once

#include <optional>

#include "gearwright/design/design_row.hpp"
#include "gearwright/rating/rating.hpp"

namespace gearwright {

/// The greatest load reserve divided by the least one, ≥ 1. There are three reserves: one for both
/// flanks, one for root 1 and one for root 2.
///
/// The stress at the root is proportional to the load. The pressure on the flanks grows only with
/// the square root of the load, so S_H is squared. The contact stresses of the two gears differ
/// only by the single pair contact factors Z_B and Z_D, so a profile shift changes the ratio of
/// their S_H only a little. Therefore, only the weaker flank counts. If a required safety factor is
/// not given, 1 is used. The result is absent if the row has no safety factors.
///
/// Formula   max(R_H, R_F1, R_F2)/min(R_H, R_F1, R_F2), R_H = min(R_H1, R_H2); [T9.17]
std::optional<double> load_balance(const SearchProblem& problem, const DesignRow& row);

/// Returns the relative cost, kg: the mass times a factor that grows with the face width. The cost
/// is suitable only for ranking designs of the same kind. The exponent e is an input, because no
/// published relation between face width and price was found.
///
/// Formula   m (b/d_1)^e; [T9.18]
double relative_cost(const SearchProblem& problem, const DesignRow& row);

/// Returns the mean deflection of the teeth under the rated torque, without application factor. The
/// result is absent if the rating has no mesh stiffness.
///
/// Formula   F_t/(b c_γα cos α_t), c_γα of ISO 6336-1, clause 9, method B
std::optional<double> mean_deflection(const RatedPair& pair, const Rating& rating);

/// Returns the peak-to-peak variation of the deflection, µm. If every mm of contact line has the
/// same stiffness, this variation is the transmission error of perfect teeth under load. The result
/// is absent if `deflection` is absent, or if the teeth lose contact.
///
/// Formula   δ_pp = δ ε_α (1/λ_min − 1/λ_max); [T9.16]
std::optional<double> noise_of(const DesignRow& row, const std::optional<double>& deflection);

}  // namespace gearwright
