// Stores the pinion cutters chosen for the internal gears of a search.
//
// The strength of an internal gear depends on the number of teeth of its cutter. Its path of
// contact depends on the radius at which its fillet begins. Both follow only from a generated
// tooth, which takes as long as a hundred ratings. In modules, they are equal for all designs with
// the same wheel.
//                                              theory: docs/theory/09-design-search.md, 9.7
#pragma once

#include <limits>
#include <map>
#include <mutex>
#include <optional>
#include <tuple>

#include "gearwright/design/search_problem.hpp"

namespace gearwright {

/// The cutter of an internal gear. There is no cutter if every cutter would remove a part of the
/// flanks. The start of the fillets is then unknown.
struct RingCut {
  int cutter_teeth = 0;                                          ///< z_0; 0 without a cutter
  double form_radius = std::numeric_limits<double>::infinity();  ///< d_Ff/2, modules
};

class RingCuts {
 public:
  /// The cut of the wheel of a trial with this profile shift, by cut_by_default(). Absent if the
  /// gear cannot exist. Thread-safe.
  std::optional<RingCut> of(const SearchProblem& problem, const Trial& trial, double shift);

  /// The number of stored cuts, as a measure of the work.
  std::size_t size() const;

 private:
  using Key = std::tuple<int, double, Angle, Angle, double, double, double>;
  mutable std::mutex mutex_;
  std::map<Key, std::optional<RingCut>> cuts_;
};

}  // namespace gearwright
