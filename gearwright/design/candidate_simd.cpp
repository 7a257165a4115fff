// The vector code of design/candidate.hpp, written with Google Highway. The file is compiled once
// for each instruction set. At run time, the program selects the best version for the processor.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "gearwright/design/candidate_simd.cpp"
#include <hwy/foreach_target.h>  // must come before highway.h

#include <hwy/contrib/math/math-inl.h>
#include <hwy/highway.h>

#include <array>
#include <cmath>
#include <numbers>

#include "gearwright/design/candidate.hpp"

HWY_BEFORE_NAMESPACE();
namespace gearwright {
namespace HWY_NAMESPACE {

constexpr double kLanePi = std::numbers::pi;

#include "gearwright/math/lanes.inc"

#define GW_LEAF_INLINE HWY_INLINE
#define GW_LEAF_LAMBDA HWY_ATTR
#include "gearwright/design/candidate_formulas.inc"
#include "gearwright/gear/leaf_formulas.inc"
#include "gearwright/pair/leaf_formulas.inc"
#undef GW_LEAF_LAMBDA
#undef GW_LEAF_INLINE

void evaluate_here(const CandidateConstants& constants, CandidateBatch& b) {
  std::array<const double*, CandidateBatch::kIn> in{};
  for (std::size_t k = 0; k < in.size(); ++k) in[k] = b.in[k].data();
  std::array<double*, CandidateBatch::kOut> out{};
  for (std::size_t k = 0; k < out.size(); ++k) out[k] = b.out[k].data();
  for_columns(in, out, b.size(), [&](const std::array<Lane, CandidateBatch::kIn>& x) HWY_ATTR {
    const auto v = evaluate_lanes<Lane>(constants, x[0], x[1], x[2], x[3], x[4]);
    return std::array<Lane, CandidateBatch::kOut>{
        v.center_distance, v.tan_working,    v.contact_ratio,  v.contact_ratio_true,
        v.sliding,         v.tip_1,          v.tip_2,          v.clearance_1,
        v.clearance_2,     v.interference_1, v.interference_2, v.residual};
  });
}

void sieve_here(const SieveConstants& constants, SieveBatch& b) {
  std::array<const double*, SieveBatch::kIn> in{};
  for (std::size_t k = 0; k < in.size(); ++k) in[k] = b.in[k].data();
  const std::array<double*, 1> out{b.verdict.data()};
  for_columns(in, out, b.size(), [&](const std::array<Lane, SieveBatch::kIn>& x) HWY_ATTR {
    return std::array<Lane, 1>{
        sieve_lanes<Lane>(constants, x[0], x[1], x[2], x[3], x[4], x[5], x[6], x[7])};
  });
}

const char* name_here() { return hwy::TargetName(HWY_TARGET); }
std::size_t lanes_here() { return hn::Lanes(Tag()); }

}  // namespace HWY_NAMESPACE
}  // namespace gearwright
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gearwright {

HWY_EXPORT(evaluate_here);
HWY_EXPORT(sieve_here);
HWY_EXPORT(name_here);
HWY_EXPORT(lanes_here);

void evaluate(const CandidateConstants& constants, CandidateBatch& batch) {
  HWY_DYNAMIC_DISPATCH(evaluate_here)(constants, batch);
}
void sieve(const SieveConstants& constants, SieveBatch& batch) {
  HWY_DYNAMIC_DISPATCH(sieve_here)(constants, batch);
}
std::string lanes_name() { return HWY_DYNAMIC_DISPATCH(name_here)(); }
std::size_t lanes() { return HWY_DYNAMIC_DISPATCH(lanes_here)(); }

}  // namespace gearwright
#endif
