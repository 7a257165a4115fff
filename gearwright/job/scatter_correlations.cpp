#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "gearwright/catalogue/key.hpp"
#include "gearwright/job/scatter_answer.hpp"

namespace gearwright {

namespace {

// Returns an error if correlated inputs are divided among several groups. For the indices, one
// group must change while the other groups do not. This is impossible if correlated inputs are in
// different groups.
std::optional<Error> split_block(const std::vector<ScatterTolerance>& tolerances,
                                 const std::vector<ToleranceGroup>& groups,
                                 const std::vector<ToleranceCorrelation>& correlations) {
  for (const auto& block : correlated_blocks(tolerances, correlations)) {
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
        fmt::format("correlated inputs must be in one group, because indices exist only for the "
                    "whole group; give correlated = [{}] in [scatter.groups], or indices = false",
                    fmt::join(names, ", "))};
  }
  return std::nullopt;
}

// Returns the indices of the coordinates of a sample to which the name in `between` refers. The
// name of a bore refers to both coordinates of the bore. Every other name refers to a single
// coordinate. The name of any other input with several coordinates refers to the first of them.
std::vector<std::size_t> coordinates_named(const std::string& name,
                                           const std::vector<ScatterTolerance>& tolerances) {
  const std::vector<std::string> names = coordinate_names(tolerances);
  const auto at = std::find_if(names.begin(), names.end(), [&](const std::string& known) {
    return name == known || name == key_in(UnitSystem::inch, known);
  });
  if (at != names.end()) return {static_cast<std::size_t>(at - names.begin())};
  std::size_t first = 0;
  for (const ScatterTolerance& t : tolerances) {
    if (t.name == name)
      return t.bore() ? std::vector{first, first + 1} : std::vector<std::size_t>{first};
    first += static_cast<std::size_t>(t.coordinates());
  }
  return {};
}

// Returns the names of the coordinates that can be correlated.
std::vector<std::string> names_with_score(const std::vector<ScatterTolerance>& tolerances) {
  const std::vector<std::string> names = coordinate_names(tolerances);
  std::vector<std::string> found;
  std::size_t at = 0;
  for (const ScatterTolerance& t : tolerances)
    for (int k = 0; k < t.coordinates(); ++k, ++at)
      if (t.has_score(k)) found.push_back(names[at]);
  return found;
}

Result<std::vector<ToleranceCorrelation>> correlations_in_mm(
    const ScatterInput& input, const std::vector<ScatterTolerance>& tolerances,
    const std::vector<ToleranceGroup>& groups) {
  const std::vector<std::string> names = coordinate_names(tolerances);
  std::vector<ToleranceCorrelation> correlations;
  for (std::size_t n = 0; n < input.correlations.size(); ++n) {
    const ScatterInput::Correlation& given = input.correlations[n];
    const std::string field = fmt::format("scatter.correlations[{}].between", n + 1);
    std::array<std::vector<std::size_t>, 2> named;
    for (std::size_t k = 0; k < 2; ++k) {
      named[k] = coordinates_named(given.between[k], tolerances);
      if (named[k].empty())
        return Error{field, given.between[k],
                     "is not an input of this spec; " +
                         word_hint(given.between[k], names_with_score(tolerances))};
    }
    for (std::size_t k = 0; k < 2; ++k)
      if (named[k].size() > named[1 - k].size())
        return Error{field, given.between[k],
                     fmt::format("is a position and can be correlated only with the position of "
                                 "another bore; to correlate it with {}, give {} or {} instead",
                                 given.between[1 - k], names[named[k][0]], names[named[k][1]])};
    for (std::size_t k = 0; k < named[0].size(); ++k) {
      const auto [first, second] = std::minmax(named[0][k], named[1][k]);
      const auto same = [first = first, second = second](const ToleranceCorrelation& c) {
        return c.first == first && c.second == second;
      };
      if (first == second || std::any_of(correlations.begin(), correlations.end(), same))
        return Error{field, "",
                     first == second ? "must be two different inputs, but both names mean the same "
                                       "input"
                                     : "the correlation of these two inputs is given twice; remove "
                                       "one of the two"};
      correlations.push_back({first, second, given.value, n + 1});
    }
  }
  if (auto error = check_correlations(tolerances, correlations)) {
    error->field = "scatter." + error->field;
    return *error;
  }
  if (input.indices)
    if (auto error = split_block(tolerances, groups, correlations)) return *error;
  return correlations;
}

}  // namespace

Result<std::vector<ToleranceCorrelation>> correlations_of(
    const JobSpec& spec, const std::vector<ScatterTolerance>& tolerances,
    const std::vector<ToleranceGroup>& groups) {
  auto found = correlations_in_mm(spec.scatter, tolerances, groups);
  if (found) return found;
  // The names of the coordinates of a bore are not keys of the catalogue. No other function
  // converts them to inch, so they are converted here.
  Error error = found.error();
  for (const std::string& name : coordinate_names(tolerances))
    for (std::string* text : {&error.value, &error.rule})
      for (std::size_t at = 0; (at = text->find(name, at)) != text->npos; at += name.size())
        text->replace(at, name.size(), key_in(spec.units(), name));
  return error;
}

}  // namespace gearwright
