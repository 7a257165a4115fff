// Zones of the line of action, by the number of tooth pairs in contact.
#pragma once

#include <vector>

namespace gearwright {

struct ContactZone {
  double begin, end;  ///< mm of ρ_1
  int pairs;          ///< number of tooth pairs in contact; 0 in the gap after the end of the path
                      ///< if the contact ratio is below 1
};

/// The zones of the path begin…end. A zone ends where a neighbouring tooth pair enters or leaves
/// contact; neighbouring pairs are `step` apart.
///
/// Domain    begin ≤ end, step > 0 (contract)
std::vector<ContactZone> contact_zones(double begin, double end, double step);

}  // namespace gearwright
