// Minimises a function that is slow to compute. The search works on models of the function. A model
// is exact at one point, its center, and is fast to evaluate at any other point.
//
// The reach of a search is a fraction of the distance between the bounds. The search examines only
// points within the reach of the center. The first search covers the whole range. Then the function
// is computed at the lowest point of the model. If the function is less there than at the center,
// this point becomes the center of the next model. Otherwise, the same model is searched again with
// a smaller reach.
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "gearwright/contact/compensation.hpp"

namespace gearwright::detail {

inline constexpr int kMostCenters = 6;  // greatest number of models after the first one
// The greatest reach of the second search and of all later ones.
inline constexpr double kNextReach = 0.25;
inline constexpr double kLastReach = 1e-3;  // the search ends below this reach

/// Returns a box around `center` that lies within the bounds. In each direction, it extends from
/// `center` by at most `reach` times the width of the bounds.
inline std::vector<Correction> around(const std::vector<Correction>& bounds, double reach,
                                      const std::vector<double>& center) {
  std::vector<Correction> box = bounds;
  for (std::size_t i = 0; i < box.size(); ++i) {
    const double most = reach * (bounds[i].hi - bounds[i].lo);
    box[i].lo = std::max(bounds[i].lo, center[i] - most);
    box[i].hi = std::min(bounds[i].hi, center[i] + most);
  }
  return box;
}

/// Returns the center at which the function is least. The first center is `center`. The search ends
/// after kMostCenters models in addition to the first one, or when the reach is below kLastReach.
/// It also ends when the lowest value of the model within the reach is less than the value at the
/// center by at most `gain`.
///
///   model_at(center)               the model that is exact at the center
///   value(model, v)                the value of the model at v
///   lowest(model, center, reach)   the lowest point of the model within
///                                  around(bounds, reach, center); the first search has reach 1
///
/// Laws      the function at the result is not greater than the function at `center`
template <class ModelAt, class Value, class Lowest>
std::vector<double> lowest_by_models(std::vector<double> center, double gain, ModelAt model_at,
                                     Value value, Lowest lowest) {
  auto model = model_at(center);
  double least = value(model, center);
  double reach = 1.0;
  for (int i = 0; i < kMostCenters && reach >= kLastReach; ++i) {
    std::vector<double> next = lowest(model, center, reach);
    const double promised = least - value(model, next);
    if (!(promised > gain)) break;
    auto there = model_at(next);
    const double gained = least - value(there, next);
    reach = std::min(reach, kNextReach) * (gained < 0.25 * promised ? 0.3 : 1.0);
    if (!(gained > 0.0)) continue;
    least -= gained;
    center = std::move(next);
    model = std::move(there);
  }
  return center;
}

}  // namespace gearwright::detail
