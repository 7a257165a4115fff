// The half space that osculates the flank: the indentation by a bump or a Hertz strip.
//
//   H(R) = (1 − ν²)/(π E R)   displacement at a distance R of a unit force      E = 1
//   R² = Δs² + 2g Δs Δz + G Δz²   metric of the flank; spur: g = 0, G = 1
//   λ  = 2(1 − ν²)/π                                theory: docs/theory/12-loaded-contact.md, [T12.10]
//
// Forces and readings are means over slices of the face: F(x, z) = z asinh(z/|x|) − √(x² + z²) is
// the second integral of 1/R by z.
#pragma once

#include <vector>

namespace gearwright::detail {

/// Metric of the surface that a section generates along the axis, by arc length and by height.
struct FlankMetric {
  double sz = 0.0;  ///< g
  double zz = 1.0;  ///< G
};

/// In plane strain, up to the constant that the logarithm leaves undetermined: the indentation by
/// two bumps of half width c at one place, and that at the centre of a Hertz strip of half width a.
/// [T12.11]
double plane_bump(double c, double poisson_ratio);
double plane_hertz(double a, double poisson_ratio);

/// ∫∫ b_c(x) b_c′(x′) f(Δs + x′ − x): nodes and weights for functions with a logarithm at 0.
struct Offsets {
  std::vector<double> x, weight;
};
Offsets bump_offsets(double ds, double c, double c_other);
/// Offsets for the centre of a Hertz strip.
Offsets hertz_offsets(double a);

/// Mean of 1/R over two slices of width h whose middles are d apart.
double slices_inverse(const FlankMetric& metric, double offset, double d, double h);
/// Mean over one slice [z_lo, z_hi] of 1/R to a point at z.
double slice_to_point(const FlankMetric& metric, double offset, double z, double z_lo, double z_hi);

}  // namespace gearwright::detail
