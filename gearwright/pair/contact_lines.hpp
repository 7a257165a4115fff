// Computes the total length of the contact lines of a pair on parallel axes, and the variation of
// this length with the rotation.
//
//   ε_α, ε_β   transverse contact ratio, overlap ratio
//   τ          rotation, in pitches
//   λ(τ)       total length of all contact lines divided by b/cos β_b; the mean of λ is ε_α
//                                              theory: docs/theory/09-design-search.md, 9.8
//
// If every mm of contact line has the same stiffness, the deflection of the teeth under a constant
// load is proportional to 1/λ. The variation of this deflection is the transmission error of
// perfect teeth under load. λ does not vary if ε_α is a whole number, or if ε_β is a whole number
// above 0.
#pragma once

#include <optional>

namespace gearwright {

/// Returns λ(τ). At τ = 0, a tooth begins contact at one end of its face. At τ = ε_α + ε_β, the
/// same tooth leaves contact at the other end.
///
/// Formula   λ = Σ_k |[τ + k − ε_β, τ + k] ∩ [0, ε_α]|/ε_β over all whole k; on spur gears the
///           number of k with 0 ≤ τ + k < ε_α; [T9.14]
/// Domain    ε_α, ε_β ≥ 0 (contract)
double contact_lines(double transverse_ratio, double overlap_ratio, double turn);

struct ContactLineRange {
  double least, greatest;  ///< least and greatest λ
};

/// The least and the greatest λ.
///
/// Formula   [T9.15]
/// Domain    ε_α, ε_β ≥ 0 (contract)
ContactLineRange contact_line_range(double transverse_ratio, double overlap_ratio);

/// Returns the peak-to-peak variation of the deflection, divided by the deflection at λ = ε_α.
/// Returns none if λ is 0 at some rotation, because the teeth then lose contact.
///
/// Formula   ε_α (1/λ_min − 1/λ_max); [T9.16]
/// Domain    ε_α, ε_β ≥ 0 (contract)
std::optional<double> deflection_variation(double transverse_ratio, double overlap_ratio);

}  // namespace gearwright
