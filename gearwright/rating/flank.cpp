#include "gearwright/rating/flank.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "gearwright/base/numbers.hpp"

namespace gearwright {

namespace {

constexpr double kTwoPi = 2 * std::numbers::pi;
constexpr double kNoRoll = 1e-9;  // rad; a smaller roll angle is 0 within rounding

// Returns C_ZL, which is constant below 850 and above 1200 N/mm².
double film_constant(double sigma_Hlim) {
  return 0.83 + 0.08 * (std::clamp(sigma_Hlim, 850.0, 1200.0) - 850.0) / 350.0;
}

const char* film_branch(double sigma_Hlim) {
  return sigma_Hlim < 850.0    ? "σ_Hlim < 850 N/mm²"
         : sigma_Hlim > 1200.0 ? "σ_Hlim > 1200 N/mm²"
                               : "850 ≤ σ_Hlim ≤ 1200 N/mm²";
}

bool steel_without_hard_surface(const Material& m) {
  return m.kind == MaterialKind::through_hardened || m.kind == MaterialKind::normalized;
}

// Returns the radius of relative curvature at the pitch point, ρ_red, mm.
double pitch_curvature(const RatedPair& pair) {
  const double t = std::tan(pair.alpha_wt) / 2;
  const double rho1 = pair.gears[0].base_diameter * t;
  const double rho2 = pair.gears[1].base_diameter * t * pair.gears[1].side();
  return rho1 * rho2 / (rho1 + rho2);
}

}  // namespace

Factor zone_factor(const RatedPair& pair) {
  const double c = std::cos(pair.alpha_t);
  return {std::sqrt(2 * std::cos(pair.beta_b) * std::cos(pair.alpha_wt) /
                    (c * c * std::sin(pair.alpha_wt))),
          "ISO 6336-2, 6.1", ""};
}

FactorPair single_contact_factors(const RatedPair& pair) {
  constexpr const char* formula = "ISO 6336-2, 6.2";
  if (!pair.spur() && pair.epsilon_beta >= 1.0) {
    const Factor one{1.0, formula, "helical, ε_β ≥ 1"};
    return {one, one};
  }
  // Roll angles at the active tip, and the angular pitch, which is negative for an internal gear.
  std::array<double, 2> roll{}, step{};
  for (std::size_t i = 0; i < 2; ++i) {
    const RatedGear& g = pair.gears[i];
    const double q = g.tip_diameter / g.base_diameter;
    roll[i] = std::sqrt(std::max(0.0, q * q - 1));
    step[i] = kTwoPi / g.teeth;
  }
  // Single pair contact begins one pitch before the path ends. If the path is shorter than a pitch,
  // it begins where the path begins.
  const double back = std::min(1.0, pair.epsilon_alpha);
  const double more = std::max(1.0, pair.epsilon_alpha) - 1;
  const auto m = [&](std::size_t own, std::size_t mate) {
    const double roll_own = roll[own] - back * step[own];
    const double roll_mate = roll[mate] - more * step[mate];
    if (std::min(roll_own, roll_mate) <= kNoRoll) return kInfinity;
    return std::tan(pair.alpha_wt) / std::sqrt(roll_own * roll_mate);
  };
  const auto factor = [&](std::size_t own) -> Factor {
    if (pair.gears[own].internal()) return {1.0, formula, "1 for an internal gear"};
    const double m_i = m(own, 1 - own);
    if (pair.spur())
      return {std::max(1.0, m_i), formula, m_i > 1.0 ? "spur, M > 1" : "spur, M ≤ 1"};
    return {std::max(1.0, m_i - pair.epsilon_beta * (m_i - 1)), formula, "helical, ε_β < 1"};
  };
  return {factor(0), factor(1)};
}

Factor elasticity_factor(const std::array<Material, 2>& materials) {
  double sum = 0.0;
  for (const Material& m : materials)
    sum += (1 - m.poisson_ratio * m.poisson_ratio) / m.youngs_modulus;
  return {std::sqrt(1 / (std::numbers::pi * sum)), "ISO 6336-2, clause 7", ""};
}

Factor contact_ratio_factor(const RatedPair& pair) {
  constexpr const char* formula = "ISO 6336-2, clause 8";
  const double e = pair.epsilon_alpha;
  if (pair.spur()) return {std::sqrt((4 - e) / 3), formula, "spur"};
  if (pair.epsilon_beta >= 1.0) return {std::sqrt(1 / e), formula, "helical, ε_β ≥ 1"};
  return {std::sqrt((4 - e) / 3 * (1 - pair.epsilon_beta) + pair.epsilon_beta / e), formula,
          "helical, ε_β < 1"};
}

Factor flank_helix_factor(const RatedPair& pair) {
  return {1 / std::sqrt(std::cos(pair.beta)), "ISO 6336-2, clause 9", ""};
}

Factor lubricant_factor(const Film& film) {
  constexpr const char* formula = "ISO 6336-2, 12.2";
  if (!film.viscosity) return {1.0, formula, kNotAsked};
  const double c = film_constant(film.sigma_Hlim);
  const double n = 1.2 + 134.0 / *film.viscosity;
  return {c + 4 * (1 - c) / (n * n), formula, film_branch(film.sigma_Hlim)};
}

Factor velocity_factor(const Film& film) {
  constexpr const char* formula = "ISO 6336-2, 12.3";
  if (!film.velocity || *film.velocity <= 0.0) return {1.0, formula, kNotAsked};
  const double c = film_constant(film.sigma_Hlim) + 0.02;
  return {c + 2 * (1 - c) / std::sqrt(0.8 + 32.0 / *film.velocity), formula,
          film_branch(film.sigma_Hlim)};
}

Factor roughness_factor(const RatedPair& pair, const Film& film) {
  constexpr const char* formula = "ISO 6336-2, 12.4";
  if (!film.Rz) return {1.0, formula, kNotAsked};
  const double rz = ((*film.Rz)[0] + (*film.Rz)[1]) / 2 * std::cbrt(10 / pitch_curvature(pair));
  const double c = 0.32 - 0.0002 * std::clamp(film.sigma_Hlim, 850.0, 1200.0);
  return {std::pow(3 / rz, c), formula, film_branch(film.sigma_Hlim)};
}

FactorPair work_hardening_factors(const RatedPair& pair, const std::array<Material, 2>& materials,
                                  const Film& film) {
  constexpr const char* formula = "ISO 6336-2, clause 13";
  const Factor one{1.0, formula, "1 for surfaces of the same kind"};
  FactorPair z{one, one};
  for (std::size_t soft = 0; soft < 2; ++soft) {
    const std::size_t hard = 1 - soft;
    if (!steel_without_hard_surface(materials[soft])) continue;
    const auto hardness = materials[soft].hardness_HB();
    if (materials[hard].surface_hardened()) {
      if (!hardness) {
        z[soft] = {1.0, formula, "1, because surface_hardness_HV of the softer gear is not given"};
        continue;
      }
      if (!film.Rz || !film.viscosity || !film.velocity || *film.velocity <= 0.0) {
        z[soft] = {1.0, formula, "1, because viscosity, speed or flank roughness is not given"};
        continue;
      }
      const double hb = std::clamp(*hardness, 130.0, 470.0);
      const auto& r = *film.Rz;
      const double rz = std::clamp(r[hard] * std::pow(10 / pitch_curvature(pair), 0.33) *
                                       std::pow(r[hard] / r[soft], 0.66) /
                                       std::pow(*film.velocity * *film.viscosity / 1500, 0.33),
                                   3.0, 16.0);
      z[soft] = {std::max(1.0, (1.2 - (hb - 130) / 1700) * std::pow(3 / rz, 0.15)), formula,
                 "through-hardened with surface-hardened"};
    } else if (soft == 1 && steel_without_hard_surface(materials[0]) && hardness &&
               materials[0].hardness_HB()) {
      const double ratio = *materials[0].hardness_HB() / *hardness;
      if (ratio < 1.2) continue;
      const double a = ratio > 1.7 ? 0.00698 : 0.00898 * ratio - 0.00829;
      const double u = std::min(20.0, std::abs(pair.u));
      z[1] = {1 + a * (u - 1), formula,
              ratio > 1.7 ? "both through-hardened, HB_1/HB_2 > 1.7"
                          : "both through-hardened, 1.2 ≤ HB_1/HB_2 ≤ 1.7"};
    }
  }
  return z;
}

double nominal_contact_stress(const RatedPair& pair, double tangential_force, double Z) {
  return Z *
         std::sqrt(tangential_force / (pair.gears[0].reference_diameter * pair.carrying_width()) *
                   (pair.u + 1) / pair.u);
}

}  // namespace gearwright
