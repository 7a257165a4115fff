#include "gearwright/base/error.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <set>
#include <utility>

#include <fmt/args.h>
#include <fmt/format.h>

#include "gearwright/base/contract.hpp"

namespace gearwright {

namespace {

constexpr double kSame = 1e-12;  // a decimal within this relative difference of the limit counts as
                                 // equal to it

enum class Side { down, up };

// Formats the limit with this number of digits. If the nearest decimal is outside the limit by
// more than a rounding error, the next decimal on the allowed side is used.
std::string limit_text(double limit, int digits, Side side) {
  const std::string nearest = with_digits(limit, digits);
  const double read = std::strtod(nearest.c_str(), nullptr);
  const bool beyond = side == Side::down ? read > limit : read < limit;
  if (!std::isfinite(limit) || !beyond || std::abs(read - limit) <= kSame * std::abs(limit))
    return nearest;
  const double unit = std::pow(10.0, std::floor(std::log10(std::abs(limit))) - digits + 1);
  return with_digits(read + (side == Side::down ? -unit : unit), digits);
}

}  // namespace

std::string Error::message() const {
  if (field.empty()) return rule;
  return value.empty() ? fmt::format("{}: {}", field, rule)
                       : fmt::format("{} = {}: {}", field, value, rule);
}

std::string Error::quoted() const {
  return Error{field.empty() ? field : fmt::format("`{}`", field), value, rule}.message();
}

Error absent_input(std::string field, std::string_view rest) {
  return {std::move(field), "", "is missing" + std::string(rest), FailureKind::missing};
}

Error refused(std::string field, double value, std::string rule) {
  return {std::move(field), format_number(value), std::move(rule)};
}

Error refused(std::string field, int value, std::string rule) {
  return {std::move(field), fmt::format("{}", value), std::move(rule)};
}

Error refused(std::string field, double value, std::initializer_list<double> limits,
              std::string_view rule) {
  int digits = kUsualDigits;
  for (const double limit : limits) digits = std::max(digits, digits_between(value, limit));
  fmt::dynamic_format_arg_store<fmt::format_context> texts;
  for (std::size_t i = 0; i < limits.size(); ++i) {
    const double limit = limits.begin()[i];
    const bool greatest = limits.size() == 1 ? value >= limit : i == 1;
    texts.push_back(limit_text(limit, digits, greatest ? Side::down : Side::up));
  }
  return {std::move(field), with_digits(value, digits),
          fmt::vformat(fmt::string_view(rule.data(), rule.size()), texts)};
}

Error within(std::string_view whole, Error error) {
  error.field = error.field.empty() ? std::string(whole) : fmt::format("{}.{}", whole, error.field);
  return error;
}

Error following_from(std::string field, std::string value, std::string_view how,
                     const Error& error) {
  return {std::move(field), std::move(value), fmt::format("{} {}", how, error.quoted())};
}

namespace {

// Returns the rule of an error from absent_input(), without its first words "is missing" and the
// separator behind them.
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
