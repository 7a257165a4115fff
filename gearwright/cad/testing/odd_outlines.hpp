// Makes extreme outlines for tests of the CAD files. They have undercut teeth, one or two teeth, or
// the teeth of internal gears. They are derived from the geometry of a sharp-cornered rack, without
// the code of generation/.
//
//   m   module, mm     r = |z|m/2, r_b = r cos 20°     c   corner depth below the pitch line, mm
//   corner   W(p) = (r − c − ip) e^{i(p + y_c)/r},  y_c = πm/4 + c tan 20°
//            the path of the rack's sharp corner, p = 0 at the root, p > 0 towards the tip. Its
//            polar angle first decreases and then increases, which is the undercut
#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <utility>
#include <vector>

#include "gearwright/cad/testing/sample_outlines.hpp"

namespace gearwright::testing {

class CornerTrochoid final : public ComplexCurve {
 public:
  CornerTrochoid(double r, double c, double y_c) : r_(r), c_(c), y_c_(y_c) {}
  Jet jet(double p) const override {
    const C i(0, 1);
    const C e = std::polar(1.0, (p + y_c_) / r_);
    const C g(r_ - c_, -p);
    const C e1 = i / r_ * e, e2 = -e / (r_ * r_);
    return {g * e, -i * e + g * e1, -2.0 * i * e1 + g * e2};
  }

 private:
  double r_, c_, y_c_;
};

/// The flank of an external gear's tooth space serves as the flank of an internal gear's tooth.
/// This tooth becomes thicker outwards.
class RingInvolute final : public ComplexCurve {
 public:
  RingInvolute(double r_b, double psi_b) : r_b_(r_b), psi_b_(psi_b) {}
  Jet jet(double xi) const override {
    const C e = std::polar(r_b_, psi_b_ + xi);
    return {C(1, -xi) * e, xi * e, C(1, xi) * e};
  }

 private:
  double r_b_, psi_b_;
};

inline constexpr double kAlpha20 = 20 * kPi / 180;

/// Returns the polar angle of the involute flank at the radius ρ, measured from the centre line of
/// the tooth.
inline double flank_angle(int z, double r_b, double rho) {
  const double xi = std::sqrt(std::max(0.0, (rho / r_b - 1) * (rho / r_b + 1)));
  return kPi / (2 * z) + std::tan(kAlpha20) - kAlpha20 - (xi - std::atan(xi));
}

/// Returns an undercut tooth. It consists of the root circle, the trochoid of the corner, the
/// involute from its intersection with the trochoid, and the tip circle.
/// Domain    small z, so that the intersection lies between the base circle and the tip
inline ToothedBody undercut_body(int z, double m, double depth, double height, double twist,
                                 double width) {
  const double r = m * z / 2, r_b = r * std::cos(kAlpha20), c = depth * m;
  const double y_c = kPi * m / 4 + c * std::tan(kAlpha20);
  const double r_f = r - c, r_a = r + height * m;
  const auto p_at = [&](double rho) { return std::sqrt((rho - r_f) * (rho + r_f)); };
  const auto gap = [&](double rho) {
    const double p = p_at(rho);
    return (p + y_c) / r - std::atan(p / r_f) - flank_angle(z, r_b, rho);
  };
  double lo = r_b, hi = r_a;
  for (int i = 0; i < 100; ++i) (gap(0.5 * (lo + hi)) < 0 ? lo : hi) = 0.5 * (lo + hi);

  ToothedBody body{"undercut", {z, {}}, twist, width, std::nullopt, {}};
  Outline& o = body.outline;
  append(o, ArcName::root_land, std::make_shared<SampleCircle>(r_f), kPi / z, y_c / r);
  append(o, ArcName::root_fillet, std::make_shared<CornerTrochoid>(r, c, y_c), 0, p_at(lo));
  const auto roll = [&](double rho) { return std::sqrt((rho / r_b - 1) * (rho / r_b + 1)); };
  const double psi_b = flank_angle(z, r_b, r_b);
  append(o, ArcName::flank, std::make_shared<SampleInvolute>(r_b, psi_b), roll(lo), roll(r_a));
  append(o, ArcName::tip_land, std::make_shared<SampleCircle>(r_a), flank_angle(z, r_b, r_a), 0);
  return body;
}

/// Makes a body with one or two teeth. The outline consists of a root circle well inside the base
/// circle, a fillet, the involute, and a tip land. The fillet is tangent to the root circle and to
/// the radial line at the start of the involute. The involute starts 1e-9 rad beside its cusp, so
/// that the tangent can be computed from the derivative.
inline ToothedBody few_tooth_body(int z, double m, double twist, double width) {
  const double r = m * z / 2, r_b = r * std::cos(kAlpha20), r_f = 0.8 * r_b, r_a = r + 0.5 * m;
  const double rho = (r_b - r_f) * (r_b + r_f) / (2 * r_f);
  const double psi_b = flank_angle(z, r_b, r_b);
  const double centre = psi_b + std::asin(rho / (r_f + rho));

  class Fillet final : public ComplexCurve {
   public:
    Fillet(C centre, double rho) : centre_(centre), rho_(rho) {}
    Jet jet(double t) const override {
      const C w = std::polar(rho_, t);
      return {centre_ + w, C(0, 1) * w, -w};
    }

   private:
    C centre_;
    double rho_;
  };

  ToothedBody body{"few", {z, {}}, twist, width, std::nullopt, {}};
  Outline& o = body.outline;
  append(o, ArcName::root_land, std::make_shared<SampleCircle>(r_f), kPi / z, centre);
  append(o, ArcName::root_fillet, std::make_shared<Fillet>(std::polar(r_f + rho, centre), rho),
         centre + kPi, psi_b + 1.5 * kPi);
  append(o, ArcName::flank, std::make_shared<SampleInvolute>(r_b, psi_b), 1e-9,
         std::sqrt((r_a / r_b - 1) * (r_a / r_b + 1)));
  append(o, ArcName::tip_land, std::make_shared<SampleCircle>(r_a), flank_angle(z, r_b, r_a), 0);
  return body;
}

/// Makes an internal gear of |z| teeth with corners at root and tip. `rim` is the diameter of its
/// rim, mm.
inline ToothedBody ring_body(int z, double m, double twist, double width, double rim) {
  const double r = m * z / 2, r_b = r * std::cos(kAlpha20), r_f = r + 1.25 * m, r_a = r - 0.8 * m;
  const double psi_b = kPi / (2 * z) - (std::tan(kAlpha20) - kAlpha20);
  const auto roll = [&](double rho) { return std::sqrt((rho / r_b - 1) * (rho / r_b + 1)); };
  const auto angle = [&](double rho) { return psi_b + roll(rho) - std::atan(roll(rho)); };
  ToothedBody body{"ring", {-z, {}}, twist, width, Bore{rim}, {}};
  Outline& o = body.outline;
  append(o, ArcName::root_land, std::make_shared<SampleCircle>(r_f), kPi / z, angle(r_f));
  append(o, ArcName::flank, std::make_shared<RingInvolute>(r_b, psi_b), roll(r_f), roll(r_a));
  append(o, ArcName::tip_land, std::make_shared<SampleCircle>(r_a), angle(r_a), 0);
  return body;
}

/// Returns bodies with and without a bore and a keyway, with pointed, undercut and few teeth, and an
/// internal gear. `one_tooth` is one of them.
inline std::vector<ToothedBody> bodies_with(ToothedBody one_tooth) {
  ToothedBody keyed = sample_body({});
  keyed.bore = Bore{16.0, 5.0, 2.3};
  ToothedBody bored = sample_body({.teeth = 31, .beta = 0.3, .chamfer = 0.2});
  bored.bore = Bore{20.0};
  return {keyed,
          bored,
          sample_body({.pointed = true, .full_radius_root = true}),
          undercut_body(8, 2.0, 1.25, 0.8, 0.0, 10.0),
          std::move(one_tooth),
          few_tooth_body(2, 5.0, 0.0, 10.0),
          ring_body(40, 2.0, 0.0, 10.0, 100.0)};
}

}  // namespace gearwright::testing
