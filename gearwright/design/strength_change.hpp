// Changes that give a rated design sufficient safety: of the required safety factors, the load, the
// face width or the steel. Internal to design/.
#pragma once

#include <fmt/format.h>

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "gearwright/design/search.hpp"

namespace gearwright::detail {

inline std::string shown(double v) { return fmt::format("{:.10g}", v); }

/// A number that can be moved from its value towards a far end.
struct Knob {
  enum class Kind { limit, ratio, teeth };
  std::string field;  ///< of SearchProblem, or as NearestChange::field
  double value, far;
  double scale;  ///< one unit of effort
  Kind kind;
  std::function<void(SearchProblem&, double)> set;
  std::function<std::string(double)> show;
};

/// Domain    the problem rates its designs (contract), as of all here
void add_strength_knobs(const SearchProblem& problem, std::vector<Knob>& knobs);

/// Steels of the shipped table that are stronger than that of gear 1, the least strong first; none
/// for a plastic.
std::vector<Material> stronger_steels(const SearchRating& rating);

/// The design that comes nearest to the required safety factors, among this number of trials in
/// random order.
std::optional<DesignRow> safest_design(const SearchProblem& problem, const SearchWatch& watch,
                                       std::int64_t most_questions);

}  // namespace gearwright::detail
