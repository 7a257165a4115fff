// The five equations of tooth contact for circular-arc pairs in a fast form: in double, with an
// analytic Jacobian, without memory allocation, starting from the last position. Benchmarks compare
// it with the contact room. It also serves as a second independent method.
//
//   unknowns   θ_1, φ_1, θ_2, φ_2 (arc angle and rack rotation of either flank), φ_2′ (gear 2)
//   given      φ_1′ (gear 1)
//   frame      axis 2 with its tilt but not its turn, so that φ_2′ turns flank 2 about z
//
// A flank is the section of its rack turned by ω (flank_surface.hpp, (1)), with ω = φ + κ z − φ′ on
// gear 1 and ω = −φ + κ z + φ′ on gear 2. Its normal (sin θ, −cos θ sin λ, cos θ cos λ − κ g) is
// turned in the same way, where g = (e_z × r)·n = B sin θ − A cos θ sin λ. Each step needs four
// sines and cosines.
//
// The two equations for the normals are (n_1 × n_2)·t = 0 with t = (−n_2y, n_2x, 0), and the same
// with t′ = n_2 × t. Both vectors are held constant in the derivative, because their changes are
// multiplied by n_1 × n_2, which is zero at the solution.
#pragma once

#include <array>
#include <cmath>
#include <utility>

#include "tests/oracle/five_equation.hpp"

namespace gearwright::oracle::tca {

class FastArcTouch {
 public:
  struct Position {
    double theta_1 = 0, rack_1 = 0, theta_2 = 0, rack_2 = 0;
    double rotation_2 = 0;  ///< φ_2′
    double step = 0;        ///< the last Newton step, the greatest of the five
    int iterations = 0;
    bool converged = false;  ///< step < kLastStep
  };

  /// Convergence is quadratic: after a step of this size, only the rounding error remains.
  static constexpr double kLastStep = 1e-9;  // rad

  /// Lead errors are only twists. Crownings of the pair are ignored.
  explicit FastArcTouch(const ArcPair& pair)
      : one_(pair.f, pair.lead_angle_f, pair.pitch_radius_1, pair.lead_1.twist, +1),
        two_(pair.p, pair.lead_angle_p, pair.pitch_radius_2, pair.lead_2.twist, -1),
        per_length_(1 / static_cast<double>(pair.pitch_radius_1)) {
    const Frame to_2 = frame_2(pair.mounting, 0), from_1 = frame_1(pair.mounting, 0);
    const Matrix3 turn = to_2.turn.transpose() * from_1.turn;
    const Vector3 shift = to_2.turn.transpose() * (from_1.shift - to_2.shift);
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) turn_[3 * i + j] = static_cast<double>(turn(i, j));
      shift_[i] = static_cast<double>(shift(i));
    }
  }

  /// Newton's method at φ_1′ = `rotation_1` from `start`, with at most 20 full steps.
  Position solve(double rotation_1, const Position& start) const noexcept {
    Position x = start;
    x.converged = false;
    for (x.iterations = 1; x.iterations <= 20; ++x.iterations) {
      Equations e = equations(rotation_1, x);
      if (!eliminate(e)) return x;
      const auto& d = e.value;
      x.theta_1 -= d[0], x.rack_1 -= d[1], x.theta_2 -= d[2], x.rack_2 -= d[3];
      x.rotation_2 -= d[4];
      x.step = 0;
      for (const double d_i : d) x.step = std::fmax(x.step, std::fabs(d_i));
      if (x.step < kLastStep) {
        x.converged = true;
        return x;
      }
    }
    return x;
  }

  /// z of the touching point along gear 1 and along gear 2.
  std::pair<double, double> heights(const Position& x) const noexcept {
    return {one_.height(x.theta_1, x.rack_1), two_.height(x.theta_2, x.rack_2)};
  }

  /// The contact point in the housing, from flank 1. Computing it requires a transformation from
  /// the frame of axis 2 with the mounting of `pair`, so this function is meant for reports, not
  /// for loops.
  static Vector3 point_f(const ArcPair& pair, Real rotation_1, const Position& x) {
    const Surface flank = turned(arc_surface(flank_1(pair)), {pair.lead_1.twist, 0});
    const Frame frame = frame_1(pair.mounting, rotation_1);
    const Real z = rack_height(flank_1(pair), x.theta_1, x.rack_1);
    return frame.turn * flank(x.theta_1, z).r + frame.shift;
  }

  /// Converts a contact found by the slow method to these unknowns.
  static Position from(const ArcPair& pair, const FiveEquationTouch& touch) {
    Position x;
    x.theta_1 = static_cast<double>(touch.at.s_1);
    x.rack_1 = static_cast<double>(rack_rotation(flank_1(pair), touch.at.s_1, touch.at.z_1));
    x.theta_2 = static_cast<double>(touch.at.s_2);
    x.rack_2 = static_cast<double>(rack_rotation(flank_2(pair), touch.at.s_2, touch.at.z_2));
    x.rotation_2 = static_cast<double>(touch.at.rotation_2);
    return x;
  }

  /// Linear extrapolation: the start value for the next step if the steps are equal.
  static Position beyond(const Position& before, const Position& last) noexcept {
    Position x = last;
    x.theta_1 += last.theta_1 - before.theta_1, x.rack_1 += last.rack_1 - before.rack_1;
    x.theta_2 += last.theta_2 - before.theta_2, x.rack_2 += last.rack_2 - before.rack_2;
    x.rotation_2 += last.rotation_2 - before.rotation_2;
    return x;
  }

  /// One evaluation of the five equations and their Jacobian, row by row.
  struct Equations {
    std::array<double, 5> value;
    std::array<double, 25> jacobian;
  };

  Equations equations(double rotation_1, const Position& x) const noexcept {
    const Turned f = one_.at(x.theta_1, x.rack_1, -rotation_1);
    const Turned g = two_.at(x.theta_2, x.rack_2, x.rotation_2);
    const V r_1 = moved(f.r), r_1s = turn(f.r_s), r_1p = turn(f.r_p);
    const V n_1 = turn(f.n), n_1s = turn(f.n_s), n_1p = turn(f.n_p);
    const V& n_2 = g.n;

    const V t{-n_2[1], n_2[0], 0}, u = cross(n_2, t);
    const V n_2t = u, n_2u = cross(n_2, u);              // n_1·(n_2 × t) = (n_1 × n_2)·t
    const V t_n1 = cross(t, n_1), u_n1 = cross(u, n_1);  // n_2·(t × n_1), the same
    // d/dφ_2′ turns r_2 and n_2 about z.
    const V r_2w{-g.r[1], g.r[0], 0}, n_2w{-n_2[1], n_2[0], 0};

    Equations e;
    for (int i = 0; i < 3; ++i) {
      e.value[i] = (r_1[i] - g.r[i]) * per_length_;
      e.jacobian[5 * i] = r_1s[i] * per_length_;
      e.jacobian[5 * i + 1] = r_1p[i] * per_length_;
      e.jacobian[5 * i + 2] = -g.r_s[i] * per_length_;
      e.jacobian[5 * i + 3] = -g.r_p[i] * per_length_;
      e.jacobian[5 * i + 4] = -r_2w[i] * per_length_;
    }
    e.value[3] = dot(n_1, n_2t), e.value[4] = dot(n_1, n_2u);
    e.jacobian[15] = dot(n_1s, n_2t), e.jacobian[20] = dot(n_1s, n_2u);
    e.jacobian[16] = dot(n_1p, n_2t), e.jacobian[21] = dot(n_1p, n_2u);
    e.jacobian[17] = dot(g.n_s, t_n1), e.jacobian[22] = dot(g.n_s, u_n1);
    e.jacobian[18] = dot(g.n_p, t_n1), e.jacobian[23] = dot(g.n_p, u_n1);
    e.jacobian[19] = dot(n_2w, t_n1), e.jacobian[24] = dot(n_2w, u_n1);
    return e;
  }

 private:
  using V = std::array<double, 3>;

  static double dot(const V& a, const V& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
  static V cross(const V& a, const V& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  }

  /// A flank's place with derivatives by θ (s) and by the rack's rotation φ (p).
  struct Turned {
    V r, r_s, r_p, n, n_s, n_p;
  };

  struct Arc {
    double rho, b, b_center, radius, sin_lead, cos_lead, tan_lead, height_0, rise, twist, sense;

    Arc(const RackArc& arc, Real lead, Real r, Real kappa, int sign)
        : rho(static_cast<double>(arc.rho)),
          b(static_cast<double>(arc.b)),
          b_center(static_cast<double>(sign * r - arc.b)),
          radius(static_cast<double>(r)),
          sin_lead(static_cast<double>(std::sin(lead))),
          cos_lead(static_cast<double>(std::cos(lead))),
          tan_lead(static_cast<double>(std::tan(lead))),
          height_0(static_cast<double>(-arc.a / std::cos(lead))),
          rise(static_cast<double>(r * std::tan(lead))),
          twist(static_cast<double>(kappa)),
          sense(sign) {}

    double height(double theta, double phi) const noexcept {
      const double s = std::sin(theta), c = std::cos(theta);
      return rho * c * cos_lead + height_0 + b * c / s * tan_lead * sin_lead + rise * phi;
    }

    /// The flank at (θ, φ), its gear turned by `rotation` about +z.
    Turned at(double theta, double phi, double rotation) const noexcept {
      const double s = std::sin(theta), c = std::cos(theta), per_s = 1 / s, cot = c * per_s;
      const double x = rho * s + b_center, x_s = rho * c;
      const double y = -(rho * c - b * cot) * sin_lead;
      const double cut = b * per_s * per_s;
      const double y_s = (rho * s - cut) * sin_lead;
      const double z = rho * c * cos_lead + height_0 + b * cot * tan_lead * sin_lead + rise * phi;
      const double z_s = -rho * s * cos_lead - cut * tan_lead * sin_lead;
      const double n_y = -c * sin_lead, n_ys = s * sin_lead;
      const double g = x * n_y - y * s, g_s = x_s * n_y + x * n_ys - y_s * s - y * c;
      const double n_z = c * cos_lead - twist * g, n_zs = -s * cos_lead - twist * g_s;

      const double omega = sense * phi + twist * z + rotation;
      const double omega_s = twist * z_s, omega_p = sense + twist * rise;
      const double so = std::sin(omega), co = std::cos(omega);
      // The vector (a, b) of the section, turned, and the same vector a right angle further.
      const V r{co * x - so * y, so * x + co * y, z};
      const V n{co * s - so * n_y, so * s + co * n_y, n_z};
      Turned out;
      out.r = r, out.n = n;
      out.r_s = {co * x_s - so * y_s - omega_s * r[1], so * x_s + co * y_s + omega_s * r[0], z_s};
      out.n_s = {co * c - so * n_ys - omega_s * n[1], so * c + co * n_ys + omega_s * n[0], n_zs};
      out.r_p = {-omega_p * r[1], omega_p * r[0], rise};
      out.n_p = {-omega_p * n[1], omega_p * n[0], 0};
      return out;
    }
  };

  V turn(const V& v) const noexcept {
    return {turn_[0] * v[0] + turn_[1] * v[1] + turn_[2] * v[2],
            turn_[3] * v[0] + turn_[4] * v[1] + turn_[5] * v[2],
            turn_[6] * v[0] + turn_[7] * v[1] + turn_[8] * v[2]};
  }
  V moved(const V& r) const noexcept {
    const V t = turn(r);
    return {t[0] + shift_[0], t[1] + shift_[1], t[2] + shift_[2]};
  }

  /// Gaussian elimination with row pivots. Leaves the step in `value`. Returns false if singular.
  static bool eliminate(Equations& e) noexcept {
    auto& a = e.jacobian;
    auto& b = e.value;
    for (int k = 0; k < 5; ++k) {
      int pivot = k;
      for (int i = k + 1; i < 5; ++i) {
        if (std::fabs(a[5 * i + k]) > std::fabs(a[5 * pivot + k])) pivot = i;
      }
      if (a[5 * pivot + k] == 0) return false;
      if (pivot != k) {
        for (int j = k; j < 5; ++j) std::swap(a[5 * k + j], a[5 * pivot + j]);
        std::swap(b[k], b[pivot]);
      }
      const double inverse = 1 / a[5 * k + k];
      for (int i = k + 1; i < 5; ++i) {
        const double factor = a[5 * i + k] * inverse;
        for (int j = k + 1; j < 5; ++j) a[5 * i + j] -= factor * a[5 * k + j];
        b[i] -= factor * b[k];
      }
    }
    for (int i = 4; i >= 0; --i) {
      for (int j = i + 1; j < 5; ++j) b[i] -= a[5 * i + j] * b[j];
      b[i] /= a[5 * i + i];
    }
    return true;
  }

  Arc one_, two_;
  double per_length_;
  std::array<double, 9> turn_{};
  V shift_{};
};

}  // namespace gearwright::oracle::tca
