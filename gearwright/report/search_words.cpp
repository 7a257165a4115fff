#include "gearwright/report/search_words.hpp"

#include <fmt/format.h>

#include <array>

#include "gearwright/base/angle.hpp"
#include "gearwright/base/contract.hpp"

namespace gearwright {

namespace {

// The order is the order of the enumerators of Limit.
constexpr std::array<std::string_view, kLimits> kLimitWords{
    "no profile shift without undercut or a thin tip",
    "centre distance out of reach",
    "contact ratio too small",
    "overlap ratio too small",
    "specific sliding too great",
    "tip clearance too small",
    "interference",
    "safety against pitting too small",
    "safety against root breakage too small",
    "a finding in the verdict on the drawn pair"};

}  // namespace

std::string_view words_of(Limit limit) { return kLimitWords[static_cast<std::size_t>(limit)]; }

ObjectiveWords words_of(Objective objective) {
  switch (objective) {
    case Objective::contact_ratio: return {"contact ratio", "ε_α", "", true};
    case Objective::formula_contact_ratio: return {"contact ratio by formula", "ε_α", "", true};
    case Objective::ratio: return {"error of the ratio", "", "", false};
    case Objective::size: return {"size m²(z₁² + z₂²)", "", "mm²", false};
    case Objective::shift: return {"sum of profile shifts", "Σx", "modules", false};
    case Objective::area: return {"area of the region of profile shifts", "", "modules²", true};
    case Objective::sliding: return {"greatest specific sliding", "ζ", "", false};
    case Objective::mass: return {"mass", "m", "kg", false};
    case Objective::safety: return {"least ratio of safety to required safety", "", "", true};
  }
  contract_failed("postcondition", "known objective", __FILE__, __LINE__);
}

std::optional<double> value_of(const SearchProblem& problem, const DesignRow& row,
                               Objective objective) {
  // Only a ranked (balanced) design has a cost. A plot needs a value for every design, so the row
  // is treated as balanced.
  DesignRow any = row;
  any.balanced = true;
  const auto value = cost(problem, any, objective);
  if (!value) return std::nullopt;
  return words_of(objective).greater ? -*value : *value;
}

std::string design_name(const Trial& trial) {
  const double beta = trial.helix[0].deg();
  return fmt::format("{:.10g} · {}:{}{}", trial.module, trial.z1, trial.z2,
                     beta == 0.0 ? "" : fmt::format(" · {:.6g}°", beta));
}

}  // namespace gearwright
