// Computes a double-helical pair under torque: each half, and the whole gears.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "gearwright/arrange/loaded_pair.hpp"
#include "gearwright/arrange/two_halves.hpp"

namespace gearwright {

/// Computes each half under half of the torque, and combines them into the results of the whole
/// gears. `arranged` is the half at z > 0. Deflections are given over the whole face including the
/// gap, of the narrower gear if the faces differ.
///
/// Domain    `halves` of both gears (contract)
/// Errors    as loaded()
Result<LoadAnalysis> loaded_halves(const Arranged& arranged,
                                   const std::array<std::optional<Halves>, 2>& halves,
                                   const ContactErrors& errors, const LoadInput& input,
                                   std::vector<Warning>& warnings, Progress* progress = nullptr);

/// True if both halves have the same load distribution, up to the mirror image in the middle of the
/// face. Only one of them is then computed.
bool equal_halves(const Halves& halves, const ContactErrors& errors, const LoadInput& input);

/// Derives the input for one half from the input for the whole gears: half of the torque, and the
/// deflections over this half. If `below`, the rotations and z belong to the mirror image. Probes
/// are omitted.
LoadInput input_of_half(const LoadInput& whole, const Halves& narrower, const Gear& gear_1,
                        bool below);

}  // namespace gearwright
