#include "gearwright/rating/stiffness.hpp"

#include <algorithm>
#include <cmath>

#include "gearwright/base/units.hpp"

namespace gearwright {

namespace {

constexpr double kC_M = 0.8;
constexpr double kSoftBelow = 100.0;  // N/mm

// q' = C_1 + C_2/z_n1 + C_3/z_n2 + C_4 x_1 + C_5 x_1/z_n1 + C_6 x_2 + C_7 x_2/z_n2 + C_8 x_1² + C_9 x_2²
double flexibility(const RatedGear& g1, const RatedGear& g2) {
  const double inverse1 = 1 / g1.virtual_teeth;
  const double inverse2 = g2.internal() ? 0.0 : 1 / g2.virtual_teeth;
  const double x1 = g1.profile_shift;
  const double x2 = g2.profile_shift;
  return 0.04723 + 0.15551 * inverse1 + 0.25791 * inverse2 - 0.00635 * x1 -
         0.11654 * x1 * inverse1 - 0.00193 * x2 - 0.24188 * x2 * inverse2 + 0.00529 * x1 * x1 +
         0.00182 * x2 * x2;
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
  s.c_th = {1 / flexibility(g1, g2), "ISO 6336-1, 9.3.1.1",
            pair.internal() ? "internal: 1/z_n2 = 0" : "external"};
  s.C_R = body_factor(body);
  s.C_B = (rack_factor(g1, pair.alpha_n) + rack_factor(g2, pair.alpha_n)) / 2;
  double c = s.c_th.value * kC_M * s.C_R * s.C_B * std::cos(pair.beta) * elasticity;
  const bool soft = specific_load < kSoftBelow;
  if (soft) c *= std::pow(specific_load / kSoftBelow, 0.25);
  s.c_prime = {
      c, "ISO 6336-1, 9.3.1",
      soft ? "F_t K_A/b < 100 N/mm, multiplied by (F_t K_A/b/100)^0.25" : "F_t K_A/b ≥ 100 N/mm"};
  s.c_gamma_alpha = {c * (0.75 * pair.epsilon_alpha + 0.25), "ISO 6336-1, 9.3.2",
                     pair.epsilon_alpha >= 1.2
                         ? "ε_α ≥ 1.2"
                         : "ε_α < 1.2, where the value may be up to 10 % lower"};
  s.c_gamma_beta = {0.85 * s.c_gamma_alpha.value, "ISO 6336-1, 9.3.2", ""};
  return s;
}

}  // namespace gearwright
