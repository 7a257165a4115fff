// The keys of measuring a gear: [gearN.measure], the tools, and [gearN.tolerance], the permitted
// readings.
#pragma once

#include "gearwright/arrange/given_gear.hpp"
#include "gearwright/catalogue/key.hpp"

namespace gearwright {

inline constexpr KeyList kLowerAndUpper{.least = 2, .most = 2, .order = kLowerFirst};
/// One number, or two if the teeth are made at their mean.
inline constexpr KeyList kOneOrEnds{.most = 2, .single = true, .order = kLowerFirst};

const KeyTable& measure_keys();
const KeyTable& tolerance_keys();

}  // namespace gearwright
