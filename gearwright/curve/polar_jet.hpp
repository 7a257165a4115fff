// A point of a plane curve in polar coordinates about the gear axis, with derivatives.
//
//   W(t)   point ρ e^{iθ}, mm          ℓ = log W = u + iθ,  u = ln ρ
//   ℓ′, ℓ″ derivatives by the parameter t of the curve
//                                                          theory: docs/theory/08-contact.md, [T8.4]
#pragma once

#include <complex>

namespace gearwright {

using Complex = std::complex<double>;

/// The product of two complex numbers without the library's treatment of infinities, which is slow.
inline Complex times(const Complex& a, const Complex& b) {
  return {a.real() * b.real() - a.imag() * b.imag(), a.real() * b.imag() + a.imag() * b.real()};
}

/// A point W = factor · e^{i phase} of a curve. Factor and phase are stored separately, so that the
/// phases of flank, lead and rotation can be added before sine and cosine are computed.
struct PolarJet {
  Complex factor;  ///< mm
  double phase;    ///< rad
  Complex d1, d2;  ///< ℓ′, ℓ″ by t

  /// The jet of the curve itself for side = 1, or of its mirror image about the x axis for side = −1.
  PolarJet on_side(double side) const {
    const auto turned = [side](const Complex& w) { return Complex{w.real(), side * w.imag()}; };
    return {turned(factor), side * phase, turned(d1), turned(d2)};
  }
};

}  // namespace gearwright
