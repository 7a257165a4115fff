// The quantities of designs found by a search: `search.designs[i]`, the columns of CSV and Parquet,
// the page's table.
#pragma once

#include <functional>
#include <string>

#include "gearwright/catalogue/quantity.hpp"
#include "gearwright/design/design_row.hpp"
#include "gearwright/design/nearest_change.hpp"
#include "gearwright/design/search.hpp"
#include "gearwright/design/shift_points.hpp"

namespace gearwright {

struct DesignView {
  const SearchProblem* problem;
  const DesignRow* row;
  std::function<Value()> edges{};  ///< of the region; none if they are omitted
};

const Quantities<DesignView>& design_quantities();

/// A finished search. Its designs are read one by one (design_quantities), because there may be
/// many.
struct SearchView {
  const SearchProblem* problem;
  const SearchAnswer* answer;
  const std::vector<NearestChange>* changes;
  const DesignRow* safest = nullptr;  ///< NearestChanges::safest
};
const Quantities<SearchView>& search_quantities();

/// A point of the grid of shifts, for columns only.
const Quantities<ShiftPoint>& point_quantities();

/// A change in the words of a file: search.interference, "exclude", "flag".
struct SpelledChange {
  std::string key, from, to;
};
SpelledChange spelled_change(const NearestChange& change);

/// Degrees as they were given: −12, not the result of converting −12° to radians and back.
double tidy_degrees(Angle angle);

}  // namespace gearwright
