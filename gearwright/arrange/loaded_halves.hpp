// Computes the halves of a double-helical pair under torque, and combines them into the results of
// the whole gears.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "gearwright/arrange/loaded_pair.hpp"
#include "gearwright/arrange/two_halves.hpp"

namespace gearwright {

/// Computes each half under half of the torque, and combines the results. `arranged` is the half at
/// z > 0. The deflections in `input` refer to the whole face including the gap. If the faces
/// differ, this is the face of the narrower gear.
///
/// Domain    `halves` of both gears (contract)
/// Errors    as loaded()
Result<LoadAnalysis> loaded_halves(const Arranged& arranged,
                                   const std::array<std::optional<Halves>, 2>& halves,
                                   const ContactErrors& errors, const LoadInput& input,
                                   std::vector<Warning>& warnings, Progress* progress = nullptr);

/// True if the load distributions of both halves are mirror images of each other. Only one of the
/// halves is then computed.
bool equal_halves(const Halves& halves, const ContactErrors& errors, const LoadInput& input);

/// Derives the input for one half from the input for the whole gears: half of the torque, and the
/// deflections over this half. If `below`, the half is the half at z < 0, and the rotations and the
/// direction of z are those of its mirror image. Probes are omitted.
LoadInput input_of_half(const LoadInput& whole, const Halves& narrower, const Gear& gear_1,
                        bool below);

}  // namespace gearwright
