// Computes a double-helical pair under torque: each half under half of the torque, and the whole gears.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "gearwright/arrange/loaded_pair.hpp"
#include "gearwright/arrange/two_halves.hpp"

namespace gearwright {

/// The halves under half of each torque, and the whole gears. `arranged` is the half at z > 0.
/// Deflections are given over the whole face including the gap. If one half is wider than its mating
/// half, the middle of the narrower half is used for both.
///
/// Domain    `halves` of both gears (contract)
/// Errors    as loaded()
Result<LoadAnalysis> loaded_halves(const Arranged& arranged,
                                   const std::array<std::optional<Halves>, 2>& halves,
                                   const ContactErrors& errors, const LoadInput& input,
                                   std::vector<Warning>& warnings, Progress* progress = nullptr);

/// The input for one half, derived from that for the whole gears: half of the torque, and the
/// deflections within this half. For `below`, rotations and z are those of the mirror image. Probes are
/// left out.
LoadInput input_of_half(const LoadInput& whole, const Halves& narrower, const Gear& gear_1,
                        bool below);

}  // namespace gearwright
