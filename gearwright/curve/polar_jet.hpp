// A plane curve about the gear axis as one complex number, with its derivatives.
//
//   W(t)   point ρ e^{iθ}, mm          ℓ = log W = u + iθ,  u = ln ρ
//   ℓ′, ℓ″ derivatives by the curve's own parameter t
//                                                          theory: docs/theory/08-contact.md, [T8.4]
#pragma once

#include <complex>

namespace gearwright {

using Complex = std::complex<double>;

/// A product without the library's treatment of infinities, which costs a branch.
inline Complex times(const Complex& a, const Complex& b) {
  return {a.real() * b.real() - a.imag() * b.imag(), a.real() * b.imag() + a.imag() * b.real()};
}

/// The curve at a parameter: W = factor · e^{i phase}. The two are kept apart, so that the phases
/// of a flank, its lead and its rotation need one sine and cosine together.
struct PolarJet {
  Complex factor;  ///< mm:  W = factor · e^{i phase}
  double phase;    ///< rad
  Complex d1, d2;  ///< ℓ′, ℓ″ by t

  /// The curve itself for the side 1, its mirror image about the x axis for −1.
  PolarJet on_side(double side) const {
    const auto turned = [side](const Complex& w) { return Complex{w.real(), side * w.imag()}; };
    return {turned(factor), side * phase, turned(d1), turned(d2)};
  }
};

}  // namespace gearwright
