// Chooses the profile shifts of a drive, for a search in which no shifts are given.
//
//   x_u    least shift without undercut, for the thinned teeth [T9.2]
//   Σx     x1 + x2 of a mesh of two external gears       theory: docs/theory/13-drives.md, 13.3
//
// The shifts of the first mesh of a set determine its centre distance. The shifts of the other
// gears follow from this distance (drive/drive_geometry.hpp). In a train, every mesh has its own
// centre distance.
#pragma once

#include <optional>
#include <vector>

#include "gearwright/drive/drive_graph.hpp"

namespace gearwright {

/// x of each gear of a graph. An absent x follows from the centre distance.
using GearShifts = std::vector<std::optional<double>>;

/// The shifts to try, first balanced and then least shifts.
///
/// Formula   least: x = max(0, x_u). Balanced: the least Σx ≥ 0 for which both x ≥ x_u, divided
///           by [T2.18a]. If the shift of the second gear of a stepped planet would be less than
///           x_u, it is set to x_u. All shifts are rounded up to a multiple of 1e-4
/// Domain    a checked graph without centre distances (contract); the shifts of the graph are
///           ignored
/// Accuracy  no external gear of a planetary set or a train is undercut, with one exception: sun2
///           and its planet gear may be undercut in a set with two suns
std::vector<GearShifts> shift_trials(const DriveGraph& graph);

}  // namespace gearwright
