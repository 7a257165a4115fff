// The vector code of contact/touch_lanes.hpp, written with Google Highway. The file is compiled
// once for each instruction set. The program selects the best version at run time.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "gearwright/contact/touch_lanes_simd.cpp"
#include <hwy/foreach_target.h>  // must come before highway.h

#include <hwy/contrib/math/math-inl.h>
#include <hwy/highway.h>

#include <array>

#include "gearwright/contact/touch_lanes.hpp"

HWY_BEFORE_NAMESPACE();
namespace gearwright::detail {
namespace HWY_NAMESPACE {

#include "gearwright/math/lanes.inc"

HWY_INLINE Lane round_of(const Lane& x) { return hn::Round(x.v); }
using Mask = hn::Mask<Tag>;
HWY_INLINE Mask both(const Mask& a, const Mask& b) { return hn::And(a, b); }
HWY_INLINE Mask not_of(const Mask& a) { return hn::Not(a); }
HWY_INLINE bool all_of(const Mask& a) { return hn::AllTrue(Tag(), a); }

#define GW_LEAF_INLINE HWY_INLINE
#define GW_LEAF_LAMBDA HWY_ATTR
#include "gearwright/contact/touch_lanes.inc"
#undef GW_LEAF_LAMBDA
#undef GW_LEAF_INLINE

void touch_step_here(LaneBlock& block) {
  const std::size_t width = hn::Lanes(Tag());
  for (std::size_t i = 0; i < kLaneBlock; i += width) {
    step_of<Lane>(
        [&](LaneIn k) HWY_ATTR {
          return Lane(hn::LoadU(Tag(), block.in[static_cast<std::size_t>(k)].data() + i));
        },
        [&](LaneOut k, const Lane& value) HWY_ATTR {
          hn::StoreU(value.v, Tag(), block.out[static_cast<std::size_t>(k)].data() + i);
        });
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace gearwright::detail
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gearwright::detail {

HWY_EXPORT(touch_step_here);

void touch_step(LaneBlock& block) { HWY_DYNAMIC_DISPATCH(touch_step_here)(block); }

}  // namespace gearwright::detail
#endif
