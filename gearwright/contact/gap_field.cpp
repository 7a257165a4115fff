#include "gearwright/contact/gap_field.hpp"

#include <Eigen/LU>
#include <cmath>

namespace gearwright {

namespace {

constexpr Complex kI{0.0, 1.0};

Complex turned(const Complex& factor, double phase) {
  return times(factor, {std::cos(phase), std::sin(phase)});
}

// Returns the rotation m = −c k C of a flank due to the material C that is removed from it, with
// the derivatives of m with respect to u and z. c is the side of the flank, and k is
// TurnPerRemoval. [T8.7]
Jet2 turn_of_removal(const FlankPatch& f, double s, double u, double z) {
  const Removal c = f.removal->at(u, f.removal_z * z, f.piece);
  const TurnPerRemoval k = f.profile.turn_per_removal(s);
  const double sign = -f.profile.side();
  const double c_z = f.removal_z * c.c_z;
  Jet2 m;
  m.v = sign * k.k * c.c;
  m.s = sign * (k.d1 * c.c + k.k * c.c_u);
  m.z = sign * k.k * c_z;
  m.ss = sign * (k.d2 * c.c + 2.0 * k.d1 * c.c_u + k.k * c.c_uu);
  m.sz = sign * (k.d1 * c_z + k.k * f.removal_z * c.c_uz);
  m.zz = sign * k.k * c.c_zz;
  return m;
}

// Returns the angle from the unmodified flank 2 to a point. Flank 2 is turned by the expected
// rotation first, so that the angle never exceeds half a turn. For a rack, the result is travel/r.
double angle_from(const FlankPatch& two, const RadialJet& q, double expected,
                  const GapField::Place2& place, double rack_radius) {
  if (rack_radius > 0.0)
    return -place.w.imag() / rack_radius - (q.phase + two.center + expected + place.Z * two.twist);
  const Complex back =
      turned(std::conj(q.factor), -(q.phase + two.center + expected + place.Z * two.twist));
  const Complex gap = times(place.w, back);
  return std::atan2(gap.imag(), gap.real());
}

}  // namespace

GapField::GapField(const FlankPatch& one, const FlankPatch& two, const RelativeMount& mount,
                   double ratio, double rotation_sign, double rack_radius)
    : one_(&one),
      two_(&two),
      mount_(mount),
      ratio_(ratio),
      rotation_sign_(rotation_sign),
      rack_radius_(rack_radius) {
  const Mat3& m = mount.rotation.matrix();
  from_x_ = {m(0, 0), m(1, 0)};
  from_y_ = {m(0, 1), m(1, 1)};
  from_z_ = {m(0, 2), m(1, 2)};
  from_0_ = {mount.shift.r.x(), mount.shift.r.y()};
  set_rotation(0.0);
}

void GapField::set_rotation(double phi1) {
  phi1_ = phi1;
  phase1_ = one_->center + rotation_sign_ * phi1;
  expected_ = ratio_ * phi1;
  rotation_factor_ = {std::cos(phi1), rotation_sign_ * std::sin(phi1)};
}

Complex GapField::point_at_rest(double s, double z) const {
  const PolarJet p = one_->profile.at(s);
  double turn = 0.0;
  if (one_->removal) turn = turn_of_removal(*one_, s, std::log(std::abs(p.factor)), z).v;
  return turned(p.factor, p.phase + one_->center + z * one_->twist + turn);
}

GapField::Place2 GapField::on_gear_2(const Complex& w1, double z) const {
  const Mat3& r = mount_.rotation.matrix();
  return {w1.real() * from_x_ + w1.imag() * from_y_ + z * from_z_ + from_0_,
          w1.real() * r(2, 0) + w1.imag() * r(2, 1) + z * r(2, 2) + mount_.shift.r.z()};
}

double GapField::value(const Place2& place, double& s2) const {
  const double u =
      rack_radius_ > 0.0 ? -place.w.real() / rack_radius_ : 0.5 * std::log(std::norm(place.w));
  const RadialJet q = two_->profile.at_radius(u, s2);
  const double t = angle_from(*two_, q, expected_, place, rack_radius_);
  return two_->removal ? t - turn_of_removal(*two_, s2, u, place.Z).v : t;
}

GapJet GapField::at(double s, double z, double& s2) const {
  const PolarJet p = one_->profile.at(s);
  // Flank 1 in its transverse section is w1 = e^{λ}. The derivatives of λ with respect
  // to s and z are l_s, l_z, …
  Complex l_s = p.d1;
  Complex l_ss = p.d2;
  double turn = 0.0;
  double l_z = one_->twist;
  double l_sz = 0.0;
  double l_zz = 0.0;
  if (one_->removal) {
    const double u1 = std::log(std::abs(p.factor));
    const Jet2 m = turn_of_removal(*one_, s, u1, z);
    const double u_s = p.d1.real();
    turn = m.v;
    l_s += kI * (m.s * u_s);
    l_ss += kI * (m.ss * u_s * u_s + m.s * p.d2.real());
    l_z += m.z;
    l_sz = m.sz * u_s;
    l_zz = m.zz;
  }
  GapJet j;
  j.w1 = turned(p.factor, p.phase + phase1_ + z * one_->twist + turn);
  const Complex d[5] = {times(l_s, j.w1), Complex{-l_z * j.w1.imag(), l_z * j.w1.real()},
                        times(l_ss + times(l_s, l_s), j.w1),
                        times(kI * l_sz + times(l_s, {0.0, l_z}), j.w1),
                        times({-l_z * l_z, l_zz}, j.w1)};
  j.w1_s = d[0];
  j.w1_z = d[1];
  j.w1_ss = d[2];
  j.w1_sz = d[3];
  j.w1_zz = d[4];
  // The point and its derivatives in the frame of gear 2.
  const Mat3& r = mount_.rotation.matrix();
  const auto across = [&](const Complex& v) { return v.real() * from_x_ + v.imag() * from_y_; };
  const auto along = [&](const Complex& v) { return v.real() * r(2, 0) + v.imag() * r(2, 1); };
  const Place2 place = on_gear_2(j.w1, z);
  j.w = place.w;
  j.w_s = across(d[0]);
  j.w_z = across(d[1]) + from_z_;
  j.Z = {place.Z, along(d[0]), along(d[1]) + r(2, 2), along(d[2]), along(d[3]), along(d[4])};
  // L = ln w, or −w/r on a rack, where w is the point in the frame of gear 2. The real part is u,
  // and the imaginary part is the azimuth.
  const bool rack = rack_radius_ > 0.0;
  const double height = -j.w.real();
  if (rack) j.w = -rack_radius_;
  const double square = std::norm(j.w);
  const Complex over = std::conj(j.w) / square;
  const Complex L_s = times(j.w_s, over);
  const Complex L_z = times(j.w_z, over);
  Complex L_ss = times(across(d[2]), over);
  Complex L_sz = times(across(d[3]), over);
  Complex L_zz = times(across(d[4]), over);
  if (rack) {
    j.w_s = j.w_z = 0.0;
  } else {
    L_ss -= times(L_s, L_s);
    L_sz -= times(L_s, L_z);
    L_zz -= times(L_z, L_z);
  }
  const double u = rack ? height / rack_radius_ : 0.5 * std::log(square);
  j.u = {u, L_s.real(), L_z.real(), L_ss.real(), L_sz.real(), L_zz.real()};
  const RadialJet q = two_->profile.at_radius(j.u.v, s2);
  double t1 = q.d1;
  double t2 = q.d2;
  double z1 = two_->twist;
  double uz = 0.0;
  double zz = 0.0;
  j.t.v = angle_from(*two_, q, expected_, place, rack_radius_);
  if (two_->removal) {
    const Jet2 m = turn_of_removal(*two_, s2, j.u.v, j.Z.v);
    j.t.v -= m.v;
    t1 += m.s;
    t2 += m.ss;
    z1 += m.z;
    uz = m.sz;
    zz = m.zz;
  }
  j.slope2_u = t1;
  j.slope2_Z = z1;
  j.bend2_uu = t2;
  j.bend2_uZ = uz;
  j.bend2_ZZ = zz;
  j.t.s = L_s.imag() - t1 * j.u.s - z1 * j.Z.s;
  j.t.z = L_z.imag() - t1 * j.u.z - z1 * j.Z.z;
  const auto second = [&](const Complex& L, double u_a, double u_b, double Z_a, double Z_b,
                          double Z_ab) {
    return L.imag() - t1 * L.real() - t2 * u_a * u_b - z1 * Z_ab - uz * (u_a * Z_b + u_b * Z_a) -
           zz * Z_a * Z_b;
  };
  j.t.ss = second(L_ss, j.u.s, j.u.s, j.Z.s, j.Z.s, j.Z.ss);
  j.t.sz = second(L_sz, j.u.s, j.u.z, j.Z.s, j.Z.z, j.Z.sz);
  j.t.zz = second(L_zz, j.u.z, j.u.z, j.Z.z, j.Z.z, j.Z.zz);
  return j;
}

double GapField::arm(const GapJet& j) {
  const double square = std::norm(j.w);
  return 1.0 / std::sqrt((1.0 + j.slope2_u * j.slope2_u) / square + j.slope2_Z * j.slope2_Z);
}

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
