#include "gearwright/base/number_text.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <locale>
#include <sstream>

namespace gearwright {

std::string fixed_decimals(double x, int decimals) {
  std::string text = fmt::format("{:.{}f}", x, decimals);
  if (text.front() == '-' && text.find_first_not_of("-0.") == std::string::npos) text.erase(0, 1);
  return text;
}

std::string short_decimals(double x, int most) {
  std::string text = fixed_decimals(x, most);
  if (text.find('.') != std::string::npos) {
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
  }
  return text;
}

double rounded_up(double x, int decimals) {
  const double scale = std::pow(10.0, decimals);
  const double nearest = std::round(x * scale);
  constexpr double kRounding = 4 * std::numeric_limits<double>::epsilon();
  const bool same = std::abs(x * scale - nearest) <= kRounding * std::abs(nearest);
  return (same ? nearest : std::ceil(x * scale)) / scale;
}

double rounded_down(double x, int decimals) { return -rounded_up(-x, decimals); }

double without_rounding_error(double x) {
  return std::strtod(fmt::format("{:.15g}", x).c_str(), nullptr);
}

std::string with_digits(double x, int digits) {
  const std::string text = fmt::format("{:.{}g}", x, digits);
  return std::strtod(text.c_str(), nullptr) == x ? fmt::format("{}", x) : text;
}

std::string rough_count(double x) {
  const std::string text = fmt::format("{:.3g}", x);
  return std::abs(x) < 1e6 ? format_number(std::strtod(text.c_str(), nullptr)) : text;
}

int digits_between(double x, double other) {
  constexpr int kAllDigits = 17;  // sufficient for every double
  if (x == other) return kUsualDigits;
  for (int d = kUsualDigits; d <= kAllDigits; ++d)
    if (with_digits(x, d) != with_digits(other, d)) return d;
  return kUsualDigits;
}

std::optional<std::int64_t> whole_number(std::string_view text) {
  std::int64_t value = 0;
  const char* const last = text.data() + text.size();
  const auto [end, error] = std::from_chars(text.data(), last, value);
  return error == std::errc() && end == last ? std::optional(value) : std::nullopt;
}

std::optional<double> decimal_number(std::string_view text) {
  if (text.find_first_not_of("+-.0123456789eE") != text.npos) return std::nullopt;
  std::istringstream in{std::string(text)};
  in.imbue(std::locale::classic());
  double x = 0.0;
  if (!(in >> x) || in.peek() != std::istringstream::traits_type::eof()) return std::nullopt;
  return x;
}

std::string format_number(double x) { return with_digits(x, kUsualDigits); }

std::string format_number(double x, double other) {
  return with_digits(x, digits_between(x, other));
}

}  // namespace gearwright
