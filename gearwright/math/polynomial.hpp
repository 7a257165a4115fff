// Real roots of a polynomial on an interval, all of them,
// isolated exactly by the derivative's roots.
#pragma once

#include <span>
#include <vector>

namespace gearwright {

/// Σ c_i x^i.
double evaluate_polynomial(std::span<const double> c, double x);

/// The roots of Σ c_i x^i in [lo, hi] at which it changes sign, in ascending order.
///
/// Between two neighbouring roots of the derivative a polynomial is monotone, so each piece holds
/// at most one; the recursion ends at degree 1. No sampling.
///
/// Accuracy  each root is bisected until its bracket is two neighbouring doubles
/// Domain    lo ≤ hi, finite coefficients (contract)
std::vector<double> polynomial_roots(std::span<const double> c, double lo, double hi);

}  // namespace gearwright
