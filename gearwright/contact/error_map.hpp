// Peak to peak of the transmission error over a grid of two errors, on all cores.
//
// Every point of the map has its own curve. The result does not depend on the number of threads.
#pragma once

#include <functional>
#include <vector>

#include "gearwright/base/progress.hpp"
#include "gearwright/contact/contact_pair.hpp"

namespace gearwright {

struct ErrorMap {
  std::vector<double> x, y;                ///< in the caller's units
  std::vector<std::vector<double>> value;  ///< rad, [iy][ix]; NaN if nothing touches
};

/// `pair_at(x, y)` makes the pair under these errors. It is called from several threads at once.
///
/// Units     rad
/// Domain    positions ≥ 2, x and y not empty (contract); `threads` 0 means one per core
ErrorMap map_of_errors(const std::vector<double>& x, const std::vector<double>& y,
                       const std::function<ContactPair(double, double)>& pair_at, int positions,
                       int threads = 0, Progress* progress = nullptr);

}  // namespace gearwright
