// Computes the indentation of an elastic half space by a force that is distributed as a bump or
// over a Hertz strip. The half space represents the flank near the force.
//
//   H(R) = (1 − ν²)/(π E R)   displacement at the distance R from a unit force      E = 1
//   R² = Δs² + 2g Δs Δz + G Δz²   metric of the flank; g = 0 and G = 1 for a spur gear
//                                               theory: docs/theory/12-loaded-contact.md, [T12.10]
//
// Forces are distributed over slices of the face, and displacements are means over slices. The
// integrals use F(x, z) = z asinh(z/|x|) − √(x² + z²), the second integral of 1/R over z.
#pragma once

#include <vector>

namespace gearwright::detail {

/// Metric of the flank in terms of arc length s and height z.
struct FlankMetric {
  double sz = 0.0;  ///< g
  double zz = 1.0;  ///< G
};

/// Returns the displacement in plane strain under a bump of half width c, averaged with the weights
/// of the same bump. An additive constant is omitted. [T12.11]
double plane_bump(double c, double poisson_ratio);
/// Returns the displacement in plane strain at the centre of a Hertz strip of half width a. The
/// same additive constant as in plane_bump() is omitted. [T12.11]
double plane_hertz(double a, double poisson_ratio);
/// Nodes and weights of a quadrature rule for functions with a logarithmic singularity at 0.
struct Offsets {
  std::vector<double> x, weight;
};
/// Returns the quadrature rule for ∫∫ b_c(x) b_c′(x′) f(Δs + x′ − x) dx dx′.
Offsets bump_offsets(double ds, double c, double c_other);
/// Returns the quadrature rule for the mean of f(x) over a Hertz strip, weighted by the pressure. x
/// is the distance from the centre line of the strip.
Offsets hertz_offsets(double a);

/// Returns the mean of 1/R between the points of two slices of width h. The middles of the slices
/// are d apart along z and `offset` apart along s.
double slices_inverse(const FlankMetric& metric, double offset, double d, double h);
/// Returns the mean of 1/R between the points of a slice [z_lo, z_hi] and a point at z, `offset`
/// apart along s.
double slice_to_point(const FlankMetric& metric, double offset, double z, double z_lo, double z_hi);

}  // namespace gearwright::detail
