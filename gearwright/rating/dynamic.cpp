#include "gearwright/rating/dynamic.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>

#include "gearwright/base/contract.hpp"
#include "gearwright/base/numbers.hpp"
#include "gearwright/base/units.hpp"

namespace gearwright {

namespace {

constexpr double kSlow = 5.0,
                 kFast = 10.0;  // m/s; above kSlow `most_medium` applies, above kFast `most_fast`
// The fraction of a deviation that running-in removes, and the upper limits of the removed amount,
// µm, in two ranges of the pitch line velocity.
struct RunningIn {
  double share, most_medium, most_fast;
};

RunningIn running_in_of(const Material& m) {
  using K = MaterialKind;
  switch (m.kind) {
    case K::case_hardened:
    case K::induction_hardened:
    case K::nitrided:
    case K::nitrocarburized: return {0.075, 3.0, 3.0};
    case K::cast:
    case K::nodular_ferritic: return {0.275, 22.0, 11.0};
    case K::through_hardened:
    case K::normalized:
    case K::nodular:
    case K::malleable:
    case K::plastic: break;
  }
  return {160.0 / m.sigma_Hlim, 12800.0 / m.sigma_Hlim, 6400.0 / m.sigma_Hlim};
}

double running_in_of(const Material& m, double f, double v) {
  const RunningIn r = running_in_of(m);
  // On hardened flanks, running-in removes at most 3 µm at any speed.
  const double most = v > kFast              ? r.most_fast
                      : v > kSlow            ? r.most_medium
                      : m.surface_hardened() ? r.most_medium
                                             : kInfinity;
  return std::min({r.share * f, most, f});
}

// Constants C_v1 … C_v7 of the dynamic factor. [ISO 6336-1, table 4]
struct Constants {
  double v1 = 0.32, v2, v3, v4, v5 = 0.47, v6, v7;
};

Constants constants(double e) {
  Constants c{};
  if (e <= 2.0) {
    c.v2 = 0.34;
    c.v3 = 0.23;
    c.v4 = 0.90;
    c.v6 = 0.47;
  } else {
    c.v2 = 0.57 / (e - 0.3);
    c.v3 = 0.096 / (e - 1.56);
    c.v4 = (0.57 - 0.05 * e) / (e - 1.44);
    c.v6 = 0.12 / (e - 1.74);
  }
  c.v7 = e <= 1.5 ? 0.75 : e <= 2.5 ? 0.125 * std::sin(std::numbers::pi * (e - 2.0)) + 0.875 : 1.0;
  return c;
}

}  // namespace

double running_in(const std::array<Material, 2>& materials, double deviation, double velocity) {
  return (running_in_of(materials[0], deviation, velocity) +
          running_in_of(materials[1], deviation, velocity)) /
         2;
}

double running_in_relief(const std::array<Material, 2>& materials) {
  double sum = 0.0;
  for (const Material& m : materials) {
    const double s = m.sigma_Hlim / 97.0 - 18.45;
    sum += s * s / 18.0 + 1.5;
  }
  return sum / 2;
}

double reduced_mass(const RatedPair& pair, const std::array<Material, 2>& materials) {
  std::array<double, 2> m{};
  for (std::size_t i = 0; i < 2; ++i) {
    const RatedGear& g = pair.gears[i];
    const double d_m = (g.tip_form_diameter + g.root_diameter) / 2;
    const double rim = std::abs(std::pow(d_m, 4) - std::pow(g.bore, 4));
    GW_EXPECTS(materials[i].density.has_value());
    m[i] = std::numbers::pi / 8 * *materials[i].density * rim / (g.base_diameter * g.base_diameter);
  }
  return m[0] * m[1] / (m[0] + m[1]);
}

double resonance_begin(double specific_load) {
  return specific_load < 100.0 ? 0.5 + 0.35 * std::sqrt(specific_load / 100.0) : 0.85;
}

Dynamic dynamic_factor(const DynamicInput& in) {
  Dynamic d;
  d.n_E1 = {30000.0 / (std::numbers::pi * in.teeth) * std::sqrt(in.c_gamma_alpha / in.reduced_mass),
            "ISO 6336-1, 6.5.3, (6)", ""};
  const double N = in.speed / d.n_E1.value;
  d.N = {N, "ISO 6336-1, 6.5.3, (9)", ""};
  const Constants c = constants(in.epsilon_gamma);
  const double b_p = in.c_prime * in.pitch_error / in.specific_load;
  const double b_f = in.c_prime * in.profile_error / in.specific_load;
  const double b_k =
      in.tip_relief ? std::abs(1.0 - in.c_prime * *in.tip_relief / in.specific_load) : 1.0;
  const auto at_resonance = [&] { return c.v1 * b_p + c.v2 * b_f + c.v4 * b_k + 1.0; };
  const auto above = [&] { return c.v5 * b_p + c.v6 * b_f + c.v7; };
  if (N <= resonance_begin(in.specific_load)) {
    d.K_v = {N * (c.v1 * b_p + c.v2 * b_f + c.v3 * b_k) + 1.0, "ISO 6336-1, 6.5.4, (13), (14)",
             in.specific_load < 100.0 ? "subcritical, N ≤ N_S < 0.85" : "subcritical, N ≤ 0.85"};
  } else if (N <= 1.15) {
    d.K_v = {at_resonance(), "ISO 6336-1, 6.5.5, (20)", "main resonance, N_S < N ≤ 1.15"};
  } else if (N < 1.5) {
    const double end = above();
    d.K_v = {end + (at_resonance() - end) * (1.5 - N) / 0.35, "ISO 6336-1, 6.5.7, (22)",
             "intermediate, 1.15 < N < 1.5"};
  } else {
    d.K_v = {above(), "ISO 6336-1, 6.5.6, (21)", "supercritical, N ≥ 1.5"};
  }
  return d;
}

namespace {

constexpr double kC_M = 0.8;
constexpr double kSoftBelow = 100.0;  // N/mm; a smaller F_t K_A K_γ/b reduces c'

// c'_th = 1/q', q' = C_1 + C_2/z_n1 + C_3/z_n2 + C_4 x_1 + C_5 x_1/z_n1 + C_6 x_2 + C_7 x_2/z_n2
//                    + C_8 x_1² + C_9 x_2²
Factor tooth_stiffness(const RatedGear& g1, const RatedGear& g2) {
  const bool ring = g2.internal();
  const double inverse1 = 1 / g1.virtual_teeth;
  const double inverse2 = ring ? 0.0 : 1 / g2.virtual_teeth;
  const double x1 = g1.profile_shift;
  const double x2 = g2.profile_shift;
  const double q = 0.04723 + 0.15551 * inverse1 + 0.25791 * inverse2 - 0.00635 * x1 -
                   0.11654 * x1 * inverse1 - 0.00193 * x2 - 0.24188 * x2 * inverse2 +
                   0.00529 * x1 * x1 + 0.00182 * x2 * x2;
  return {1 / q, "ISO 6336-1, 9.3.1.1", ring ? "internal: 1/z_n2 = 0" : "external"};
}

double rack_factor(const RatedGear& gear, double alpha_n) {
  const double degrees = alpha_n / kRadPerDeg;
  return (1.0 + 0.5 * (1.2 - gear.tool.dedendum)) * (1.0 - 0.02 * (20.0 - degrees));
}

double body_factor(const std::optional<RatedBody>& body) {
  if (!body) return 1.0;
  const double web = std::clamp(body->web_share, 0.2, 1.2);
  return 1.0 + std::log(web) / (5.0 * std::exp(std::max(1.0, body->rim_modules) / 5.0));
}

}  // namespace

Stiffness mesh_stiffness(const RatedPair& pair, double specific_load, double elasticity,
                         const std::optional<RatedBody>& body) {
  const RatedGear& g1 = pair.gears[0];
  const RatedGear& g2 = pair.gears[1];
  Stiffness s{};
  const double sum = g1.profile_shift + g2.profile_shift;
  s.in_range = g1.profile_shift >= g2.profile_shift && sum >= -0.5 && sum <= 2.0;
  s.c_th = tooth_stiffness(g1, g2);
  s.C_R = body_factor(body);
  s.C_B = (rack_factor(g1, pair.alpha_n) + rack_factor(g2, pair.alpha_n)) / 2;
  double c = s.c_th.value * kC_M * s.C_R * s.C_B * std::cos(pair.beta) * elasticity;
  const bool soft = specific_load < kSoftBelow;
  if (soft) c *= std::pow(specific_load / kSoftBelow, 0.25);
  s.c_prime = {c, "ISO 6336-1, 9.3.1",
               soft ? "F_t K_A K_γ/b < 100 N/mm, so c' is multiplied by (F_t K_A K_γ/b/100)^0.25"
                    : "F_t K_A K_γ/b ≥ 100 N/mm"};
  s.c_gamma_alpha = {c * (0.75 * pair.epsilon_alpha + 0.25), "ISO 6336-1, 9.3.2",
                     pair.epsilon_alpha >= 1.2
                         ? "ε_α ≥ 1.2"
                         : "ε_α < 1.2, where the value may be up to 10 % lower"};
  s.c_gamma_beta = {0.85 * s.c_gamma_alpha.value, "ISO 6336-1, 9.3.2", ""};
  return s;
}

}  // namespace gearwright
