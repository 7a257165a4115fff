// Subplex: descends from a start point, in groups of two to five variables. Internal to math/.
#pragma once

#include <vector>

#include "gearwright/math/trials.hpp"

namespace gearwright::detail {

/// The best point found from `start`.
std::vector<double> subplex(const MinimiserTask& task, Trials& trials, std::vector<double> start);

}  // namespace gearwright::detail
