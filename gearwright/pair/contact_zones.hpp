// Zones of the line of action by the number of tooth pairs that share them.
#pragma once

#include <vector>

namespace gearwright {

struct ContactZone {
  double begin, end;  ///< mm of ρ_1
  int pairs;          ///< number of pairs in contact; 0 in a gap after the end of the path, at a
                      ///< ratio below 1
};

/// The path begin…end, cut where a neighbour enters or leaves; neighbours are `step` apart.
///
/// Domain    begin ≤ end, step > 0 (contract)
std::vector<ContactZone> contact_zones(double begin, double end, double step);

}  // namespace gearwright
