#include "gearwright/design/design_objectives.hpp"

#include <algorithm>
#include <cmath>

#include "gearwright/pair/contact_lines.hpp"

namespace gearwright {

std::optional<double> load_balance(const SearchProblem& problem, const DesignRow& row) {
  for (const std::size_t i : {0, 1})
    if (!row.flank_safety[i] || !row.root_safety[i]) return std::nullopt;
  const double root = problem.limits.safety_root.value_or(1.0);
  const double flank = std::min(*row.flank_safety[0], *row.flank_safety[1]) /
                       problem.limits.safety_flank.value_or(1.0);
  const auto [least, greatest] =
      std::minmax({flank * flank, *row.root_safety[0] / root, *row.root_safety[1] / root});
  return greatest / least;
}

double relative_cost(const SearchProblem& problem, const DesignRow& row) {
  const double d_1 = row.trial.module * row.trial.z1 / std::cos(row.trial.helix[0].rad());
  return row.mass * std::pow(row.face_width / d_1, problem.cost_exponent);
}

std::optional<double> mean_deflection(const RatedPair& pair, const Rating& rating) {
  const double stiffness = rating.stiffness.c_gamma_alpha.value;
  if (!(stiffness > 0.0)) return std::nullopt;
  return rating.F_t.value / (pair.face_width * stiffness * std::cos(pair.alpha_t));
}

std::optional<double> noise_of(const DesignRow& row, const std::optional<double>& deflection) {
  const auto variation = deflection_variation(row.contact_ratio_true, row.overlap_ratio);
  if (!deflection || !variation) return std::nullopt;
  return *deflection * *variation;
}

}  // namespace gearwright
