#include "gearwright/contact/sensitivity.hpp"

#include <cmath>

#include "gearwright/contact/error_turns.hpp"
#include "gearwright/math/decompositions.hpp"

namespace gearwright {

namespace {

// The derivatives of φ2*, u and Z with respect to e at a fixed point (s, z) of flank 1. A suffix _s
// or _z marks a further derivative with respect to s or z.
struct Change {
  double p = 0.0, p_s = 0.0, p_z = 0.0;     // ∂φ2*/∂e
  double du = 0.0, du_s = 0.0, du_z = 0.0;  // ∂u/∂e, u = ln ρ on gear 2
  double dZ = 0.0, dZ_s = 0.0, dZ_z = 0.0;  // ∂Z/∂e
  FreeVector<World> dr;                     // motion of the point per unit of e
};

// Returns 1/w. The compiler's library divides with fused multiply-adds on ARM, so its last bits
// differ from those on x86-64. This function has the formula of that library, but without fused
// operations.
Complex reciprocal(const Complex& w) {
  const double x = w.real(), y = w.imag();
  if (std::abs(x) < std::abs(y)) {
    const double ratio = x / y;
    const double whole = x * ratio + y;
    return {(ratio + 0.0) / whole, -1.0 / whole};
  }
  const double ratio = y / x;
  const double whole = y * ratio + x;
  return {1.0 / whole, (0.0 - ratio) / whole};
}

// Adds the effect of a motion d of the point. d_s and d_z are the derivatives of d.
void add_motion(Change& c, const GapJet& j, const FreeVector<Axis2>& d,
                const FreeVector<Axis2>& d_s, const FreeVector<Axis2>& d_z) {
  const Complex over = reciprocal(j.w);
  const auto across = [](const FreeVector<Axis2>& a) { return Complex(a.v.x(), a.v.y()); };
  const Complex dL = across(d) * over;
  const Complex dL_s = (across(d_s) - j.w_s * dL) * over;
  const Complex dL_z = (across(d_z) - j.w_z * dL) * over;
  c.du = dL.real();
  c.du_s = dL_s.real();
  c.du_z = dL_z.real();
  c.dZ = d.v.z();
  c.dZ_s = d_s.v.z();
  c.dZ_z = d_z.v.z();
  const double bend_u = j.bend2_uu * c.du + j.bend2_uZ * c.dZ;
  const double bend_Z = j.bend2_uZ * c.du + j.bend2_ZZ * c.dZ;
  c.p = dL.imag() - j.slope2_u * c.du - j.slope2_Z * c.dZ;
  c.p_s = dL_s.imag() - j.slope2_u * c.du_s - j.slope2_Z * c.dZ_s - bend_u * j.u.s - bend_Z * j.Z.s;
  c.p_z = dL_z.imag() - j.slope2_u * c.du_z - j.slope2_Z * c.dZ_z - bend_u * j.u.z - bend_Z * j.Z.z;
}

// Adds the effect of a rotation q(s, z) of the points of flank 1 about axis 1.
void add_turn_of_1(Change& c, const ContactPair& pair, const GapJet& j, double q, double q_s,
                   double q_z) {
  const LinearMap<Axis2, Axis1>& m = pair.mount().rotation;
  const Complex i(0.0, 1.0);
  const FreeVector<Axis1> d = along_1(i * q * j.w1, 0.0);
  const FreeVector<Axis1> d_s = along_1(i * (q_s * j.w1 + q * j.w1_s), 0.0);
  const FreeVector<Axis1> d_z = along_1(i * (q_z * j.w1 + q * j.w1_z), 0.0);
  add_motion(c, j, m * d, m * d_s, m * d_z);
  c.dr = pair.tilt() * d;
}

Change change_of_error(const ContactPair& pair, const GapJet& j, double z, ErrorKind error) {
  Change c;
  const double side = pair.side();
  const double turned = pair.turned();
  const ContactErrors& e = pair.place().errors;
  const double g = side * e.crossing.rad();
  const double d = turned * e.intersecting.rad();
  const LinearMap<Axis2, World> shaft = detail::shaft_turn(side * pair.place().axis_angle.rad());
  // The arm from the point about which axis 1 tilts.
  const FreeVector<Axis1> r = along_1(j.w1, z + pair.middle(1));
  const FreeVector<Axis1> r_s = along_1(j.w1_s, 0.0);
  const FreeVector<Axis1> r_z = along_1(j.w1_z, 1.0);
  const auto tilted = [&](const LinearMap<World, Axis1>& turn) {
    add_motion(c, j, shaft * (turn * r), shaft * (turn * r_s), shaft * (turn * r_z));
    c.dr = turn * r;
  };
  const FreeVector<Axis2> still{};
  switch (error) {
    case ErrorKind::center_distance:
      add_motion(c, j, shaft * FreeVector<World>{Vec3(-1, 0, 0)}, still, still);
      break;
    case ErrorKind::crossing: tilted(detail::tilt_per_crossing(g, d, side)); break;
    case ErrorKind::intersecting: tilted(detail::tilt_per_intersecting(g, d, turned)); break;
    case ErrorKind::axial:
      c.dr = {Vec3(0, 0, turned)};
      add_motion(c, j, shaft * c.dr, still, still);
      break;
    case ErrorKind::helix_slope1: {
      const double unit = pair.twist_per_slope(1);
      add_turn_of_1(c, pair, j, unit * z, 0.0, unit);
      break;
    }
    case ErrorKind::helix_slope2: {
      const double unit = pair.twist_per_slope(2);
      c.p = -unit * j.Z.v;
      c.p_s = -unit * j.Z.s;
      c.p_z = -unit * j.Z.z;
      break;
    }
  }
  return c;
}

// The rotation of a flank per unit of a modification, with its derivatives with respect to u and z.
// [T8.7]
Jet2 turn_per_amount(const FlankPatch& f, double s, double u, double z, Modification parameter) {
  const Removal c = f.removal->derivative(parameter, u, f.removal_z * z, f.piece);
  const TurnPerRemoval k = f.profile.turn_per_removal(s);
  const double sign = -f.profile.side();
  return {sign * k.k * c.c,
          sign * (k.d1 * c.c + k.k * c.c_u),
          sign * k.k * f.removal_z * c.c_z,
          0.0,
          0.0,
          0.0};
}

Change change_of_modification(const ContactPair& pair, const GapField& field, const GapJet& j,
                              double s, double z, double s2, const Influence& influence) {
  Change c;
  if (influence.modified_gear == 1) {
    const PolarJet p = field.one().profile.at(s);
    const Jet2 m =
        turn_per_amount(field.one(), s, std::log(std::abs(p.factor)), z, influence.modification);
    add_turn_of_1(c, pair, j, m.v, m.s * p.d1.real(), m.z);
    return c;
  }
  const Jet2 m = turn_per_amount(field.two(), s2, j.u.v, j.Z.v, influence.modification);
  c.p = -m.v;
  c.p_s = -(m.s * j.u.s + m.z * j.Z.s);
  c.p_z = -(m.s * j.u.z + m.z * j.Z.z);
  return c;
}

// An active bound, unscaled: gradient, Hessian, and derivative with respect to e.
struct ActiveBound {
  double a_s = 0.0, a_z = 0.0;
  double h_ss = 0.0, h_sz = 0.0, h_zz = 0.0;
  double d = 0.0, d_s = 0.0, d_z = 0.0;
};

ActiveBound active_bound(int j, const GapJet& at, const Change& c) {
  ActiveBound b;
  const double sign = j % 2 == 0 ? 1.0 : -1.0;
  if (j < 2) b.a_s = sign;
  if (j == 2 || j == 3) b.a_z = sign;
  if (j < 4) return b;
  const Jet2& q = j < 6 ? at.u : at.Z;
  b.a_s = sign * q.s;
  b.a_z = sign * q.z;
  b.h_ss = sign * q.ss;
  b.h_sz = sign * q.sz;
  b.h_zz = sign * q.zz;
  b.d = sign * (j < 6 ? c.du : c.dZ);
  b.d_s = sign * (j < 6 ? c.du_s : c.dZ_s);
  b.d_z = sign * (j < 6 ? c.du_z : c.dZ_z);
  return b;
}

// The active bounds of a touch with their unscaled multipliers: ∇T + Σ μ_j a_j = 0.
struct Holding {
  int count = 0;
  std::array<ActiveBound, 2> bound{};
  std::array<double, 2> mu{};
};

Holding holding(const Change& c, const PairTouch& touch, const GapJet& j) {
  const detail::ActiveSet& set = touch.touch.active;
  Holding h;
  h.count = set.inside() ? 0 : set.corner() ? 2 : 1;
  for (int k = 0; k < h.count; ++k)
    h.bound[k] = active_bound(k == 0 ? set.first : set.second, j, c);
  if (h.count == 1) {
    const ActiveBound& q = h.bound[0];
    h.mu[0] = -(j.t.s * q.a_s + j.t.z * q.a_z) / (q.a_s * q.a_s + q.a_z * q.a_z);
  } else if (h.count == 2) {
    Eigen::Matrix2d m;
    m << h.bound[0].a_s, h.bound[1].a_s, h.bound[0].a_z, h.bound[1].a_z;
    const Eigen::VectorXd x = solve_linear(m, Eigen::Vector2d(-j.t.s, -j.t.z));
    h.mu = {x[0], x[1]};
  }
  return h;
}

// ∂TE/∂e, rad per unit of e. TE has the sign of a rotation in the housing.
double te_of(const Change& c, const Holding& h, const ContactPair& pair) {
  double te = c.p;
  for (int k = 0; k < h.count; ++k) te += h.mu[k] * h.bound[k].d;
  return pair.turned() * te;
}

// The derivatives of TE and of the point of contact, from the KKT system of the active bounds.
// [T8.10]
Sensitivity answer_to(const Change& c, const ContactPair& pair, const PairTouch& touch,
                      const GapJet& j) {
  const Holding h = holding(c, touch, j);
  const int n = h.count;
  Eigen::MatrixXd a = Eigen::MatrixXd::Zero(2 + n, 2 + n);
  Eigen::VectorXd b = Eigen::VectorXd::Zero(2 + n);
  a(0, 0) = j.t.ss;
  a(0, 1) = a(1, 0) = j.t.sz;
  a(1, 1) = j.t.zz;
  b[0] = -c.p_s;
  b[1] = -c.p_z;
  for (int k = 0; k < n; ++k) {
    const ActiveBound& q = h.bound[k];
    a(0, 0) += h.mu[k] * q.h_ss;
    a(0, 1) += h.mu[k] * q.h_sz;
    a(1, 0) += h.mu[k] * q.h_sz;
    a(1, 1) += h.mu[k] * q.h_zz;
    b[0] -= h.mu[k] * q.d_s;
    b[1] -= h.mu[k] * q.d_z;
    a(0, 2 + k) = a(2 + k, 0) = q.a_s;
    a(1, 2 + k) = a(2 + k, 1) = q.a_z;
    b[2 + k] = -q.d;
  }
  const Eigen::VectorXd x = solve_linear(a, b);
  const FreeVector<World> r_s = pair.tilt() * along_1(j.w1_s, 0.0);
  const FreeVector<World> r_z = pair.tilt() * along_1(j.w1_z, 1.0);
  return {te_of(c, h, pair), pair.in_housing(c.dr + r_s * x[0] + r_z * x[1])};
}

}  // namespace

Sensitivity sensitivity(Transmission& transmission, const PairTouch& touch,
                        const Influence& influence) {
  GW_EXPECTS(touch.found());
  const ContactPair& pair = transmission.pair();
  const double s = touch.touch.s;
  const double z = touch.touch.z;
  const GapJet j = transmission.jet_at(touch, s, z);
  if (influence.modified_gear == 0)
    return answer_to(change_of_error(pair, j, z, influence.error), pair, touch, j);
  const GapField& field = transmission.field(touch.fields);
  const FlankPatch& patch = influence.modified_gear == 1 ? field.one() : field.two();
  GW_EXPECTS(patch.removal != nullptr);
  const double s2 = field.two().profile.s_of(j.u.v, touch.touch.s2);
  return answer_to(change_of_modification(pair, field, j, s, z, s2, influence), pair, touch, j);
}

namespace {

// Returns ∂T*/∂e. `c` contains the derivatives at a fixed point. A row is a line of constant z on
// flank 1. T* is the greatest T of the row and lies at (s, z).
double of_row(const GapField& field, const GapJet& j, const Change& c) {
  // If T* lies inside the row, ∂T/∂s = 0, so a change of s has no effect on T*. At an end of flank
  // 1, s does not change. At the point opposite an end of flank 2, s changes with e.
  constexpr double kAtEnd = 1e-9;  // relative to the patch, in which (s, z) is accurate to 1e-15
  const FlankPatch& two = field.two();
  const double near = kAtEnd * (two.u_hi - two.u_lo);
  const bool at_end = j.u.v > two.u_hi - near || j.u.v < two.u_lo + near;
  const bool outwards = j.t.s * j.u.s * (j.u.v > 0.5 * (two.u_lo + two.u_hi) ? 1.0 : -1.0) > 0.0;
  return at_end && outwards ? c.p - j.t.s * c.du / j.u.s : c.p;
}

}  // namespace

double row_slope(const ContactPair& pair, const GapField& field, double s, double z,
                 const Influence& influence) {
  const FlankPatch& two = field.two();
  double s2 = 0.5 * (two.s_lo + two.s_hi);
  const GapJet j = field.at(s, z, s2);
  if (influence.modified_gear == 0)
    return of_row(field, j, change_of_error(pair, j, z, influence.error));
  GW_EXPECTS((influence.modified_gear == 1 ? field.one() : two).removal != nullptr);
  return of_row(
      field, j,
      change_of_modification(pair, field, j, s, z, two.profile.s_of(j.u.v, s2), influence));
}

RemovalTurn row_turn(const ContactPair& pair, const GapField& field, double s, double z, int gear) {
  GW_EXPECTS(gear == 1 || gear == 2);
  const FlankPatch& patch = gear == 1 ? field.one() : field.two();
  double s2 = 0.5 * (field.two().s_lo + field.two().s_hi);
  const GapJet j = field.at(s, z, s2);
  const double at = gear == 1 ? s : patch.profile.s_of(j.u.v, s2);
  const double turn = -patch.profile.side() * patch.profile.turn_per_removal(at).k;
  Change c;
  if (gear == 1) {
    add_turn_of_1(c, pair, j, turn, 0.0, 0.0);
  } else {
    c.p = -turn;
  }
  const double u = gear == 1 ? std::log(std::abs(patch.profile.at(s).factor)) : j.u.v;
  return {of_row(field, j, c), u, patch.removal_z * (gear == 1 ? z : j.Z.v), patch.piece};
}

double rotation_slope(Transmission& transmission, const PairTouch& touch) {
  GW_EXPECTS(touch.found());
  const ContactPair& pair = transmission.pair();
  const GapJet j = transmission.jet_at(touch, touch.touch.s, touch.touch.z);
  Change c;
  add_turn_of_1(c, pair, j, pair.rotation_sign(), 0.0, 0.0);
  // If gear 2 drives, both rotations change sign in the frame N, so their quotient stays the same.
  return pair.turned() * te_of(c, holding(c, touch, j), pair) - pair.ratio();
}

}  // namespace gearwright
