#include "gearwright/pair/contact_zones.hpp"

#include <algorithm>
#include <cmath>

#include "gearwright/base/contract.hpp"

namespace gearwright {

std::vector<ContactZone> contact_zones(double begin, double end, double step) {
  GW_EXPECTS(begin <= end && step > 0.0);
  // The k-th pair ahead leaves contact at end − k step, and the k-th pair behind enters at
  // begin + k step.
  const double ratio = (end - begin) / step;
  const int whole = static_cast<int>(std::floor(ratio));
  std::vector<double> cuts{begin, end};
  for (int k = 1; k <= whole; ++k) {
    cuts.push_back(begin + k * step);
    cuts.push_back(end - k * step);
  }
  std::sort(cuts.begin(), cuts.end());
  // Relative to the pitch. If the contact ratio is an integer, one tooth pair enters contact at the
  // position at which another pair leaves contact.
  constexpr double kSameCut = 1e-9;
  const double nothing = kSameCut * step;
  std::vector<ContactZone> zones;
  double from = begin;
  for (const double cut : cuts) {
    if (cut - from < nothing) continue;
    const double middle = 0.5 * (from + cut);
    const int pairs = static_cast<int>(std::floor((end - middle) / step)) +
                      static_cast<int>(std::floor((middle - begin) / step)) + 1;
    zones.push_back({from, cut, pairs});
    from = cut;
  }
  if (ratio < 1.0) zones.push_back({end, begin + step, 0});
  return zones;
}

}  // namespace gearwright
