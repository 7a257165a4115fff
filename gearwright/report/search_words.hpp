// Words for the limits, objectives and designs of a search.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "gearwright/design/design_row.hpp"
#include "gearwright/design/search_problem.hpp"

namespace gearwright {

/// The reason for rejecting a trial, such as "centre distance out of reach".
std::string_view words_of(Limit limit);

/// Words for an objective, to be used on axes and in sentences.
struct ObjectiveWords {
  std::string_view name;    ///< "contact ratio"
  std::string_view symbol;  ///< "ε_α", as in html_text.hpp; may be empty
  std::string_view unit;    ///< may be empty
  bool greater = false;     ///< true if greater values are better
};
ObjectiveWords words_of(Objective objective);

/// The value of the objective for any design, ranked or not. None for |ζ| if a flank reaches its
/// base tangent point.
std::optional<double> value_of(const SearchProblem& problem, const DesignRow& row,
                               Objective objective);

/// Module, tooth numbers and helix angle: "2.5 · 28:54", or for a helical pair "2.5 · 28:54 · 8°".
std::string design_name(const Trial& trial);

}  // namespace gearwright
