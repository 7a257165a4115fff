// The vector version of pair/closed_forms.hpp, written with Google Highway. This file is compiled
// once for each instruction set that the compiler supports. At run time, the program uses the best
// version for the processor.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "gearwright/pair/closed_forms_simd.cpp"
#include <hwy/foreach_target.h>  // must come before highway.h

#include <hwy/contrib/math/math-inl.h>
#include <hwy/highway.h>

#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "gearwright/pair/closed_forms.hpp"

HWY_BEFORE_NAMESPACE();
namespace gearwright {
namespace HWY_NAMESPACE {

constexpr double kHalfTurn = std::numbers::pi;

#include "gearwright/math/lanes.inc"

HWY_INLINE Lane third_of_bits(const Lane& x) {
  const hn::RebindToUnsigned<Tag> whole;
  const auto bits = hn::BitCast(whole, x.v);
  auto third = hn::Add(hn::ShiftRight<2>(bits), hn::ShiftRight<4>(bits));
  third = hn::Add(third, hn::ShiftRight<4>(third));
  third = hn::Add(third, hn::ShiftRight<8>(third));
  third = hn::Add(third, hn::ShiftRight<16>(third));
  return hn::BitCast(Tag(), third);
}

#define GW_LEAF_INLINE HWY_INLINE
#include "gearwright/gear/leaf_formulas.inc"
#include "gearwright/pair/closed_forms.inc"
#include "gearwright/pair/leaf_formulas.inc"
#undef GW_LEAF_INLINE

void inverse_involutes_here(const double* y, double* alpha, std::size_t n) {
  const std::array<const double*, 1> in{y};
  const std::array<double*, 1> out{alpha};
  for_columns(in, out, n, [](const std::array<Lane, 1>& row) HWY_ATTR {
    return std::array<Lane, 1>{inverse_involute_of(row[0])};
  });
}

void normal_backlashes_here(const BacklashConstants& constants, const BacklashColumns& columns,
                            double* backlash, std::size_t n) {
  const std::array<double*, 1> out{backlash};
  for_columns(columns.in, out, n, [&](const std::array<Lane, BacklashColumns::kIn>& row) HWY_ATTR {
    return std::array<Lane, 1>{normal_backlash_of(constants, row)};
  });
}

}  // namespace HWY_NAMESPACE
}  // namespace gearwright
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gearwright {

HWY_EXPORT(inverse_involutes_here);
HWY_EXPORT(normal_backlashes_here);

void inverse_involutes(const double* y, double* alpha, std::size_t n) {
  HWY_DYNAMIC_DISPATCH(inverse_involutes_here)(y, alpha, n);
}
void normal_backlashes(const BacklashConstants& constants, const BacklashColumns& columns,
                       double* backlash, std::size_t n) {
  HWY_DYNAMIC_DISPATCH(normal_backlashes_here)(constants, columns, backlash, n);
}

}  // namespace gearwright
#endif
