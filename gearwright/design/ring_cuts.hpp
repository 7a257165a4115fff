// The pinion cutters of the internal gears of a search: each chosen once.
//
// What an internal gear bears depends on its cutter by the number of its teeth, and its path of
// contact by the radius where the fillet begins. Both take a cut tooth, which costs as much as a
// hundred ratings; in modules they are those of every design with the same wheel.
//                                              theory: docs/theory/09-design-search.md, 9.7
#pragma once

#include <limits>
#include <map>
#include <mutex>
#include <optional>
#include <tuple>

#include "gearwright/design/search_problem.hpp"

namespace gearwright {

/// Without a cutter where none leaves the flanks whole: nobody knows then where the fillets begin.
struct RingCut {
  int cutter_teeth = 0;                                          ///< z_0; 0: no cutter
  double form_radius = std::numeric_limits<double>::infinity();  ///< d_Ff/2, modules
};

class RingCuts {
 public:
  /// Of the wheel of a trial with its shift, by cut_by_default(); none: there is no such gear. Safe
  /// from several threads.
  std::optional<RingCut> of(const SearchProblem& problem, const Trial& trial, double shift);

  /// How many teeth were cut: the work.
  std::size_t size() const;

 private:
  using Key = std::tuple<int, double, Angle, Angle, double, double, double>;
  mutable std::mutex mutex_;
  std::map<Key, std::optional<RingCut>> cuts_;
};

}  // namespace gearwright
