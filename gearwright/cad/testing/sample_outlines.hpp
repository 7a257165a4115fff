// Outlines of teeth that are cut by a rack, for tests of the CAD files. The outlines are computed
// by the formulas below, without the code of generation/.
//
//   z      teeth          m, α   transverse module, mm, and pressure angle, rad     r = mz/2
//   h_a, h_f, ρ           addendum, dedendum and tip radius of the cutter, in modules
//   flank   W(ξ) = r_b (1 + iξ) e^{i(ψ_b − ξ)},  ψ_b = π/2z + inv α
//   fillet  W(ψ) = e^{i(π/z − φ)} (r − i k e^{−iψ}),  k = h_c/sin ψ + ρm,  φ = (x_c − h_c cot ψ)/r,
//           ψ is the angle of the normal through the pitch point, from π/2 at the root to α. The
//           centre of the cutter's tip circle is h_c below the datum line and x_c from the middle
//           of the space
#pragma once

#include <algorithm>
#include <cmath>
#include <complex>
#include <memory>
#include <utility>
#include <vector>

#include "gearwright/base/numbers.hpp"
#include "gearwright/cad/toothed_body.hpp"
#include "gearwright/curve/curve.hpp"

namespace gearwright::testing {

using C = std::complex<double>;

inline Vec2 vec(C w) { return {w.real(), w.imag()}; }

/// A curve defined by its point and its first two derivatives, as complex numbers.
class ComplexCurve : public Curve {
 public:
  struct Jet {
    C w, d1, d2;
  };
  virtual Jet jet(double t) const = 0;
  Vec2 point(double t) const final { return vec(jet(t).w); }
  CurvePoint at(double t) const final {
    const Jet j = jet(t);
    const double speed = std::abs(j.d1);
    return {vec(j.w), std::arg(j.d1), (std::conj(j.d1) * j.d2).imag() / (speed * speed * speed)};
  }
};

class SampleCircle final : public ComplexCurve {
 public:
  explicit SampleCircle(double r) : r_(r) {}
  Jet jet(double t) const override {
    const C w = std::polar(r_, t);
    return {w, C(0, 1) * w, -w};
  }

 private:
  double r_;
};

class SampleInvolute final : public ComplexCurve {
 public:
  SampleInvolute(double r_b, double psi_b) : r_b_(r_b), psi_b_(psi_b) {}
  Jet jet(double xi) const override {
    const C e = std::polar(r_b_, psi_b_ - xi);
    return {C(1, xi) * e, xi * e, C(1, -xi) * e};
  }

 private:
  double r_b_, psi_b_;
};

class SampleTrochoid final : public ComplexCurve {
 public:
  SampleTrochoid(int z, double r, double h_c, double x_c, double rho)
      : z_(z), r_(r), h_c_(h_c), x_c_(x_c), rho_(rho) {}
  Jet jet(double psi) const override {
    const C i(0, 1);
    const double s = std::sin(psi), c = std::cos(psi);
    const double k = h_c_ / s + rho_;
    const double k1 = -h_c_ * c / (s * s), k2 = h_c_ * (1 + c * c) / (s * s * s);
    const double f1 = h_c_ / (s * s) / r_, f2 = -2 * h_c_ * c / (s * s * s) / r_;  // φ', φ''
    const C e = std::polar(1.0, kPi / z_ - (x_c_ - h_c_ * c / s) / r_);
    const C e1 = -i * f1 * e, e2 = -i * f2 * e - f1 * f1 * e;
    const C q = std::polar(1.0, -psi);
    const C g = r_ - i * k * q;
    const C g1 = -i * (k1 - i * k) * q;
    const C g2 = -i * (k2 - 2.0 * i * k1 - k) * q;
    return {e * g, e1 * g + e * g1, e2 * g + 2.0 * e1 * g1 + e * g2};
  }

 private:
  int z_;
  double r_, h_c_, x_c_, rho_;
};

class SampleLine final : public ComplexCurve {
 public:
  SampleLine(C a, C b) : a_(a), d_(b - a) {}
  Jet jet(double t) const override { return {a_ + t * d_, d_, 0.0}; }

 private:
  C a_, d_;
};

struct SampleGear {
  int teeth = 20;
  double normal_module = 2.0;
  double beta = 0.0;  ///< rad, > 0 right hand
  double face_width = 20.0;
  double addendum = 1.0;
  double dedendum = 1.25;
  double tip_radius = 0.38;
  double chamfer = 0.0;  ///< radial height of a straight chamfer, mm
  bool pointed = false;  ///< true if the tooth ends where its flanks meet; no addendum is then used
  bool full_radius_root = false;  ///< true if tip_radius is chosen so that no root land remains
};

inline void append(Outline& outline, ArcName name, std::shared_ptr<const Curve> curve, double begin,
                   double end) {
  const Vec2 from = outline.arcs.empty() ? curve->point(begin) : outline.arcs.back().end_point;
  const Vec2 to = curve->point(end);
  outline.arcs.push_back({name, std::move(curve), begin, end, from, to});
}

/// Returns the roll angle at which the two flanks of a tooth meet, ξ − atan ξ = ψ_b. ψ_b is the
/// half angle of the tooth on the base circle.
inline double pointed_roll(double psi_b) {
  double xi = std::cbrt(3 * psi_b);
  for (int i = 0; i < 50; ++i) xi -= (xi - std::atan(xi) - psi_b) * (1 + 1 / (xi * xi));
  return xi;
}

/// Domain    no undercut; the form point of the fillet then lies outside the base circle
inline ToothedBody sample_body(const SampleGear& g) {
  const int z = g.teeth;
  const double m = g.normal_module / std::cos(g.beta);
  const double alpha = std::atan(std::tan(20 * kPi / 180) / std::cos(g.beta));
  const double r = m * z / 2, r_b = r * std::cos(alpha);
  const double sin_a = std::sin(alpha), cos_a = std::cos(alpha), tan_a = std::tan(alpha);
  const double h_f = g.dedendum * g.normal_module;
  double rho = g.tip_radius * g.normal_module;
  if (g.full_radius_root) {
    rho = (kPi * m / 4 - h_f * tan_a) / (cos_a - (1 - sin_a) * tan_a);
  }
  const double h_c = h_f - rho;
  const double h_form = h_f - rho * (1 - sin_a);
  const double x_c = g.full_radius_root ? 0 : kPi * m / 4 - h_form * tan_a - rho * cos_a;
  const double psi_b = kPi / (2 * z) + tan_a - alpha;
  const double r_form = std::hypot(r - h_form, h_form / tan_a);
  const double xi_form = std::sqrt((r_form / r_b - 1) * (r_form / r_b + 1));
  const double r_a = r + g.addendum * g.normal_module;
  const double r_end = r_a - g.chamfer;
  const double xi_end =
      g.pointed ? pointed_roll(psi_b) : std::sqrt((r_end / r_b - 1) * (r_end / r_b + 1));

  ToothedBody body{"gear", {z, {}}, std::tan(g.beta) / r, g.face_width, std::nullopt, {}};
  Outline& o = body.outline;
  if (!g.full_radius_root) {
    append(o, ArcName::root_land, std::make_shared<SampleCircle>(r - h_f), kPi / z,
           kPi / z - x_c / r);
  }
  append(o, ArcName::root_fillet, std::make_shared<SampleTrochoid>(z, r, h_c, x_c, rho), kPi / 2,
         alpha);
  append(o, ArcName::flank, std::make_shared<SampleInvolute>(r_b, psi_b), xi_form, xi_end);
  if (g.chamfer > 0) {
    const Vec2 p = o.arcs.back().end_point;
    const double angle = std::atan2(p.y(), p.x()) - g.chamfer / r_a;
    append(o, ArcName::tip_fillet,
           std::make_shared<SampleLine>(C(p.x(), p.y()), std::polar(r_a, angle)), 0, 1);
  }
  if (!g.pointed) {
    const Vec2 p = o.arcs.back().end_point;
    append(o, ArcName::tip_land, std::make_shared<SampleCircle>(p.norm()), std::atan2(p.y(), p.x()),
           0);
  }
  return body;
}

/// Makes the simplest outline, in which straight flanks join the lands. It also represents internal
/// gears (teeth < 0, root > tip).
inline ToothedBody plain_body(int teeth, double r_root, double root_angle, double r_tip,
                              double tip_angle, double face_width = 10.0, double twist = 0.0) {
  ToothedBody body{"plain", {teeth, {}}, twist, face_width, std::nullopt, {}};
  Outline& o = body.outline;
  const double space = kPi / std::abs(teeth);
  append(o, ArcName::root_land, std::make_shared<SampleCircle>(r_root), space, root_angle);
  const Vec2 p = o.arcs.back().end_point;
  append(o, ArcName::flank,
         std::make_shared<SampleLine>(C(p.x(), p.y()), std::polar(r_tip, tip_angle)), 0, 1);
  append(o, ArcName::tip_land, std::make_shared<SampleCircle>(r_tip), tip_angle, 0);
  return body;
}

/// Returns the area of plain_body's outline, which consists of circle sectors and triangles.
inline double plain_area(int teeth, double r_root, double root_angle, double r_tip,
                         double tip_angle) {
  const int z = std::abs(teeth);
  return z * ((kPi / z - root_angle) * r_root * r_root +
              r_root * r_tip * std::sin(root_angle - tip_angle) + tip_angle * r_tip * r_tip);
}

}  // namespace gearwright::testing
