#include <fmt/format.h>

#include <cmath>
#include <random>

#include "gearwright/contact/contact.hpp"
#include "tests/accuracy/ledger.hpp"

namespace gearwright::ledger {

namespace {

struct Drive {
  int z1, z2;
  double module, helix_deg;
  ArcRack f, p;
};

Result<Gear> cut(int teeth, double module, double helix_deg, const ArcRack& rack) {
  CylindricalSpec s;
  s.teeth = teeth;
  s.normal_module = module;
  s.helix_angle = Angle::degrees(helix_deg);
  s.face_width = 4.0 * module / std::sin(std::abs(s.helix_angle.rad()));  // 1.27 axial pitches
  s.rack = rack;
  return make_gear(s);
}

// The data of the pair in 50 digits, lengths in modules.
struct ExactDrive {
  Exact r1, r2, lambda, rho_f, a_f, b_f, rho_p, a_p, b_p;

  explicit ExactDrive(const Drive& d) {
    const Exact beta = Exact(d.helix_deg) * boost::math::constants::degree<Exact>();
    lambda = boost::math::constants::half_pi<Exact>() - beta;
    r1 = Exact(d.z1) / (2 * cos(beta));
    r2 = Exact(d.z2) / (2 * cos(beta));
    rho_f = d.f.arc_radius;
    a_f = d.f.center_a;
    b_f = d.f.center_b;
    rho_p = d.p.arc_radius;
    a_p = d.p.center_a;
    b_p = d.p.center_b;
  }

  Exact racks_apart(const Exact& theta) const { return (rho_f - rho_p) * sin(theta) - (b_f - b_p); }

  // Solves (C0 + w)² + (w cot θ sin λ)² = (C0 + ΔC)² for θ by Newton's method, starting from a
  // result in double. [T7.16]
  Exact angle(double guess, const Exact& delta) const {
    const Exact c0 = r1 + r2;
    const auto f = [&](const Exact& theta) {
      const Exact w = racks_apart(theta);
      const Exact y = w / tan(theta) * sin(lambda);
      return Exact((c0 + w) * (c0 + w) + y * y - (c0 + delta) * (c0 + delta));
    };
    Exact theta = guess;
    const Exact h = Exact("1e-20");
    for (int i = 0; i < 6; ++i) theta -= f(theta) * 2 * h / (f(theta + h) - f(theta - h));
    return theta;
  }

  // Transmission error due to a changed centre distance alone, computed from the meshing of both
  // racks.
  Exact te(const Exact& theta) const {
    const Exact w = racks_apart(theta);
    const Exact mu = atan2(w / tan(theta) * sin(lambda), r1 + r2 + w);
    const Exact along = (rho_f - rho_p) * cos(theta) * cos(lambda) - (a_f - a_p) / cos(lambda) +
                        (b_f - b_p) / tan(theta) * sin(lambda) * tan(lambda);
    return mu * (r1 / r2 + 1) + along / (r2 * tan(lambda));
  }

  // K_2 − K_1 at contact without errors. The principal values follow from trace and determinant.
  // [T7.14]
  std::array<Exact, 2> gap_curvature(const Exact& psi) const {
    const Exact sl = sin(lambda), cl = cos(lambda), sp = sin(psi);
    std::array<Exact, 3> gap{0, 0, 0};
    for (const int gear : {1, 2}) {
      const Exact rho = gear == 1 ? rho_f : rho_p;
      const Exact b = gear == 1 ? b_f : b_p;
      const Exact s = gear == 1 ? 1 : -1;
      const Exact l = rho - b / sp;
      const Exact k = 1 - l / rho;
      const Exact d = s * (gear == 1 ? r1 : r2) * sp + l * (sl * sl * k + sp * sp * cl * cl);
      gap[0] -= s * (-1 / rho - sl * sl * k * k / d);
      gap[1] -= s * (-sl * k * sp * cl / d);
      gap[2] -= s * (-sp * sp * cl * cl / d);
    }
    const Exact mean = (gap[0] + gap[2]) / 2;
    const Exact half = (gap[0] - gap[2]) / 2;
    const Exact root = sqrt(half * half + gap[1] * gap[1]);
    return {mean - root, mean + root};
  }
};

}  // namespace

// The search for the greatest gap uses only the outline. For circular arcs, it is compared with
// their closed forms.
std::vector<Row> contact_rows() {
  constexpr int kInputs = 300;
  const std::string where = fmt::format(
      "circular arcs, z1 8…40, z2 ≤ 120, β 8…35°, ρ_P − ρ_F 0.08…0.3, {} drives", kInputs);
  Row te{"contact.transmission_error", where + ", ΔC", "rad", 1e-14, 0.0, ""};
  Row angle{"contact.rack_angle", where + ", ΔC", "rad", 1e-11, 0.0, ""};
  Row k1{"contact.gap_curvature_1", where, "relative", 1e-10, 0.0, ""};
  Row k2{"contact.gap_curvature_2", where, "relative", 1e-11, 0.0, ""};
  std::mt19937_64 random(20261121);
  const auto uniform = [&](double lo, double hi) {
    return lo + (hi - lo) * (static_cast<double>(random() >> 11) * 0x1p-53);
  };
  for (int drives = 0; drives < kInputs;) {
    Drive d{};
    d.z1 = 8 + static_cast<int>(random() % 33);
    d.z2 = d.z1 + static_cast<int>(random() % (121 - d.z1));
    d.module = uniform(0.5, 12);
    d.helix_deg = uniform(8, 35);
    const double psi = uniform(24, 34) * 0.017453292519943295;
    const double more = uniform(0.08, 0.3);
    d.f = default_arc_rack(ArcRack::Cutter::F);
    d.f.arc_radius = uniform(1.25, 1.55);
    d.f.center_a = d.f.arc_radius * std::cos(psi) - 0.79;
    d.f.center_b = d.f.arc_radius * std::sin(psi) - uniform(0.4, 0.5);
    d.p = default_arc_rack(ArcRack::Cutter::P);
    d.f.root_fillet_radius = d.p.root_fillet_radius = 0.2;  // this radius fits into every cutter
                                                            // here
    d.p.arc_radius = d.f.arc_radius + more;
    d.p.center_a = d.f.center_a + more * std::cos(psi);
    d.p.center_b = d.f.center_b + more * std::sin(psi);
    const auto g1 = cut(d.z1, d.module, d.helix_deg, d.f);
    const auto g2 = cut(d.z2, d.module, -d.helix_deg, d.p);
    if (!g1 || !g2) continue;  // the rack does not form a closed outline
    ++drives;
    ContactMount place;
    place.center_distance = (g1->reference_diameter + g2->reference_diameter) / 2;
    const std::string input = fmt::format("z {}:{}, m {}, β {}, ρ_F {}", d.z1, d.z2, d.module,
                                          d.helix_deg, d.f.arc_radius);
    const ExactDrive exact(d);
    ContactRequest request;
    request.rotations = {Angle()};
    for (const double delta : {0.0, uniform(-0.1, 0.1) * more}) {
      place.errors.center_distance = delta * d.module;
      const ContactPair pair({&*g1}, {&*g2}, place);
      const ContactPoint p = analyse_contact(pair, request).positions[0];
      if (p.kind != TouchKind::interior) continue;
      const Exact true_delta = Exact(place.errors.center_distance) / Exact(d.module);
      const Exact theta = exact.angle(p.rack_angle->rad(), true_delta);
      angle.see(std::abs(static_cast<double>(Exact(p.rack_angle->rad()) - theta)), input);
      te.see(std::abs(static_cast<double>(Exact(p.te.rad()) - exact.te(theta))), input);
      if (delta != 0.0) continue;
      const auto k = exact.gap_curvature(theta);
      k1.see(relative_error((*p.gap_curvature)[0] * d.module, k[0]), input);
      k2.see(relative_error((*p.gap_curvature)[1] * d.module, k[1]), input);
    }
  }
  return {te, angle, k1, k2};
}

}  // namespace gearwright::ledger
