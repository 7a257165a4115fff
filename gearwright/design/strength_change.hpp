// Lists the changes that can give a rated design sufficient safety factors: lower required safety
// factors, a smaller load, a wider face, or a stronger steel. Internal to design/.
#pragma once

#include <fmt/format.h>

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "gearwright/design/search.hpp"

namespace gearwright::detail {

inline std::string shown(double v) { return fmt::format("{:.10g}", v); }

/// A number of the problem that can be changed from its present value `value` towards `far`.
struct Knob {
  enum class Kind { limit, ratio, teeth };
  std::string field;  ///< as NearestChange::field
  double value, far;
  double scale;  ///< change that counts as one unit of effort
  Kind kind;
  std::function<void(SearchProblem&, double)> set;
  std::function<std::string(double)> show = [](double v) { return shown(v); };
};

/// Appends one limit of the problem to `knobs`. The limit can be changed towards `far`. If the
/// problem does not set this limit, `knobs` stays as it is.
template <class Limit>
void add_limit(const SearchProblem& problem, std::vector<Knob>& knobs, const char* field,
               Limit SearchLimits::*limit, double far, double scale = 1.0) {
  const std::optional<double> value = problem.limits.*limit;
  if (!value) return;
  knobs.push_back({field, *value, far, scale, Knob::Kind::limit,
                   [limit](SearchProblem& q, double v) { q.limits.*limit = v; }});
}

/// Adds the numbers on which the safety factors depend.   Domain: designs are rated (contract)
void add_strength_knobs(const SearchProblem& problem, std::vector<Knob>& knobs);
/// Returns the steels of the built-in table with a greater σ_Hlim or a greater σ_Flim than the
/// steel of gear 1, the weakest first. The list is empty if plastics are rated.
std::vector<Material> stronger_steels(const SearchRating& rating);
/// Returns the design with the greatest safety factors, compared with the required ones. At most
/// `most_questions` trials are considered, in random order.
std::optional<DesignRow> safest_design(const SearchProblem& problem, const SearchWatch& watch,
                                       std::int64_t most_questions);

}  // namespace gearwright::detail
