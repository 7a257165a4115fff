// Influence of the loads on the slices of a face on one another by the shaft of the gear.
//
//   G_w, G_wm, G_m   w by a force, w by a moment, ψ by a moment, in one plane
//   Φ                twist of the gear by a torque
//
// A row is the slice of the displacement, in its middle. A column is the slice of the load, which is
// uniform over the slice. The work of two loads on one another is the same in either order, so G_w,
// G_m and Φ are symmetric, and ψ by a force is the transpose of G_wm.
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

/// `slices` in mm; the gear twists like a solid body of the diameter `body`, mm.
///
/// Formula   [T12.34]
/// Domain    shaft.possible() (contract)
/// Accuracy  the loads are uniform over the slices, so sums over all slices are those of a uniform load;
///           an entry is the mean of both orders, which differ by the square of the width of a slice
ShaftInfluence shaft_influence(const Shaft& shaft, const FaceSlices& slices, double body);

}  // namespace gearwright
