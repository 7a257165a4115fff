#include "gearwright/contact/gap_form.hpp"

#include <Eigen/LU>

namespace gearwright {

GapForm gap_form(const GapJet& j, const Vec3& r_s, const Vec3& r_z, const Vec3& e1,
                 const Vec3& e2) {
  Eigen::Matrix2d jacobian;
  jacobian << r_s.dot(e1), r_z.dot(e1), r_s.dot(e2), r_z.dot(e2);
  const Eigen::Matrix2d inverse = jacobian.inverse();
  Eigen::Matrix2d h;
  h << j.t.ss, j.t.sz, j.t.sz, j.t.zz;
  const Eigen::Matrix2d k = -GapField::arm(j) * inverse.transpose() * h * inverse;
  return {symmetric_eigen(0.5 * (k + k.transpose())), inverse};
}

}  // namespace gearwright
