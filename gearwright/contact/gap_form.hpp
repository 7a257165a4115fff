// The gap of two flanks around a point, as a quadratic form.
//
//   gap ≈ ½ (k1 x² + k2 y²),  k1 ≤ k2 in 1/mm, x and y in mm along the principal directions
//                                                      theory: docs/theory/08-contact.md, [T8.15]
#pragma once

#include "gearwright/contact/gap_field.hpp"
#include "gearwright/math/decompositions.hpp"

namespace gearwright {

struct GapForm {
  SymmetricEigen principal;     ///< k1, k2 and their directions in (e1, e2)
  Eigen::Matrix2d of_distance;  ///< maps a step in (e1, e2) to (ds, dz) on flank 1
};

/// The quadratic form of the gap. `r_s` and `r_z` are the derivatives of the point of flank 1 with
/// respect to s and z, in any frame, and `e1`, `e2` are an orthonormal basis of the tangent plane
/// in that frame.
GapForm gap_form(const GapJet& j, const Vec3& r_s, const Vec3& r_z, const Vec3& e1, const Vec3& e2);

}  // namespace gearwright
