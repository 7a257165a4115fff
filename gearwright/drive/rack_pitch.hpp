// The pitch of a rack in a drive. The graph counts the motion of a rack in pitches, because its
// body moves by one pitch for each tooth of the pinion.
#pragma once

#include <optional>

#include "gearwright/drive/drive_graph.hpp"

namespace gearwright {

/// Transverse pitch p_t of the rack on a body, mm, computed from the module of its pinion. None if
/// the body has no rack or the module is unknown.
std::optional<double> rack_pitch(const DriveGraph& graph, std::size_t body);

}  // namespace gearwright
