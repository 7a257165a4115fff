// Helix angles and shifts of the pairs whose minimum centre distance for the given Σ is the given
// a.
//
//   β_w1   the only unknown; all other values follow in closed form:
//          β_w2 = σ (Σ − β_w1), H, cos α_wn = H m_n cos α_n/(2a), sin β = sin β_w cos α_wn/cos α_n,
//          2 tan α_n Σx = Σ z (inv α_wt − inv α_t)                             [T4.29]…[T4.32]
#pragma once

#include "gearwright/design/fit.hpp"

namespace gearwright {

/// The designs that meet the given condition, which is α_wn, a helix angle, or x1 + x2 (by default
/// 0).
///
/// Domain    a and Σ are given, and at least one helix angle is absent (contract)
/// Errors    names of conditions that exclude each other
Result<Fit> min_distance_designs(const FitProblem& problem);

}  // namespace gearwright
