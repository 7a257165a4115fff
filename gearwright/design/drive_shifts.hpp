// Chooses the profile shifts of a drive, for a search in which no shifts are given.
//
//   x_u    least shift without undercut, for the thinned teeth [T9.2]
//   Σx     x1 + x2 of a mesh of two external gears       theory: docs/theory/13-drives.md, 13.3
//
// The shifts of the first mesh of a set determine its centre distance. The shifts of the other
// gears follow from this distance (drive/drive_geometry.hpp). In a train, every mesh has its own
// centre distance.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "gearwright/drive/drive_graph.hpp"

namespace gearwright {

/// x of each gear of a graph. An absent x follows from the centre distance.
using GearShifts = std::vector<std::optional<double>>;

/// Returns the sets of shifts to try: first the balanced shifts, then the least shifts.
///
/// Formula   least: x = max(0, x_u). Balanced: the least Σx ≥ 0 with x ≥ x_u for both gears,
///           divided according to [T2.18a]. If the shift of the second gear of a stepped planet
///           would be less than x_u, it is set to x_u. All shifts are rounded up to a multiple of
///           1e-4. A centre distance of a stage outside `distance` is moved to the nearer end,
///           which determines Σx. Gear 1 gets its least shift or, for balanced shifts, its part of
///           Σx according to [T2.18a]. Gear 2 gets the rest. If a shift would be less than x_u, it
///           is set to x_u, and the mating gear gets the rest
/// Domain    a checked graph without centre distances (contract); the shifts of the graph are
///           ignored
/// Accuracy  no external gear of a planetary set or a train is undercut, with two exceptions: sun2
///           and its planet gear in a set with two suns, and a gear of a stage whose centre
///           distance was reduced. A moved centre distance is within 1e-9 mm of its end
///
/// `distance`  least and greatest centre distance of the meshes of a train, mm; absent if there are
///             no limits. The result is empty if the teeth of a mesh have no such distance
std::vector<GearShifts> shift_trials(
    const DriveGraph& graph, const std::optional<std::array<double, 2>>& distance = std::nullopt);

}  // namespace gearwright
