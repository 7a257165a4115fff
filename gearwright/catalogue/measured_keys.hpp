// The keys of [gearN.measured]: readings of an unknown gear.
#pragma once

#include "gearwright/catalogue/key.hpp"

namespace gearwright {

inline constexpr std::size_t kMostBallReadings = 20;

const KeyTable& measured_keys();
/// The keys of one entry of over_balls_mm.
const KeyTable& measured_ball_keys();
/// The keys of a [gearN] with readings and without a module: additional known data.
const KeyTable& unknown_gear_keys();

}  // namespace gearwright
