#include <fmt/format.h>

#include <cmath>

#include "gearwright/base/numbers.hpp"
#include "gearwright/base/testing/draw.hpp"
#include "gearwright/generation/rack_envelope.hpp"
#include "tests/accuracy/ledger.hpp"

namespace gearwright::ledger {

namespace {

using testing::Draw;

double distance(const Vec2& got, const Plane<Exact>& exact) {
  const Exact dx = Exact(got.x()) - exact.x, dy = Exact(got.y()) - exact.y;
  return static_cast<double>(sqrt(dx * dx + dy * dy));
}

Plane<Exact> in_50_digits(const Complex& w) { return {Exact(w.real()), Exact(w.imag())}; }

Exact norm(const Plane<Exact>& w) { return w.x * w.x + w.y * w.y; }

// |got − exact|/|exact|.
double error_of(const Complex& got, const Plane<Exact>& exact) {
  const auto [x, y] = in_50_digits(got);
  return static_cast<double>(sqrt(norm(Plane<Exact>{x - exact.x, y - exact.y}) / norm(exact)));
}

// The difference of two directions, rad, without full turns.
double turn_between(const Exact& a, const Exact& b) {
  return static_cast<double>(abs(atan2(sin(a - b), cos(a - b))));
}

// arg(unit) + phase + arg(ℓ′), the direction of dW/dt = W ℓ′.
Exact tangent_of(const Plane<Exact>& unit, const Exact& phase, const Plane<Exact>& d1) {
  return atan2(unit.y, unit.x) + phase + atan2(d1.y, d1.x);
}

// Im(conj(W′) W″)/|W′|³ with W′ = W ℓ′ and W″ = W (ℓ′² + ℓ″).
Exact curvature_of(const jets::RackTrochoid<Exact>& j) {
  const auto [d1, d2] = j.log_slopes();
  const Plane<Exact> square = times(d1, d1);
  const Plane<Exact> bend = times<Exact>({d1.x, -d1.y}, {square.x + d2.x, square.y + d2.y});
  const Exact speed = sqrt(norm(d1));
  return bend.y / (sqrt(norm(j.factor())) * speed * speed * speed);
}

}  // namespace

std::vector<Row> curve_rows() {
  constexpr int kInputs = 4000;
  const std::string of_involute = fmt::format("ξ ±0.01…±2, ψ_b 0…0.5, {} inputs", kInputs);
  Row point{"involute.point", of_involute, "of r", 2e-15, 0.0, ""};
  Row jet{"involute.jet", of_involute, "relative", 1e-15, 0.0, ""};
  Draw draw(20260301);
  for (int i = 0; i < kInputs; ++i) {
    const double r_b = draw.uniform(1.0, 200.0), psi_b = draw.uniform(0.0, 0.5);
    const double xi = (i % 2 == 0 ? 1.0 : -1.0) * draw.uniform(0.01, 2.0);
    const Involute curve(r_b, psi_b);
    const jets::Involute<Exact> exact{r_b, psi_b, xi};
    const jets::LogSlopes<Exact> slopes = exact.log_slopes();
    const PolarJet got = polar_jet(curve.jet(xi));
    const std::string w = fmt::format("r_b {:.6g}, ψ_b {:.6g}, ξ {:.6g}", r_b, psi_b, xi);
    point.see(distance(curve.point(xi), exact.point()) / r_b, w);
    jet.see(error_of(got.d1, slopes.d1), w);
    jet.see(error_of(got.d2, slopes.d2), w);
  }
  return {point, jet};
}

// The jet is computed in 50 digits. Tangents and curvatures are compared with those that follow from
// its log_slopes(), which have formulas of their own.
std::vector<Row> trochoid_rows() {
  constexpr int kInputs = 20000;
  const std::string where = fmt::format(
      "m_n 1, r 3…100, β 0…45°, corners and rounded tips of racks, τ 10…89°, {} inputs", kInputs);
  Row point{"rack_trochoid.point", where, "of r", 2e-15, 0.0, ""};
  Row tangent{"rack_trochoid.tangent", where, "rad", 1e-15, 0.0, ""};
  Row curvature{"rack_trochoid.curvature", where, "relative", 2e-15, 0.0, ""};
  Row jet{"rack_trochoid.jet", where + "; tangent from ℓ′", "rad", 1e-13, 0.0, ""};
  Draw draw(20260302);
  for (int i = 0; i < kInputs; ++i) {
    const RackMotion motion{draw.uniform(3.0, 100.0), std::cos(draw.uniform(0.0, kPi / 4)),
                            draw.uniform(-0.5, 0.5)};
    const double q = i % 4 == 0 ? 0.0 : -draw.uniform(0.05, 0.6);
    const EdgeCircle circle{{-draw.uniform(0.6, 1.5), draw.uniform(0.1, 1.5)}, q, {}, {}};
    const RackTrochoid curve(motion, circle);
    const double tau = draw.uniform(0.175, 1.55);
    const jets::RackTrochoid<Exact> exact{{motion.pitch_radius,
                                           motion.cos_beta,
                                           {circle.center.x() + motion.shift, circle.center.y()},
                                           q},
                                          sin(Exact(tau)),
                                          cos(Exact(tau))};
    const PolarJet j = polar_jet(curve.jet(tau));
    const CurvePoint p = curve.at(tau);
    const Exact direction = tangent_of(exact.factor(), exact.phase(), exact.log_slopes().d1);
    const std::string w =
        fmt::format("r {:.6g}, cos β {:.6g}, e {:.6g}, centre {:.6g} {:.6g}, q {:.6g}, τ {:.6g}",
                    motion.pitch_radius, motion.cos_beta, motion.shift, circle.center.x(),
                    circle.center.y(), q, tau);
    point.see(distance(p.point, exact.point()) / motion.pitch_radius, w);
    tangent.see(turn_between(Exact(p.tangent_angle), direction), w);
    curvature.see(relative_error(p.curvature, curvature_of(exact)), w);
    jet.see(turn_between(tangent_of(in_50_digits(j.factor), Exact(j.phase), in_50_digits(j.d1)),
                         direction),
            w);
  }
  return {point, tangent, curvature, jet};
}

}  // namespace gearwright::ledger
