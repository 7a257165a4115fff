// The correlations of [scatter] as correlations of its tolerances.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "gearwright/job/scatter_answer.hpp"

namespace gearwright {

namespace {

// The error if a block of correlated inputs is not in one group. The indices require that one group
// changes while the others do not, which is impossible if a block is divided among groups.
std::optional<Error> split_block(const std::vector<ScatterTolerance>& tolerances,
                                 const std::vector<ToleranceGroup>& groups,
                                 const std::vector<ToleranceCorrelation>& correlations) {
  for (const auto& block : correlated_blocks(tolerances.size(), correlations)) {
    const auto holds = [&](const ToleranceGroup& group) {
      return std::all_of(block.begin(), block.end(), [&](std::size_t t) {
        return std::count(group.tolerances.begin(), group.tolerances.end(), t) > 0;
      });
    };
    if (std::any_of(groups.begin(), groups.end(), holds)) continue;
    std::vector<std::string> names;
    for (const std::size_t t : block) names.push_back('"' + tolerances[t].name + '"');
    return Error{
        "scatter.groups", "",
        fmt::format("correlated inputs must be in one group, because one of them alone has no "
                    "indices; give correlated = [{}] in [scatter.groups], or indices = false",
                    fmt::join(names, ", "))};
  }
  return std::nullopt;
}

}  // namespace

Result<std::vector<ToleranceCorrelation>> correlations_of(
    const ScatterInput& input, const std::vector<ScatterTolerance>& tolerances,
    const std::vector<ToleranceGroup>& groups) {
  std::vector<std::string> names;
  for (const ScatterTolerance& t : tolerances) names.push_back(t.name);
  std::vector<ToleranceCorrelation> correlations;
  for (const ScatterInput::Correlation& given : input.correlations) {
    const std::string field =
        fmt::format("scatter.correlations[{}].between", correlations.size() + 1);
    std::array<std::size_t, 2> pair{};
    for (std::size_t k = 0; k < 2; ++k) {
      const auto at = std::find(names.begin(), names.end(), given.between[k]);
      if (at == names.end())
        return Error{
            field, given.between[k],
            fmt::format("is not an input of this spec; the inputs are {}", fmt::join(names, ", "))};
      pair[k] = static_cast<std::size_t>(at - names.begin());
    }
    const auto [first, second] = std::minmax(pair[0], pair[1]);
    const auto same = [first = first, second = second](const ToleranceCorrelation& c) {
      return c.first == first && c.second == second;
    };
    if (std::any_of(correlations.begin(), correlations.end(), same))
      return Error{field, "",
                   "the correlation of these two inputs is given twice; remove one of the two"};
    correlations.push_back({first, second, given.value});
  }
  if (auto error = check_correlations(tolerances, correlations)) {
    error->field = "scatter." + error->field;
    return *error;
  }
  if (input.indices)
    if (auto error = split_block(tolerances, groups, correlations)) return *error;
  return correlations;
}

}  // namespace gearwright
