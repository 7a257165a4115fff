// Computes the influence coefficients between the slices of a face due to the shaft of the gear.
//
//   G_w, G_wm, G_m   w due to a force, w due to a moment, ψ due to a moment, in one plane
//   Φ                twist of the gear due to a torque
//
// Row i contains the displacements in the middle of slice i. Column j belongs to a load that is
// uniform over slice j. By Betti's reciprocity, G_w, G_m and Φ are symmetric, and ψ due to a force
// is the transpose of G_wm.
//                                                theory: docs/theory/12-loaded-contact.md, [T12.34]
#pragma once

#include <Eigen/Core>

#include "gearwright/compliance/shaft.hpp"
#include "gearwright/compliance/tooth_table.hpp"

namespace gearwright {

struct ShaftInfluence {
  Eigen::MatrixXd force;   ///< G_w   mm/N
  Eigen::MatrixXd moment;  ///< G_wm  1/N
  Eigen::MatrixXd turn;    ///< G_m   rad/(N mm)
  Eigen::MatrixXd twist;   ///< Φ     rad/(N mm)
};

/// Computes the coefficients for slices in mm. The gear twists like a cylinder with the diameter
/// `body`.
///
/// Formula   [T12.34]
/// Domain    shaft.possible() (contract)
/// Accuracy  a load is uniform over its slice, so equal loads on all slices are a uniform load on
///           the face. Each entry is the mean of the computed entries (i, j) and (j, i), which
///           differ by the order of the square of the slice width
ShaftInfluence shaft_influence(const Shaft& shaft, const FaceSlices& slices, double body);

}  // namespace gearwright
