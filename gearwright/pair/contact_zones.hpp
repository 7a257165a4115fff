// Zones of the line of action by the number of tooth pairs that share them.
#pragma once

#include <vector>

namespace gearwright {

struct ContactZone {
  double begin, end;  ///< mm of ρ_1
  int pairs;          ///< in contact meanwhile; 0: a gap behind the path's end, ratio below 1
};

/// The path begin…end, cut where a neighbour comes in or leaves; neighbours are `step` apart.
///
/// Domain    begin ≤ end, step > 0 (contract)
std::vector<ContactZone> contact_zones(double begin, double end, double step);

}  // namespace gearwright
