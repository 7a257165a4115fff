#include "gearwright/base/error.hpp"

#include <algorithm>
#include <array>
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

using Kind = FailureKind;

constexpr std::array<FailureMeaning, static_cast<std::size_t>(Kind::count)> kFailures{{
    {Kind::value, "value", "the value, or the spec as a whole, is not possible"},
    {Kind::missing, "missing", "a required input is missing"},
    {Kind::no_flank, "no_flank", "a gear has no usable flank"},
    {Kind::placement, "placement", "the gears cannot be placed or shaped as the spec requires"},
    {Kind::nothing_touches, "nothing_touches", "the teeth of the two gears touch at no position"},
    {Kind::not_under_load, "not_under_load", "teeth of this kind are not computed under load"},
    {Kind::not_converged, "not_converged", "the forces under load converge at no position"},
    {Kind::not_in_build, "not_in_build", "this build of the program cannot compute the result"},
    {Kind::option, "option",
     "the error is about an option of the command line, and not about the spec"},
    {Kind::file, "file", "a file that the spec names cannot be read"},
    {Kind::defect, "defect", "a defect in Gearwright; please report it together with the spec"},
}};

constexpr bool failures_are_in_order() {
  for (std::size_t i = 0; i < kFailures.size(); ++i)
    if (kFailures[i].kind != static_cast<Kind>(i)) return false;
  return true;
}
static_assert(failures_are_in_order());

}  // namespace

std::span<const FailureMeaning> failure_meanings() { return kFailures; }

const char* to_string(FailureKind kind) { return kFailures[static_cast<std::size_t>(kind)].text; }

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
