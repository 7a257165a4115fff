#include "gearwright/contact/feasible_step.hpp"

#include <cmath>
#include <limits>

namespace gearwright::detail {

namespace {

// Limits of rounding errors. A point counts as inside if it lies beyond a bound by at most
// kOnBound, a scaled length. A multiplier counts as ≥ 0 if it is at least kNoMultiplier.
constexpr double kOnBound = 1e-12;
constexpr double kNoMultiplier = -1e-15;
// If the sine of the angle between two bounds is below this limit, the bounds count as parallel and
// have no corner.
constexpr double kParallel = 1e-14;

class Candidates {
 public:
  explicit Candidates(const StepProblem& p) : p_(p) {}

  bool try_set(const ActiveSet& set, FeasibleStep& step) const {
    if (set.inside()) return try_inside(step);
    return set.corner() ? try_corner(set.first, set.second, step) : try_edge(set.first, step);
  }

  bool try_inside(FeasibleStep& step) const {
    const double det = p_.h_ss * p_.h_zz - p_.h_sz * p_.h_sz;
    step.d_s = (-p_.g_s * p_.h_zz + p_.g_z * p_.h_sz) / det;
    step.d_z = (-p_.g_z * p_.h_ss + p_.g_s * p_.h_sz) / det;
    step.active = {};
    step.multiplier = {};
    return within(step);
  }

  bool try_edge(int i, FeasibleStep& step) const {
    const Bound& b = p_.bounds[i];
    const double square = b.a_s * b.a_s + b.a_z * b.a_z;
    if (!(square > 0.0)) return false;
    const double d0_s = -b.c * b.a_s / square;
    const double d0_z = -b.c * b.a_z / square;
    const double e_s = -b.a_z;
    const double e_z = b.a_s;
    const double bend = e_s * e_s * p_.h_ss + 2.0 * e_s * e_z * p_.h_sz + e_z * e_z * p_.h_zz;
    if (!(bend < 0.0)) return false;
    const double t = -(e_s * slope_s(d0_s, d0_z) + e_z * slope_z(d0_s, d0_z)) / bend;
    step.d_s = d0_s + t * e_s;
    step.d_z = d0_z + t * e_z;
    step.active = {static_cast<std::int8_t>(i), -1};
    const double mu =
        -(b.a_s * slope_s(step.d_s, step.d_z) + b.a_z * slope_z(step.d_s, step.d_z)) / square;
    step.multiplier = {std::max(0.0, mu), 0.0};
    return mu >= kNoMultiplier && within(step);
  }

  bool try_corner(int i, int k, FeasibleStep& step) const {
    const Bound& a = p_.bounds[i];
    const Bound& b = p_.bounds[k];
    const double det = a.a_s * b.a_z - a.a_z * b.a_s;
    if (!(std::abs(det) > kParallel * (std::hypot(a.a_s, a.a_z) * std::hypot(b.a_s, b.a_z))))
      return false;
    step.d_s = (-a.c * b.a_z + b.c * a.a_z) / det;
    step.d_z = (-b.c * a.a_s + a.c * b.a_s) / det;
    step.active = {static_cast<std::int8_t>(i), static_cast<std::int8_t>(k)};
    // The multipliers of both bounds:  slope + μ_a a + μ_b b = 0
    const double s = -slope_s(step.d_s, step.d_z);
    const double z = -slope_z(step.d_s, step.d_z);
    const double mu_a = (s * b.a_z - z * b.a_s) / det;
    const double mu_b = (z * a.a_s - s * a.a_z) / det;
    step.multiplier = {std::max(0.0, mu_a), std::max(0.0, mu_b)};
    return mu_a >= kNoMultiplier && mu_b >= kNoMultiplier && within(step);
  }

  // Returns the candidate that violates the bounds least. The candidates are the corners of two
  // bounds and, on each bound, the point nearest to d = 0.
  FeasibleStep min_broken() const {
    FeasibleStep best;
    double least = std::numeric_limits<double>::infinity();
    const auto take = [&](const FeasibleStep& s) {
      const double broken = max_broken(s);
      if (!(broken < least)) return;
      least = broken;
      best = s;
    };
    for (int i = 0; i < kBounds; ++i) {
      FeasibleStep foot;
      const Bound& b = p_.bounds[i];
      const double square = b.a_s * b.a_s + b.a_z * b.a_z;
      if (!(square > 0.0)) continue;
      foot.d_s = -b.c * b.a_s / square;
      foot.d_z = -b.c * b.a_z / square;
      foot.active = {static_cast<std::int8_t>(i), -1};
      take(foot);
      for (int k = i + 1; k < kBounds; ++k) {
        FeasibleStep corner;
        try_corner(i, k, corner);
        if (corner.active.corner()) take(corner);
      }
    }
    best.multiplier = {};
    best.feasible = false;
    return best;
  }

 private:
  double slope_s(double d_s, double d_z) const { return p_.g_s + p_.h_ss * d_s + p_.h_sz * d_z; }
  double slope_z(double d_s, double d_z) const { return p_.g_z + p_.h_sz * d_s + p_.h_zz * d_z; }

  bool within(const FeasibleStep& s) const {
    for (int j = 0; j < kBounds; ++j)
      if (!(broken(j, s) <= kOnBound)) return false;
    return true;
  }

  // The length by which a step violates a bound that is not active.
  double broken(int j, const FeasibleStep& s) const {
    if (j == s.active.first || j == s.active.second) return 0.0;
    const Bound& b = p_.bounds[j];
    return -(b.c + b.a_s * s.d_s + b.a_z * s.d_z);
  }

  double max_broken(const FeasibleStep& s) const {
    double worst = 0.0;
    for (int j = 0; j < kBounds; ++j)
      if (const double v = broken(j, s); !(v <= worst)) worst = v;  // NaN counts as the worst
    return worst;
  }

  const StepProblem& p_;
};

}  // namespace

FeasibleStep solve_step(const StepProblem& p, const ActiveSet& guess) {
  const Candidates candidates(p);
  FeasibleStep step;
  if (candidates.try_set(guess, step)) return step;
  if (!guess.inside() && candidates.try_inside(step)) return step;
  for (int i = 0; i < kBounds; ++i)
    if (candidates.try_edge(i, step)) return step;
  for (int i = 0; i < kBounds; ++i)
    for (int k = i + 1; k < kBounds; ++k)
      if (candidates.try_corner(i, k, step)) return step;
  return candidates.min_broken();
}

}  // namespace gearwright::detail
