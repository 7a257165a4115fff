// The quantities of designs ranked by their scatter. A result contains them under
// `scatter_designs`.
#pragma once

#include <cstdint>
#include <string>

#include "gearwright/catalogue/scatter_quantities.hpp"
#include "gearwright/catalogue/search_quantities.hpp"

namespace gearwright {

struct ScatteredDesign {
  std::int64_t number;  ///< rank of the design in the search
  DesignView design;
  const ScatterView* scatter;  ///< null if the scatter could not be computed
  std::string reason{};        ///< the reason, if the scatter could not be computed
};
const Quantities<ScatteredDesign>& scattered_design_quantities();

/// Data of a ranking of designs by a percentile, without the designs themselves.
/// scattered_design_quantities() reads the designs one by one.
struct ScatterStudyView {
  double percent;  ///< percentile of the ranking
  int samples, replicates;
  long long seed, count;
};
const Quantities<ScatterStudyView>& scatter_study_quantities();

}  // namespace gearwright
