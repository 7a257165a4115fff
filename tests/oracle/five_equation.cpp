#include "tests/oracle/five_equation.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "tests/oracle/numbers.hpp"

namespace gearwright::oracle::tca {
namespace {

using Vector5 = Eigen::Matrix<Real, 5, 1>;
using Matrix5 = Eigen::Matrix<Real, 5, 5>;

FlankPlace in_housing(const Frame& frame, const FlankPlace& p) {
  return {frame.turn * p.r + frame.shift,
          frame.turn * p.r_s,
          frame.turn * p.r_z,
          frame.turn * p.n,
          frame.turn * p.n_s,
          frame.turn * p.n_z};
}

/// Both flanks in the housing at given unknowns.
struct Posture {
  FlankPlace own_1, own_2;  // in the gears' frames
  FlankPlace f_1, f_2;
  Vector3 axis_2;
};

Posture posture(const FlankPair& pair, Real rotation_1, const Unknowns& x) {
  Posture p;
  p.own_1 = pair.flank_1(x.s_1, x.z_1);
  p.own_2 = pair.flank_2(x.s_2, x.z_2);
  const Frame frame = frame_2(pair.mounting, x.rotation_2);
  p.f_1 = in_housing(frame_1(pair.mounting, rotation_1), p.own_1);
  p.f_2 = in_housing(frame, p.own_2);
  p.axis_2 = frame.turn.col(2);
  return p;
}

/// An orthonormal basis of the tangent plane of flank 2.
std::pair<Vector3, Vector3> tangents(const FlankPlace& p) {
  const Vector3 t = (p.r_z - p.n * p.n.dot(p.r_z)).normalized();
  return {t, p.n.cross(t)};
}

/// The five equations with the t, t′ of this position. Since n_2·t = 0, they are equivalent to (n_1
/// − n_2)·t, and t may be held constant in the derivative. The omitted term is the rotation of t
/// times n_1 − n_2, which is zero at the solution.
Vector5 equations(const FlankPair& pair, const Posture& p) {
  const auto [t, t_other] = tangents(p.f_2);
  Vector5 f;
  f.head<3>() = (p.f_1.r - p.f_2.r) / pair.scale;
  f(3) = p.f_1.n.dot(t);
  f(4) = p.f_1.n.dot(t_other);
  return f;
}

Matrix5 jacobian(const FlankPair& pair, const Posture& p) {
  const auto [t, t_other] = tangents(p.f_2);
  const auto column = [&, t = t, t_other = t_other](const Vector3& dr, const Vector3& dn) {
    Vector5 c;
    c << dr / pair.scale, dn.dot(t), dn.dot(t_other);
    return c;
  };
  const Vector3 center(pair.mounting.center_distance + pair.mounting.d_center, 0, 0);
  Matrix5 j;
  j.col(0) = column(p.f_1.r_s, p.f_1.n_s);
  j.col(1) = column(p.f_1.r_z, p.f_1.n_z);
  j.col(2) = -column(p.f_2.r_s, p.f_2.n_s);
  j.col(3) = -column(p.f_2.r_z, p.f_2.n_z);
  j.col(4) = -column(p.axis_2.cross(p.f_2.r - center), p.axis_2.cross(p.f_2.n));
  return j;
}

bool within(Real x, Real low, Real high) { return low <= x && x <= high; }

/// All data of a contact, without a check that it solves the equations.
void describe(const FlankPair& pair, Real rotation_1, const Posture& p, FiveEquationTouch& out) {
  const Unknowns& x = out.at;
  out.transmission_error = x.rotation_2 - pair.ratio * rotation_1;
  out.point_f = p.f_1.r, out.normal_f = p.f_1.n;
  out.point_1 = p.own_1.r, out.point_2 = p.own_2.r;

  const Vector3 n = p.f_2.n;
  const Vector3 e_1 = (Vector3::UnitZ() - n * n.z()).normalized(), e_2 = n.cross(e_1);
  const Matrix2 k = curvature(p.f_2, e_1, e_2) - curvature(p.f_1, e_1, e_2);
  out.gap_curvature = (k + k.transpose()) / 2;
  const Eigen::SelfAdjointEigenSolver<Matrix2> eigen(out.gap_curvature);
  out.k_1 = eigen.eigenvalues()(0), out.k_2 = eigen.eigenvalues()(1);
  const auto direction = eigen.eigenvectors().col(0);
  out.major_angle = std::atan(direction(1) / direction(0));

  out.opens = out.k_1 > 0;
  out.within_outlines = within(x.s_1, pair.ends_1.s_low, pair.ends_1.s_high) &&
                        within(x.s_2, pair.ends_2.s_low, pair.ends_2.s_high);
  out.within_faces = within(x.z_1, pair.ends_1.z_low, pair.ends_1.z_high) &&
                     within(x.z_2, pair.ends_2.z_low, pair.ends_2.z_high);
}

}  // namespace

FiveEquationTouch solve(const FlankPair& pair, Real rotation_1, const Unknowns& start) {
  FiveEquationTouch out;
  out.at = start;
  Posture here = posture(pair, rotation_1, out.at);
  Vector5 f = equations(pair, here);
  // The iteration ends if no fraction of the next step reduces the residual. This happens at the
  // last point or at a minimum that is not a solution. kSteps only limits slow convergence.
  constexpr int kSteps = 100, kHalvings = 20;
  for (bool better = true; better && out.iterations < kSteps; ++out.iterations) {
    const Vector5 d = jacobian(pair, here).fullPivLu().solve(-f);
    better = false;
    Real part = 1;
    for (int i = 0; i < kHalvings && !better; ++i, part /= 2) {
      const Unknowns to{out.at.s_1 + part * d(0), out.at.z_1 + part * d(1),
                        out.at.s_2 + part * d(2), out.at.z_2 + part * d(3),
                        out.at.rotation_2 + part * d(4)};
      // Arcs have no point outside (0, π) and involutes none inside the base circle, so such a step
      // is too long.
      try {
        const Posture there = posture(pair, rotation_1, to);
        const Vector5 f_there = equations(pair, there);
        if (!(f_there.norm() < f.norm())) continue;
        better = true;
        out.at = to, here = there, f = f_there;
      } catch (const std::invalid_argument&) {
      }
    }
  }
  out.residual = f.norm();
  out.solved = out.residual < kSolved;
  describe(pair, rotation_1, here, out);
  return out;
}

FiveEquationTouch follow(const std::function<FlankPair(Real part)>& deviates, Real rotation_1,
                         const Unknowns& start, int steps) {
  FiveEquationTouch touch;
  touch.at = start;
  int iterations = 0;
  for (int i = 1; i <= steps; ++i) {
    touch = solve(deviates(static_cast<Real>(i) / steps), rotation_1, touch.at);
    iterations += touch.iterations;
  }
  touch.iterations = iterations;
  return touch;
}

ArcFlank flank_1(const ArcPair& p) {
  return {1, p.f.rho, p.f.a, p.f.b, p.lead_angle_f, p.pitch_radius_1, false};
}

ArcFlank flank_2(const ArcPair& p) {
  return {2, p.p.rho, p.p.a, p.p.b, p.lead_angle_p, p.pitch_radius_2, false};
}

Real nominal_theta(const ArcPair& p) {
  const Real sine = (p.p.b - p.f.b) / (p.p.rho - p.f.rho);
  const bool usable = within(sine, std::sin(kLongPi / 36), std::sin(kLongPi / 3));
  return usable ? std::asin(sine) : kLongPi / 6;
}

FlankPair flank_pair(const ArcPair& p, Real theta, Real part) {
  const auto scaled = [part](Real x) { return x * part; };
  const auto between = [part](Real from, Real to) {
    return part == 1 ? to : from + part * (to - from);
  };
  ArcFlank one = flank_1(p);
  const Real b_start = p.f.rho * std::sin(theta) - (p.p.rho * std::sin(theta) - p.p.b);
  one.b = between(b_start, p.f.b);
  one.lead_angle = between(p.lead_angle_p, p.lead_angle_f);
  FlankPair out;
  out.flank_1 = turned(arc_surface(one), {scaled(p.lead_1.twist), scaled(p.lead_1.crowning)});
  out.flank_2 =
      turned(arc_surface(flank_2(p)), {scaled(p.lead_2.twist), scaled(p.lead_2.crowning)});
  out.ends_1 = {p.f.theta_low, p.f.theta_high, -p.half_face_1, p.half_face_1};
  out.ends_2 = {p.p.theta_low, p.p.theta_high, -p.half_face_2, p.half_face_2};
  const Mounting& m = p.mounting;
  out.mounting = {m.center_distance,  scaled(m.shaft_angle),  scaled(m.d_center),
                  scaled(m.crossing), scaled(m.intersecting), scaled(m.axial)};
  out.ratio = static_cast<Real>(p.teeth_1) / p.teeth_2;
  out.scale = p.pitch_radius_1;
  return out;
}

FiveEquationTouch arc_touch(const ArcPair& p, Real rotation_1) {
  const Real theta = nominal_theta(p);
  // For part 0, both flanks touch the racks at the same θ and height, and neither gear is turned
  // relative to its rack.
  ArcFlank one = flank_1(p);
  one.b = p.f.rho * std::sin(theta) - (p.p.rho * std::sin(theta) - p.p.b);
  one.lead_angle = p.lead_angle_p;
  const Real z = rack_height(one, theta, rotation_1);
  const Unknowns start{theta, z, theta, z, rack_rotation(flank_2(p), theta, z)};
  return follow([&](Real part) { return flank_pair(p, theta, part); }, rotation_1, start);
}

std::optional<CarryingPair> carrying_arc_touch(const ArcPair& p, Real rotation_1, int reach) {
  std::optional<CarryingPair> best;
  for (int k = -reach; k <= reach; ++k) {
    CarryingPair one{k, arc_touch(p, rotation_1 - 2 * kLongPi * k / p.teeth_1)};
    if (!one.touch.holds()) continue;
    // The transmission error belongs to the earlier position. φ_2 is k pitches further.
    one.touch.at.rotation_2 += 2 * kLongPi * k / p.teeth_2;
    if (!best || one.touch.at.rotation_2 > best->touch.at.rotation_2) best = one;
  }
  return best;
}

}  // namespace gearwright::oracle::tca
