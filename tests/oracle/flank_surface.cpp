#include "tests/oracle/flank_surface.hpp"

#include <Eigen/Dense>
#include <cmath>
#include <numbers>
#include <utility>

#include "tests/oracle/require.hpp"

namespace gearwright::oracle::tca {
namespace {

const Vector3 kAxis(0, 0, 1);

/// e_z × v
Vector3 across(const Vector3& v) { return {-v.y(), v.x(), 0}; }

/// A point whose section is turned by an angle. The derivatives of the angle with respect to s and
/// z are given.
FlankPlace in_turned_section(const FlankPlace& p, Real angle, Real by_s, Real by_z) {
  const Matrix3 turn = turn_about_z(angle);
  FlankPlace out;
  out.r = turn * p.r;
  out.r_s = turn * (p.r_s + by_s * across(p.r));
  out.r_z = turn * (p.r_z + by_z * across(p.r));
  out.n = turn * p.n;
  out.n_s = turn * (p.n_s + by_s * across(p.n));
  out.n_z = turn * (p.n_z + by_z * across(p.n));
  return out;
}

/// χ of φ = ±k z − χ, k = cot λ / r, and dχ/dθ. This is (1) divided by tan λ.
std::pair<Real, Real> rack_lag(const ArcFlank& f, Real theta) {
  const Real sl = std::sin(f.lead_angle), cl = std::cos(f.lead_angle);
  const Real s = std::sin(theta), c = std::cos(theta);
  const Real scale = f.pitch_radius * sl;
  return {(f.rho * c * cl * cl - f.a + f.b * c / s * sl * sl) / scale,
          (-f.rho * s * cl * cl - f.b / (s * s) * sl * sl) / scale};
}

Real turn_per_length(const ArcFlank& f) {
  return std::cos(f.lead_angle) / std::sin(f.lead_angle) / f.pitch_radius * (f.mirrored ? -1 : 1);
}

}  // namespace

Matrix3 turn_about_z(Real angle) {
  const Real c = std::cos(angle), s = std::sin(angle);
  Matrix3 m;
  m << c, -s, 0, s, c, 0, 0, 0, 1;
  return m;
}

Surface arc_surface(const ArcFlank& f) {
  require(f.gear == 1 || f.gear == 2, "gear 1 or 2");
  require(f.lead_angle > 0 && f.lead_angle <= std::numbers::pi_v<Real> / 2, "0 < λ ≤ π/2");
  require(f.pitch_radius > 0, "pitch radius > 0");
  return [f](Real theta, Real z) {
    require(theta > 0 && theta < std::numbers::pi_v<Real>, "0 < θ < π");
    const Real sl = std::sin(f.lead_angle), cl = std::cos(f.lead_angle);
    const Real s = std::sin(theta), c = std::cos(theta);
    const Real side = f.gear == 1 ? 1 : -1, hand = f.mirrored ? -1 : 1;
    const Real k = turn_per_length(f);
    const auto [lag, lag_s] = rack_lag(f, theta);

    FlankPlace rack;  // in the section that turns with the rack
    rack.r = {f.rho * s - f.b + side * f.pitch_radius, -(f.rho * c - f.b * c / s) * sl, z};
    rack.r_s = {f.rho * c, -(-f.rho * s + f.b / (s * s)) * sl, 0};
    rack.r_z = kAxis;
    rack.n = {s, -c * sl, hand * c * cl};
    rack.n_s = {c, s * sl, -hand * s * cl};
    rack.n_z = {0, 0, 0};
    return in_turned_section(rack, side * (k * z - lag), -side * lag_s, side * k);
  };
}

Surface involute_surface(const InvoluteFlank& f) {
  require(f.gear == 1 || f.gear == 2, "gear 1 or 2");
  require(f.base_radius > 0, "base radius > 0");
  require(f.side == 1 || f.side == -1, "side +1 or -1");
  return [f](Real xi, Real z) {
    require(xi > 0, "ξ > 0");
    const Real out = f.gear == 1 ? 1 : -1, side = f.side;
    const Real k = f.turn_per_length * f.base_radius;  // tan β_b
    const Real length = std::sqrt(1 + k * k);
    FlankPlace string;  // the base circle's tangent point at +x
    string.r = {f.base_radius, side * f.base_radius * xi, z};
    string.r_s = {0, side * f.base_radius, 0};
    string.r_z = kAxis;
    string.n = out / length * Vector3(0, side, -side * k);
    string.n_s = string.n_z = {0, 0, 0};
    return in_turned_section(string, f.center + side * (f.half_angle - xi) + f.turn_per_length * z,
                             -side, f.turn_per_length);
  };
}

Surface turned(Surface flank, LeadTurn lead) {
  return [flank = std::move(flank), lead](Real s, Real z) {
    FlankPlace p = flank(s, z);
    const Real by_z = lead.twist + 2 * lead.crowning * z, by_zz = 2 * lead.crowning;
    // The map r → turn(z) r has the inverse transpose turn (n − t′ e_z (e_z × r)·n); then unit
    // length.
    const Real g = across(p.r).dot(p.n);
    const Real g_s = across(p.r_s).dot(p.n) + across(p.r).dot(p.n_s);
    const Real g_z = across(p.r_z).dot(p.n) + across(p.r).dot(p.n_z);
    const Vector3 m = p.n - by_z * g * kAxis;
    const Vector3 m_s = p.n_s - by_z * g_s * kAxis;
    const Vector3 m_z = p.n_z - (by_z * g_z + by_zz * g) * kAxis;
    const Real length = m.norm();
    p.n = m / length;
    p.n_s = (m_s - p.n * p.n.dot(m_s)) / length;
    p.n_z = (m_z - p.n * p.n.dot(m_z)) / length;
    return in_turned_section(p, (lead.twist + lead.crowning * z) * z, 0, by_z);
  };
}

Real rack_rotation(const ArcFlank& f, Real theta, Real z) {
  return turn_per_length(f) * z - rack_lag(f, theta).first;
}

Real rack_height(const ArcFlank& f, Real theta, Real phi) {
  return (phi + rack_lag(f, theta).first) / turn_per_length(f);
}

Matrix2 curvature(const FlankPlace& p, const Vector3& e_1, const Vector3& e_2) {
  Matrix2 r, n;
  r << e_1.dot(p.r_s), e_1.dot(p.r_z), e_2.dot(p.r_s), e_2.dot(p.r_z);
  n << e_1.dot(p.n_s), e_1.dot(p.n_z), e_2.dot(p.n_s), e_2.dot(p.n_z);
  return -n * r.inverse();
}

}  // namespace gearwright::oracle::tca
