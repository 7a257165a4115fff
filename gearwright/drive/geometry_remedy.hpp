// Finds changes that make the teeth of a drive possible. The centre distance, the number of teeth
// of the central gear, or the backlash can change.
//
// Every change is tried. A change is accepted if it leaves no fault in any gear or mesh of the
// whole drive.                                           theory: docs/theory/13-drives.md, [T13.15]
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "gearwright/drive/drive_geometry.hpp"

namespace gearwright {

/// Groups the meshes that share a centre distance. The meshes of a planet with its central gears
/// form a group. Any other mesh is a group of its own.
std::vector<std::vector<std::size_t>> distance_classes(const DriveGraph& graph);

/// Returns the least and the greatest possible centre distance, mm, of the meshes that have the
/// same distance as `mesh`. The search starts at the distance that follows from the graph if no
/// centre distance is given. Returns none if this distance is impossible.
///
/// Accuracy  each limit is possible. A distance m_n/1000 beyond the limit is impossible, unless the
///           limit differs by 10 m_n from the start of the search. Between the limits, distances in
///           steps of m_n/40 are tried
/// Domain    a mesh of two gears with teeth
std::optional<std::array<double, 2>> possible_distances(const DriveGraph& graph, std::size_t mesh);

/// The least and the greatest possible |z| of the central gear in a mesh with a planet. The search
/// starts at or next to the number of teeth that needs no profile shift, and covers 40 teeth on
/// both sides. There is no result if the mesh has no planet, or if no number of teeth is possible.
///
/// Formula   |z_0| = (2 a cos β)/m_n − z_p for an external central gear, and
///           |z_0| = (2 a cos β)/m_n + z_p for a ring
struct PossibleTeeth {
  std::size_t gear;
  int least, greatest, nominal;
};
std::optional<PossibleTeeth> possible_teeth(const DriveGraph& graph, std::size_t mesh);

/// Adds remedies to the message of the first fault of a geometry. A remedy is a change with which
/// the whole drive is possible. If there is no fault although the teeth of a mesh do not touch, a
/// fault with the remedies is added. If all teeth touch, or if there is no remedy, nothing is
/// changed.
void add_remedy(const DriveGraph& graph, DriveGeometry& made);

/// Replaces each fault that is caused only by the impossible backlash of a mesh. The new fault of
/// this mesh gives the backlash, the thickness allowances that this backlash requires, and the
/// greatest or least possible backlash if the other meshes keep their backlash. `given` is the
/// graph without the allowances of with_backlash(), and `thinned` is the graph with these
/// allowances. Returns false if no backlash causes a fault.
///
/// Accuracy  the limit is possible, and a backlash 0.002 mm beyond the limit is impossible
bool blame_backlash(const DriveGraph& given, const DriveGraph& thinned, DriveGeometry& made);

}  // namespace gearwright
