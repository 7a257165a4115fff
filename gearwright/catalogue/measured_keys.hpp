// The keys of [gearN.measured]: readings of a gear that nobody knows.
#pragma once

#include "gearwright/catalogue/key.hpp"

namespace gearwright {

inline constexpr std::size_t kMostBallReadings = 20;

const KeyTable& measured_keys();
/// Of one of over_balls_mm.
const KeyTable& measured_ball_keys();
/// Of a [gearN] that has readings and no module: what may be known of it.
const KeyTable& unknown_gear_keys();

}  // namespace gearwright
