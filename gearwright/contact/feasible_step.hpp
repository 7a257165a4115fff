// The exact solution of the small problem inside each step of the contact search:
//
//   max  g·d + d·H d/2    over  c_j + a_j·d ≥ 0,  j = 1 … 8,    d in the plane
//
// The candidates are the stationary point, the best point on each bound, and the corners of two
// bounds. The objective is concave. The solution is therefore the first candidate that satisfies
// all bounds and whose multipliers are ≥ 0. The active bounds of the last step are tried first.
// theory: docs/theory/08-contact.md, [T8.9]
#pragma once

#include <array>
#include <cstdint>

namespace gearwright::detail {

constexpr int kBounds = 8;

struct Bound {
  double c;         ///< c_j, value of the bound at d = 0, ≥ 0 inside
  double a_s, a_z;  ///< a_j, gradient of the bound
};

struct StepProblem {
  double g_s, g_z;
  double h_ss, h_sz, h_zz;  ///< H, negative definite; solve_step() does not check this
  std::array<Bound, kBounds> bounds;
};

/// The active bounds, at most two; −1 for a bound that is absent.
struct ActiveSet {
  std::int8_t first = -1, second = -1;
  bool inside() const { return first < 0; }
  bool corner() const { return second >= 0; }
  bool operator==(const ActiveSet&) const = default;
};

struct FeasibleStep {
  double d_s = 0.0, d_z = 0.0;
  ActiveSet active;
  std::array<double, 2> multiplier{};  ///< multipliers of active.first and active.second, ≥ 0
  /// False if no candidate satisfies all bounds. d is then the candidate that violates them least.
  bool feasible = true;
};

FeasibleStep solve_step(const StepProblem& p, const ActiveSet& guess);

}  // namespace gearwright::detail
