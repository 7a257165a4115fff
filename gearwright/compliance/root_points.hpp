// Computes the stress at the roots of teeth from amplitudes of the modes and their slopes.
//
//   σ = D (A f + B f′)   components xx, yy, zz, xy, yz, zx in coordinates that turn with the helix
//                                                theory: docs/theory/12-loaded-contact.md, [T12.15]
#pragma once

#include <Eigen/Core>
#include <vector>

#include "gearwright/compliance/tooth_section.hpp"

namespace gearwright::detail {

struct RootPoints {
  std::vector<double> t;                    ///< position along the outline (section_mesh.hpp)
  std::vector<std::complex<double>> place;  ///< point on tooth 0, normal modules
  /// For each of the teeth −1, 0 and 1, a matrix with a column per mode and six rows per point, one
  /// for each component. `of_mode` contains the stresses due to the amplitude of a mode, and
  /// `of_slope` the stresses due to the slope of the amplitude along the face.
  std::vector<Eigen::MatrixXd> of_mode, of_slope;
};

RootPoints root_points(const ToothSection& section);

/// Returns the greatest principal stress of a tensor with the components xx, yy, zz, xy, yz, zx.
double greatest_principal(const Eigen::Matrix<double, 6, 1>& stress);

}  // namespace gearwright::detail
