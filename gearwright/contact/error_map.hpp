// Peak to peak of the transmission error over a grid of two errors, computed on all cores.
//
// Every grid point is computed independently, so the number of threads does not change the result.
#pragma once

#include <functional>
#include <vector>

#include "gearwright/base/progress.hpp"

namespace gearwright {

struct ErrorMap {
  std::vector<double> x, y;                ///< errors in the caller's units
  std::vector<std::vector<double>> value;  ///< rad, [iy][ix]; NaN if nothing touches
};

/// Returns the map of the peak-to-peak TE. `te_at(x, y)` must return TE over one pitch, like
/// transmission_error(), for the errors x and y. Several threads call `te_at` at the same time.
///
/// Units     TE in rad, errors in the caller's units
/// Domain    x and y not empty (contract); `threads` 0 means one per core
ErrorMap map_of_errors(const std::vector<double>& x, const std::vector<double>& y,
                       const std::function<std::vector<double>(double, double)>& te_at,
                       int threads = 0, Progress* progress = nullptr);

}  // namespace gearwright
