// The keys of measuring a gear: [gearN.measure], the tools; [gearN.tolerance], the permitted
// readings; and [gearN.measured], readings of an unknown gear.
#pragma once

#include "gearwright/arrange/given_gear.hpp"
#include "gearwright/catalogue/key.hpp"

namespace gearwright {

inline constexpr KeyList kLowerAndUpper{.least = 2, .most = 2, .order = kLowerFirst};
/// One number, or two if the teeth are made at their mean.
inline constexpr KeyList kOneOrEnds{.most = 2, .single = true, .order = kLowerFirst};

const KeyTable& measure_keys();
const KeyTable& tolerance_keys();

inline constexpr std::size_t kMostBallReadings = 20;

const KeyTable& measured_keys();
/// The keys of one entry of over_balls_mm.
const KeyTable& measured_ball_keys();
/// The keys of a [gearN] with readings and without a module: additional known data.
const KeyTable& unknown_gear_keys();

}  // namespace gearwright
