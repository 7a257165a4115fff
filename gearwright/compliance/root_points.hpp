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
  /// The stresses due to the amplitude of a mode and due to the slope of the amplitude along the
  /// face. There is a column for each mode. The rows are those of tooth −1, then of tooth 0, then
  /// of tooth 1, with six components for each point.
  Eigen::MatrixXd of_mode, of_slope;
};

RootPoints root_points(const ToothSection& section);

/// Returns the greatest principal stress of a tensor with the components xx, yy, zz, xy, yz, zx.
double greatest_principal(const Eigen::Matrix<double, 6, 1>& stress);

}  // namespace gearwright::detail
