#include "gearwright/design/candidate.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gearwright {

void CandidateBatch::resize(std::size_t n) {
  for (auto& column : in) column.resize(n);
  for (auto& column : out) column.resize(n);
}

void SieveBatch::resize(std::size_t n) {
  for (auto& column : in) column.resize(n);
  verdict.resize(n);
}

namespace {

constexpr double kLanePi = std::numbers::pi;

struct OneLane {
  using V = double;
  static double set(double v) { return v; }
  static double sqrt(double v) { return std::sqrt(v); }
  static double atan(double v) { return std::atan(v); }
  static double abs(double v) { return std::abs(v); }
  // As the instruction sets have it: the second when either is NaN.
  static double min(double a, double b) { return a < b ? a : b; }
  static double max(double a, double b) { return a > b ? a : b; }
  static bool less(double a, double b) { return a < b; }
  static double select(bool mask, double a, double b) { return mask ? a : b; }
};

#define GW_LANE_INLINE inline
#include "gearwright/design/candidate_formulas.inc"
#undef GW_LANE_INLINE

}  // namespace

void evaluate_scalar(const CandidateConstants& constants, CandidateBatch& b) {
  for (std::size_t i = 0; i < b.size(); ++i) {
    const auto v = evaluate_lanes<OneLane>(constants, b.in[0][i], b.in[1][i], b.in[2][i],
                                           b.in[3][i], b.in[4][i]);
    const std::array<double, CandidateBatch::kOut> values{
        v.center_distance, v.tan_working,    v.contact_ratio,  v.contact_ratio_true,
        v.sliding,         v.tip_1,          v.tip_2,          v.clearance_1,
        v.clearance_2,     v.interference_1, v.interference_2, v.residual};
    for (std::size_t k = 0; k < values.size(); ++k) b.out[k][i] = values[k];
  }
}

void sieve_scalar(const SieveConstants& constants, SieveBatch& b) {
  for (std::size_t i = 0; i < b.size(); ++i) {
    b.verdict[i] = sieve_lanes<OneLane>(constants, b.in[0][i], b.in[1][i], b.in[2][i], b.in[3][i],
                                        b.in[4][i], b.in[5][i], b.in[6][i], b.in[7][i]);
  }
}

}  // namespace gearwright
