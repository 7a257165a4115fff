// Helix angles and shifts of the pairs whose minimum centre distance lies at a given a and Σ.
//
//   β_w1   the unknown; everything else follows from it in closed form:
//          β_w2 = σ (Σ − β_w1), H, cos α_wn = H m_n cos α_n/(2a), sin β = sin β_w cos α_wn/cos α_n,
//          2 tan α_n Σx = Σ z (inv α_wt − inv α_t)                             [T4.29]…[T4.32]
#pragma once

#include "gearwright/design/fit.hpp"

namespace gearwright {

/// The designs that meet the one given condition: α_wn, a helix angle, or x1 + x2 (0 if absent).
///
/// Domain    a and Σ given, a helix angle absent (contract)
/// Errors    conditions that exclude each other, with their names
Result<Fit> min_distance_designs(const FitProblem& problem);

}  // namespace gearwright
