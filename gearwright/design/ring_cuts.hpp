// The pinion cutters of the internal gears of a search: each is chosen once.
//
// The strength of an internal gear depends on the number of teeth of its cutter, and its path of
// contact on the radius where the fillet begins. Both need a generated tooth, which costs as much
// as a hundred ratings. In modules they are equal for every design with the same wheel.
//                                              theory: docs/theory/09-design-search.md, 9.7
#pragma once

#include <limits>
#include <map>
#include <mutex>
#include <optional>
#include <tuple>

#include "gearwright/design/search_problem.hpp"

namespace gearwright {

/// There is no cutter if none leaves the whole flanks. The start of the fillets is then unknown.
struct RingCut {
  int cutter_teeth = 0;                                          ///< z_0; 0 without a cutter
  double form_radius = std::numeric_limits<double>::infinity();  ///< d_Ff/2, modules
};

class RingCuts {
 public:
  /// The cut of the wheel of a trial with its shift, made by cut_by_default(); none if there is no
  /// such gear. Thread-safe.
  std::optional<RingCut> of(const SearchProblem& problem, const Trial& trial, double shift);

  /// The number of generated teeth, as a measure of the work.
  std::size_t size() const;

 private:
  using Key = std::tuple<int, double, Angle, Angle, double, double, double>;
  mutable std::mutex mutex_;
  std::map<Key, std::optional<RingCut>> cuts_;
};

}  // namespace gearwright
