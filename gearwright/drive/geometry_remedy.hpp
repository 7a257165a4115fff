// Finds changes that make the teeth of a drive possible: another centre distance, another number of
// teeth of the central gear, or another backlash.
//
// Every change is tried. It is accepted if the geometry of the whole drive, computed with the
// change, has no problem in any gear or mesh.      theory: docs/theory/13-drives.md, [T13.15]
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "gearwright/drive/drive_geometry.hpp"

namespace gearwright {

/// Groups the meshes that share a centre distance. The meshes of a planet with its central gears
/// form a group, and any other mesh is a group by itself.
std::vector<std::vector<std::size_t>> distance_classes(const DriveGraph& graph);

/// The least and the greatest possible centre distance of the meshes that share the distance of
/// `mesh`, mm. The search starts at the distance that follows from the graph if no centre
/// distance is given. None if that distance is impossible.
///
/// Accuracy  each limit is possible, and a distance m_n/1000 beyond it is impossible; between
///           the limits, distances in steps of m_n/40 are tried
/// Domain    a mesh of two gears with teeth
std::optional<std::array<double, 2>> possible_distances(const DriveGraph& graph, std::size_t mesh);

/// The least and the greatest possible |z| of the central gear in a mesh with a planet. The search
/// starts at the |z| that needs no profile shift. None if the mesh has no planet, or if no |z| is
/// possible.
///
/// Formula   |z_0| = 2 a cos β/m_n − z_p external, + z_p for a ring
struct PossibleTeeth {
  std::size_t gear;
  int least, greatest, nominal;
};
std::optional<PossibleTeeth> possible_teeth(const DriveGraph& graph, std::size_t mesh);

/// Adds to the message of the first fault of a geometry the changes with which the whole drive
/// becomes possible. If all teeth touch, or if no such change is found, the message is not
/// changed.
void add_remedy(const DriveGraph& graph, DriveGeometry& made);

/// Replaces the faults that the teeth have only because a backlash is impossible. The new fault of
/// such a mesh names its backlash, the thickness allowances that the backlash requires, and the
/// greatest or least backlash that is possible if the backlash of the other meshes is unchanged.
/// `given` is the graph without the allowances of with_backlash(), and `thinned` is the graph with
/// them. False if no backlash is the reason for a fault.
///
/// Accuracy  the limit is possible, and a backlash 0.002 mm beyond it is impossible
bool blame_backlash(const DriveGraph& given, const DriveGraph& thinned, DriveGeometry& made);

}  // namespace gearwright
