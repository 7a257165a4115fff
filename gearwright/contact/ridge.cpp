#include "gearwright/contact/contact_point.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <cmath>

#include "gearwright/base/contract.hpp"
#include "gearwright/math/decompositions.hpp"

namespace gearwright::detail {

namespace {

using End = FlankPatch::End;
using Vec2d = Eigen::Vector2d;
using Mat2d = Eigen::Matrix2d;

Mat2d hessian(const Jet2& j) {
  Mat2d h;
  h << j.ss, j.sz, j.sz, j.zz;
  return h;
}

// Returns the slope and the curvatures of the gap at a touch, in the tangent plane of flank 1. If
// the slope of the gap field T is not 0, its second derivatives with respect to s and z also
// contain the curvature of the coordinate lines within the surface. This part is subtracted
// (Christoffel symbols).
ContactRidge::Side side_of(const GapJet& j) {
  const Vec3 r_s = space(j.w1_s, 0.0);
  const Vec3 r_z = space(j.w1_z, 1.0);
  const Vec3 e1 = r_z.normalized();
  const Vec3 e2 = r_s.cross(r_z).normalized().cross(e1);
  Mat2d jacobian;
  jacobian << r_s.dot(e1), r_z.dot(e1), r_s.dot(e2), r_z.dot(e2);
  const Mat2d inverse = jacobian.inverse();
  const Vec2d slope = inverse.transpose() * Vec2d(j.t.s, j.t.z);
  Mat2d h = hessian(j.t);
  const auto within = [&](const Complex& w1_ab) {
    const Vec3 r_ab = space(w1_ab, 0.0);
    return slope.dot(Vec2d(r_ab.dot(e1), r_ab.dot(e2)));
  };
  h(0, 0) -= within(j.w1_ss);
  h(0, 1) -= within(j.w1_sz);
  h(1, 0) = h(0, 1);
  h(1, 1) -= within(j.w1_zz);
  const double arm = GapField::arm(j);
  const Mat2d k = -arm * inverse.transpose() * h * inverse;
  const SymmetricEigen eigen = symmetric_eigen(0.5 * (k + k.transpose()));
  return {arm * slope.norm(), {eigen.values[0], eigen.values[1]}};
}

// Returns the curvature of the gap along the curve c = const of the surface. T must be stationary
// along this curve at the point.
double curvature_along(const GapJet& j, const Vec2d& c, const Mat2d& c_bend) {
  const Vec2d t(-c[1], c[0]);
  const double mu = -Vec2d(j.t.s, j.t.z).dot(c) / c.squaredNorm();
  const Vec3 step = t[0] * space(j.w1_s, 0.0) + t[1] * space(j.w1_z, 1.0);
  return -GapField::arm(j) * t.dot((hessian(j.t) + mu * c_bend) * t) / step.squaredNorm();
}

// Returns the index of the patch beyond a border of `here`. At a border of u (`of_u` is true), both
// patches have the same range of z, and their ranges of u adjoin. At a border of z, both have the
// same range of u, and their ranges of z adjoin. Both patches store the same number for the common
// border, except for the rounding of ln ρ.
int across(const std::vector<FlankPatch>& patches, const FlankPatch& here, bool of_u, bool below) {
  constexpr double kSame = 1e-9;
  const auto same = [](double a, double b) { return std::abs(a - b) < kSame; };
  for (std::size_t i = 0; i < patches.size(); ++i) {
    const FlankPatch& p = patches[i];
    const bool beside = of_u ? same(p.z_lo, here.z_lo) : same(p.u_lo, here.u_lo);
    const bool next = of_u    ? same(below ? p.u_hi : p.u_lo, below ? here.u_lo : here.u_hi)
                      : below ? same(p.z_hi, here.z_lo)
                              : same(p.z_lo, here.z_hi);
    if (beside && next) return static_cast<int>(i);
  }
  GW_ENSURES(false);
  return -1;
}

bool is_ridge(const GapField& field, int bound) {
  const FlankPatch& a = field.one();
  const FlankPatch& b = field.two();
  const bool grows = b.profile.grows();
  switch (bound) {
    case 0: return a.s_lo_end == End::ridge;
    case 1: return a.s_hi_end == End::ridge;
    case 2: return a.z_lo_end == End::ridge;
    case 3: return a.z_hi_end == End::ridge;
    case 4: return (grows ? b.s_lo_end : b.s_hi_end) == End::ridge;
    case 5: return (grows ? b.s_hi_end : b.s_lo_end) == End::ridge;
    case 6: return b.z_lo_end == End::ridge;
    case 7: return b.z_hi_end == End::ridge;
    default: return false;
  }
}

}  // namespace

ContactRidge ridge_at(Transmission& transmission, const PairTouch& touch) {
  const ContactPair& pair = transmission.pair();
  const GapField& field = transmission.field(touch.fields);
  const ActiveSet& set = touch.touch.active;
  const int bound = !set.inside() && is_ridge(field, set.first) ? set.first : set.second;
  GW_EXPECTS(!set.inside() && is_ridge(field, bound));
  const int gear = bound < 4 ? 1 : 2;
  const bool of_u = bound % 4 < 2;
  const FlankPatch& here = gear == 1 ? field.one() : field.two();
  bool below = bound % 2 == 0;
  // If u decreases with s, the lower bound of s is the upper bound of u.
  if (gear == 1 && of_u && !here.profile.grows()) below = !below;
  const int other = across(pair.patches(gear), here, of_u, below);
  const auto n = static_cast<int>(pair.patches(2).size());
  PairTouch beyond = touch;
  beyond.fields = gear == 1 ? other * n + touch.fields % n : touch.fields / n * n + other;

  const double s = touch.touch.s;
  const double z = touch.touch.z;
  const GapJet j = transmission.jet_at(touch, s, z);
  ContactRidge ridge{gear, 0.0, {side_of(transmission.jet_at(beyond, s, z)), side_of(j)}, !of_u};
  // If gear 2 drives, z in the frame N has the opposite sign of z in the gear's frame, so the two
  // sides of a ridge at constant z are exchanged.
  if (!below != (!of_u && pair.turned() < 0.0)) std::swap(ridge.side[0], ridge.side[1]);
  if (gear == 1) {
    ridge.along = curvature_along(j, of_u ? Vec2d(1, 0) : Vec2d(0, 1), Mat2d::Zero());
  } else {
    const Jet2& c = of_u ? j.u : j.Z;
    ridge.along = curvature_along(j, Vec2d(c.s, c.z), hessian(c));
  }
  return ridge;
}

}  // namespace gearwright::detail
