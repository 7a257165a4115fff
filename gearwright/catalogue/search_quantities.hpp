// The quantities of designs found by a search. A result contains them under `search.designs[i]`.
// They are also the columns of CSV and Parquet and of the page's table.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "gearwright/catalogue/quantity.hpp"
#include "gearwright/design/design_row.hpp"
#include "gearwright/design/nearest_change.hpp"
#include "gearwright/design/search.hpp"
#include "gearwright/design/shift_points.hpp"

namespace gearwright {

struct DesignView {
  const SearchProblem* problem;
  const DesignRow* row;
  std::function<Value()> edges{};  ///< edges of the region; empty if the result omits the edges
};

const Quantities<DesignView>& design_quantities();

/// A factor of a rating that is 1, because the spec does not give the input on which it depends.
struct AssumedFactor {
  const char* key;     ///< "Z_L", as in the results of `rate`
  const char* symbol;  ///< "Z_L"
  const char* input;   ///< key of [rating], "lubricant_viscosity_40C_mm2_s"
};

/// A finished search. search_quantities() does not list its designs, because there may be many.
/// Callers pass each design to design_quantities() instead.
struct SearchView {
  const SearchProblem* problem = nullptr;
  SearchAnswer answer;
  std::vector<NearestChange> changes;       ///< changes that would make a design feasible; empty if
                                            ///< a design is feasible
  std::optional<DesignRow> safest;          ///< the safest rated design if nothing is feasible
  std::string safest_finding;               ///< reason why the verdict rejects this design; empty
                                            ///< if its safety factors are too small
  std::optional<double> default_face_load;  ///< the default K_Hβ, if the search is rated and its
                                            ///< spec gives no K_Hβ; otherwise none
  std::vector<AssumedFactor> assumed;       ///< only if the search is rated
};
const Quantities<SearchView>& search_quantities();

/// The quantities of one point in the grid of profile shifts. Only the tables of points contain
/// them, as columns.
const Quantities<ShiftPoint>& point_quantities();

/// A change of the spec, with its key and two values as a spec writes them. An example is
/// search.interference from "exclude" to "flag".
struct SpelledChange {
  std::string key, from, to;
};
SpelledChange spelled_change(const NearestChange& change, UnitSystem units = UnitSystem::mm);

/// Returns an angle in degrees without the rounding error of a conversion to radians and back. For
/// example, if the user gave −12, the result is exactly −12.
double tidy_degrees(Angle angle);

}  // namespace gearwright
