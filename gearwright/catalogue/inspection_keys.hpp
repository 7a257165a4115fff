// The keys for measuring a gear: the tools in [gearN.measure], the permitted readings in
// [gearN.tolerance], and the readings of an unknown gear in [gearN.measured].
#pragma once

#include "gearwright/arrange/given_gear.hpp"
#include "gearwright/catalogue/key.hpp"

namespace gearwright {

inline constexpr KeyList kLowerAndUpper{.least = 2, .most = 2, .order = kLowerFirst};
/// One number, or two limits. The teeth are then computed with the mean of the limits.
inline constexpr KeyList kOneOrEnds{.most = 2, .single = true, .order = kLowerFirst};

const KeyTable& measure_keys();
const KeyTable& tolerance_keys();

inline constexpr std::size_t kMostBallReadings = 20;

const KeyTable& measured_keys();
/// The keys of one entry of over_balls_mm.
const KeyTable& measured_ball_keys();
/// The keys of a [gearN] that has readings but no module, for other known data of the gear.
const KeyTable& unknown_gear_keys();

}  // namespace gearwright
