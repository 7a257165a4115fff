// Computes the places of a planet in a drive. A place is an angle around the axis of the carrier at
// which a copy of the planet can be assembled.
//
//   u      place of a copy in turns, counter-clockwise from copy 0
//   N*     number of places per turn: u = n/N* [T13.12]; 0 if any place is possible
//   δ      clocking, the angle between the two gears of a stepped planet relative to copy 0
//          [T13.14]
//                                              theory: docs/theory/13-drives.md
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "gearwright/drive/drive_graph.hpp"
#include "gearwright/drive/rational.hpp"

namespace gearwright {

struct DriveGeometry;

struct Assembly {
  long long places = 0;            ///< N*; 0 if any place is possible
  bool equal = false;              ///< true if the copies are at equal pitch
  std::vector<Rational> turns;     ///< u of each copy, u_0 = 0
  std::vector<Rational> clocking;  ///< δ of each copy, turns; empty unless the spacing is
                                   ///< `equal_clocked` and the planet is stepped
};

/// Returns N* of a group of planets.
///
/// Formula   A copy moves from 0 to u around the axis of the carrier, while the central gears are
///           at rest. The copy can be assembled at u if and only if every mesh moves by whole teeth
///           for some rotations χ of the planet bodies: A χ + b u ∈ Zᴹ.
///           N* = gcd |y·b| over the rows y of a saturated integer basis of y A = 0; [T13.12]
long long assembly_places(const DriveGraph& graph, const PlanetGroup& group);

/// Computes the places of the N copies. If the spec gives positions for the planets of the group,
/// the copies are at these positions. Otherwise, they are at the places u_i = n_i/N* with
/// n_i = floor(i N*/N + 1/2), [T13.13]. If the spacing is `equal_clocked` or N* = 0, they are at
/// equal pitch instead. If there are fewer places than copies, some copies get the same place.
///
/// `geometry`  if not null, the message proposes only numbers of planets that do not overlap
/// Errors    `drive.spacing` if this spacing is impossible. For the spacing `equal`, the message
///           proposes similar tooth numbers and numbers of planets. `drive.positions` if the number
///           of angles is not N, or if the teeth do not mesh at a given position. In the second
///           case, the message gives the nearest place
Result<Assembly> assemble(const DriveGraph& graph, const PlanetGroup& group,
                          const DriveGeometry* geometry = nullptr);

}  // namespace gearwright
