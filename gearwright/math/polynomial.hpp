// All real roots of a polynomial on an interval, separated exactly by the roots of its derivative.
#pragma once

#include <span>
#include <vector>

namespace gearwright {

/// Σ c_i x^i.
double evaluate_polynomial(std::span<const double> c, double x);

/// The roots of Σ c_i x^i in [lo, hi] at which it changes sign, in ascending order.
///
/// A polynomial is monotone between two neighbouring roots of its derivative, so each piece
/// contains at most one root. The recursion ends at degree 1. Nothing is sampled.
///
/// Accuracy  each root is bisected until its bracket is two neighbouring doubles
/// Domain    lo ≤ hi, finite coefficients (contract)
std::vector<double> polynomial_roots(std::span<const double> c, double lo, double hi);

}  // namespace gearwright
