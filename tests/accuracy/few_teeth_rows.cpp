#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "gearwright/base/testing/draw.hpp"
#include "gearwright/generation/circular_fillets.hpp"
#include "gearwright/generation/pinion_envelope.hpp"
#include "tests/accuracy/ledger.hpp"

namespace gearwright::ledger {

namespace {

using testing::Draw;

struct Circle {
  Exact radius, distance;
};

// The circle that touches the involute at ξ and whose centre lies on the ray with the polar angle
// γ. It is computed in coordinates: the normal of the flank at ξ is intersected with the ray. No
// triangle is solved.
Circle circle_on_ray(double r_b, double psi_b, double xi, const Exact& gamma) {
  const Exact delta = Exact(psi_b) - Exact(xi);
  const Exact c = cos(delta), s = sin(delta);
  const Exact x = Exact(r_b) * (c - Exact(xi) * s), y = Exact(r_b) * (s + Exact(xi) * c);
  // t is the length along the normal (−s, c) from (x, y) to the ray u (cos γ, sin γ).
  const Exact cg = cos(gamma), sg = sin(gamma);
  const Exact t = (x * sg - y * cg) / (s * sg + c * cg);
  const Exact px = x - t * s, py = y + t * c;
  return {abs(t), sqrt(px * px + py * py)};
}

}  // namespace

// Circular fillets are compared with circles computed in coordinates, and points of pinion envelopes
// with their jet in 50 digits.
std::vector<Row> few_teeth_rows() {
  constexpr int kInputs = 4000;
  const std::string where =
      fmt::format("z 1…12, ψ_b 0.1…1 of π/z, C and J on the flank, {} inputs", kInputs);
  Row root{"fillet.root_radius", where, "of D", 2e-14, 0.0, ""};
  Row end{"fillet.root_end", where, "of D", 2e-14, 0.0, ""};
  Row tip{"fillet.tip_radius", where, "of D", 2e-14, 0.0, ""};
  Row tip_end{"fillet.tip_end", where, "of D", 2e-14, 0.0, ""};
  Draw draw(20260214);
  const Exact pi = boost::math::constants::pi<Exact>();
  for (int i = 0; i < kInputs; ++i) {
    const int z = draw.whole(1, 12);
    const double r_b = draw.uniform(1.0, 50.0);
    const double psi_b = draw.uniform(0.1, 1.0) * std::numbers::pi / z;
    const Involute flank(r_b, psi_b);
    const double xi = draw.uniform(0.0, 1.2);
    const std::string w = fmt::format("z {}, ψ_b {:.6g}, ξ {:.6g}", z, psi_b, xi);
    if (const auto arc = root_fillet_at(flank, z, xi); arc && arc->distance < 20 * r_b) {
      const Circle exact = circle_on_ray(r_b, psi_b, xi, pi / z);
      root.see(static_cast<double>(abs(Exact(arc->radius) - exact.radius) / exact.distance), w);
      end.see(static_cast<double>(abs(Exact(arc->end) - (exact.distance - exact.radius)) /
                                  exact.distance),
              w);
    }
    if (const auto arc = tip_fillet_at(flank, xi); arc && arc->distance < 20 * r_b) {
      const Circle exact = circle_on_ray(r_b, psi_b, xi, Exact(0));
      tip.see(static_cast<double>(abs(Exact(arc->radius) - exact.radius) / exact.distance), w);
      tip_end.see(static_cast<double>(abs(Exact(arc->end) - (exact.distance + exact.radius)) /
                                      exact.distance),
                  w);
    }
  }
  return {root, end, tip, tip_end};
}

// [T6.8] for convex and concave arcs of a cutter, external and internal gears.
std::vector<Row> pinion_envelope_rows() {
  constexpr int kInputs = 4000;
  const std::string where = fmt::format(
      "z_0 1…40, z 5…200 and rings, arcs about any point inside the centrode, {} inputs", kInputs);
  Row row{"pinion_envelope.point", where, "of r_g", 4e-14, 0.0, ""};
  Draw draw(20260215);
  for (int i = 0; i < kInputs; ++i) {
    const int z0 = draw.whole(1, 40);
    const bool ring = i % 3 == 0;
    const int z = ring ? -draw.whole(z0 + 8, 240) : draw.whole(5, 200);
    const double e = draw.uniform(0.48, 0.52) * std::abs(z0 + z);
    const PinionMotion motion{z0, z, e};
    const double d = draw.uniform(0.3, 0.95) * motion.cutter_pitch_radius();
    const double gamma = draw.uniform(0.0, 0.5) * std::numbers::pi / z0;
    const double r = draw.uniform(0.05, 0.5);
    const bool hollow = i % 2 == 0;
    const double t = gamma + draw.uniform(0.05, 1.2) - (hollow ? std::numbers::pi : 0.0);
    const Walk walk = hollow ? Walk::forward : Walk::backward;
    const PinionEnvelope curve(motion, std::make_shared<OffsetCircle>(d, gamma, r), walk);
    const Vec2 got = curve.point(t);
    const jets::PinionWay<Exact> way(motion, walk, Meeting::ahead);
    const jets::OffsetCircle<Exact> c{d, gamma, r, t};
    const jets::PinionEnvelope<Exact> exact{
        way, {way, c.point(), c.tangent_angle(), c.curvature()}, c.polar_angle()};
    const Exact dx = Exact(got.x()) - exact.point().x, dy = Exact(got.y()) - exact.point().y;
    row.see(
        static_cast<double>(sqrt(dx * dx + dy * dy) / abs(way.r_g)),
        fmt::format("z_0 {}, z {}, a {:.6g}, D {:.6g}, γ {:.6g}, t {:.6g}", z0, z, e, d, gamma, t));
  }
  return {row};
}

}  // namespace gearwright::ledger
