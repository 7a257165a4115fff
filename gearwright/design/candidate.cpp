#include "gearwright/design/candidate.hpp"

#include <numbers>

#include "gearwright/pair/leaf_formulas.hpp"

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

using namespace leaf;

#define GW_LEAF_INLINE inline
#define GW_LEAF_LAMBDA
#include "gearwright/design/candidate_formulas.inc"
#undef GW_LEAF_LAMBDA
#undef GW_LEAF_INLINE

}  // namespace

void evaluate_scalar(const CandidateConstants& constants, CandidateBatch& b) {
  for (std::size_t i = 0; i < b.size(); ++i) {
    const auto v = evaluate_lanes<double>(constants, b.in[0][i], b.in[1][i], b.in[2][i], b.in[3][i],
                                          b.in[4][i]);
    const std::array<double, CandidateBatch::kOut> values{
        v.center_distance, v.tan_working,    v.contact_ratio,  v.contact_ratio_true,
        v.sliding,         v.tip_1,          v.tip_2,          v.clearance_1,
        v.clearance_2,     v.interference_1, v.interference_2, v.residual};
    for (std::size_t k = 0; k < values.size(); ++k) b.out[k][i] = values[k];
  }
}

void sieve_scalar(const SieveConstants& constants, SieveBatch& b) {
  for (std::size_t i = 0; i < b.size(); ++i) {
    b.verdict[i] = sieve_lanes<double>(constants, b.in[0][i], b.in[1][i], b.in[2][i], b.in[3][i],
                                       b.in[4][i], b.in[5][i], b.in[6][i], b.in[7][i]);
  }
}

}  // namespace gearwright
