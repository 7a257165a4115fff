#include <fmt/format.h>

#include <cmath>
#include <random>

#include "gearwright/math/involute.hpp"
#include "gearwright/pair/closed_forms.hpp"
#include "tests/accuracy/ledger.hpp"

namespace gearwright::ledger {

double relative_error(double got, const Exact& exact) {
  if (exact == 0) return got == 0.0 ? 0.0 : 1.0;
  return std::abs(static_cast<double>((Exact(got) - exact) / exact));
}

double error_in_modules(double got, const Exact& exact, double normal_module) {
  return std::abs(static_cast<double>(Exact(got) - exact)) / normal_module;
}

std::vector<Row> involute_rows() {
  constexpr int kInputs = 20000;
  Row inv{"involute", "1e-6 ≤ α ≤ 1.55 rad", "relative", 4e-15, 0.0, ""};
  Row roll{"involute_of_roll",
           "1e-6 ≤ ξ ≤ 60 (from 0.28 on ξ and atan ξ cancel: 2 · ½ ulp(ξ)/0.0073)",
           "relative",
           8e-15,
           0.0,
           ""};
  Row inverse{"inverse_involute", "1e-15 ≤ y ≤ 50", "relative", 2e-15, 0.0, ""};
  Row inverses{"inverse_involutes", "vector code; 1e-15 ≤ y ≤ 50", "relative", 1e-15, 0.0, ""};
  std::mt19937_64 random(20250101);
  const auto log_uniform = [&](double lo, double hi) {
    const double u = static_cast<double>(random() >> 11) * 0x1p-53;
    return lo * std::pow(hi / lo, u);
  };
  for (int i = 0; i < kInputs; ++i) {
    const double alpha = log_uniform(1e-6, 1.55);
    inv.see(relative_error(involute(alpha), involute(Exact(alpha))), fmt::format("α = {}", alpha));
    const double xi = log_uniform(1e-6, 60.0);
    roll.see(relative_error(involute_of_roll(xi), involute_of_roll(Exact(xi))),
             fmt::format("ξ = {}", xi));
    const double y = log_uniform(1e-15, 50.0);
    // The error of the inverse is computed from its function value, as one Newton step in 50
    // digits.
    const auto judge = [&](Row& row, double a) {
      const Exact t = tan(Exact(a));
      const Exact step = (t - Exact(a) - Exact(y)) / (t * t);
      row.see(std::abs(static_cast<double>(step / Exact(a))), fmt::format("y = {}", y));
    };
    judge(inverse, inverse_involute(y));
    double in_lanes = 0.0;
    inverse_involutes(&y, &in_lanes, 1);
    judge(inverses, in_lanes);
  }
  for (Row* row : {&inv, &roll, &inverse, &inverses})
    row->where += fmt::format(", {} inputs", kInputs);
  return {inv, roll, inverse, inverses};
}

}  // namespace gearwright::ledger
