// Computes the places around the carrier at which the teeth of every copy of a planet mesh.
//
//   u      place of a copy in turns, counter-clockwise from copy 0
//   N*     number of places per turn: u = n/N* [T13.12]; 0 if any place is possible
//   δ      clocking of a stepped planet's second gear against its first [T13.14]
//                                              theory: docs/theory/13-drives.md
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "gearwright/drive/drive_graph.hpp"
#include "gearwright/drive/rational.hpp"

namespace gearwright {

struct Assembly {
  long long places = 0;            ///< N*; 0 if any place is possible
  bool equal = false;              ///< true if the copies are at equal pitch
  std::vector<Rational> turns;     ///< u of each copy, u_0 = 0
  std::vector<Rational> clocking;  ///< δ of each copy, turns; empty if all copies are identical
};

/// N* of a group.
///
/// Formula   A copy turned by u about the carrier, with the central gears at rest, meshes iff every
///           mesh has moved by whole teeth, A χ + b u ∈ Zᴹ. With Y a saturated integer basis of
///           y A = 0, N* = gcd |y·b|; [T13.12]
long long assembly_places(const DriveGraph& graph, const PlanetGroup& group);

/// The places of the copies. They follow from the given positions of the body if there are any,
/// otherwise from the spacing: n_i = floor(i N*/N + 1/2), [T13.13].
///
/// Errors    `drive.spacing` that does not assemble, with similar tooth numbers that do;
///           `drive.positions` at which teeth do not meet, with the next place.
///           If there are fewer places than copies, some copies get the same place; this is no error.
Result<Assembly> assemble(const DriveGraph& graph, const PlanetGroup& group);

}  // namespace gearwright
