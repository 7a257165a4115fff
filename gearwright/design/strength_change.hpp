// Changes after which a rated design has sufficient safety factors: changes of the required safety
// factors, the load, the face width or the steel. Internal to design/.
#pragma once

#include <fmt/format.h>

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "gearwright/design/search.hpp"

namespace gearwright::detail {

inline std::string shown(double v) { return fmt::format("{:.10g}", v); }

/// A number of the problem that can be changed from its value towards a far end.
struct Knob {
  enum class Kind { limit, ratio, teeth };
  std::string field;  ///< as NearestChange::field
  double value, far;
  double scale;  ///< one unit of effort
  Kind kind;
  std::function<void(SearchProblem&, double)> set;
  std::function<std::string(double)> show;
};

/// Adds the numbers on which the safety factors depend.   Domain: designs are rated (contract)
void add_strength_knobs(const SearchProblem& problem, std::vector<Knob>& knobs);
/// Steels of the built-in table that are stronger than the steel of gear 1, the weakest first; none for
/// a plastic.
std::vector<Material> stronger_steels(const SearchRating& rating);
/// The design whose safety factors are nearest to the required ones, among at most this number of
/// trials, which are chosen at random.
std::optional<DesignRow> safest_design(const SearchProblem& problem, const SearchWatch& watch,
                                       std::int64_t most_questions);

}  // namespace gearwright::detail
