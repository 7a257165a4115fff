#include "gearwright/base/missing.hpp"

#include <algorithm>
#include <set>
#include <string>
#include <string_view>

#include "gearwright/base/contract.hpp"

namespace gearwright {

namespace {

// The rule without its beginning "is missing", which absent_input() adds.
std::string_view what_is_wanted(const Error& error) {
  std::string_view rule = error.rule;
  rule.remove_prefix(std::string_view("is missing").size());
  const std::size_t words = rule.find_first_not_of(";: ");
  return words == std::string_view::npos ? std::string_view() : rule.substr(words);
}

}  // namespace

Error all_missing(const std::vector<Error>& errors) {
  GW_EXPECTS(!errors.empty());
  const auto other = std::find_if(errors.begin(), errors.end(), [](const Error& error) {
    return error.kind != FailureKind::missing;
  });
  if (other != errors.end()) return *other;
  Error all = errors.front();
  std::set<std::string> named{all.field};
  std::set<std::string_view> written{what_is_wanted(errors.front())};
  for (const Error& error : errors) {
    if (!named.insert(error.field).second) continue;
    const std::string_view wanted = what_is_wanted(error);
    all.rule += (named.size() == 2 ? "; also missing: " : ", ") + error.field;
    if (written.insert(wanted).second && !wanted.empty())
      all.rule += " (" + std::string(wanted) + ")";
  }
  return all;
}

}  // namespace gearwright
