// Computes the Hertz contact ellipse of two elastic bodies that touch at a point.
//
//   k1 ≤ k2   principal curvatures of the gap, 1/mm      E*   reduced modulus, N/mm²
//   a ≥ b     semi-axes, mm: a along the direction of k1
//   δ         approach of distant points, mm
//                                                theory: docs/theory/12-loaded-contact.md, 12.6
#pragma once

#include <array>

namespace gearwright {

struct HertzEllipse {
  double semi_major, semi_minor;  ///< a, b  mm  [T12.21]
  double pressure;                ///< p0  N/mm², greatest pressure
  double approach;                ///< δ  mm  [T12.23]
};

/// A point contact with given curvatures and reduced modulus. a and b are proportional to F^(1/3),
/// and δ is proportional to F^(2/3). The class stores the factors. [T12.22]
class HertzPoint {
 public:
  /// Domain    0 < k1 ≤ k2, E* > 0 (contract)
  HertzPoint(const std::array<double, 2>& gap_curvature, double reduced_modulus);

  /// Returns the ellipse under a force.
  ///
  /// Domain    force ≥ 0  N (contract)
  HertzEllipse under(double force) const;
  /// δ/F^(2/3)  mm/N^(2/3)
  double softness() const { return softness_; }

 private:
  double semi_major_, axes_, softness_;  // a/F^(1/3), b/a, δ/F^(2/3)
};

}  // namespace gearwright
