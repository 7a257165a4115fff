// Converts numbers and keys in sentences of the program, which are written in mm, to inch. Every
// length in a sentence has its own unit, as in "1 mm, 2 mm and 5 mm". A module stays in mm. A
// no-break space precedes the unit of a module, so that the search for units does not find it.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <utility>

#include "gearwright/base/number_text.hpp"
#include "gearwright/catalogue/spec_keys.hpp"
#include "gearwright/catalogue/unit_system.hpp"

namespace gearwright {

namespace {

struct NumberText {
  std::string_view text;
  double value;
};

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool of_word(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || is_digit(c);
}

std::optional<NumberText> number_at(std::string_view text) {
  std::size_t end = text.starts_with('-') ? 1 : 0;
  const std::size_t first = end;
  const auto skip_digits = [&] {
    while (end < text.size() && is_digit(text[end])) ++end;
  };
  skip_digits();
  if (end == first) return std::nullopt;
  if (end + 1 < text.size() && text[end] == '.' && is_digit(text[end + 1])) {
    ++end;
    skip_digits();
  }
  if (end + 2 < text.size() && text[end] == 'e' && (text[end + 1] == '-' || text[end + 1] == '+')) {
    end += 2;
    skip_digits();
  }
  if (end < text.size() && of_word(text[end])) return std::nullopt;  // a part of a word, "2nd"
  return NumberText{text.substr(0, end),
                    std::strtod(std::string(text.substr(0, end)).c_str(), nullptr)};
}

// Returns the number in the inch unit. A number with at least four significant digits and at least
// three decimals is usually rounded. Its result has one significant digit less, so that all digits
// of the result are correct. Every other result has at least four significant digits. After "at
// least", the number is rounded up, and after "at most", it is rounded down.
std::string number_in(const NumberText& number, const KeyUnit& unit, std::string_view before) {
  const double x = unit.to_inch(number.value);
  if (x == 0.0) return "0";
  const std::string_view mantissa = number.text.substr(0, number.text.find('e'));
  int digits = 0;
  for (const char c : mantissa)
    if (is_digit(c) && (digits > 0 || c != '0')) ++digits;
  constexpr std::size_t kRounded = 3;
  constexpr int kFull = 4;
  const std::size_t point = mantissa.find('.');
  const bool rounded = point != mantissa.npos && mantissa.size() - point > kRounded;
  digits = rounded && digits >= kFull ? digits - 1 : std::max(kFull, digits);
  const int power = static_cast<int>(std::floor(std::log10(std::abs(x))));
  const int decimals = std::max(0, digits - 1 - power);
  const double shown = before.ends_with("least ")  ? rounded_up(x, decimals)
                       : before.ends_with("most ") ? rounded_down(x, decimals)
                                                   : x;
  return short_decimals(shown, decimals);
}

struct Symbol {
  std::string_view metric, inch, key;
};
constexpr std::array kSymbols{Symbol{" mm", " in", "_mm"}, Symbol{" µm", " µin", "_um"}};

// Returns the unit after a number, if it is a length. Returns null if it is a part of another unit
// such as "N/mm" or "mm²".
const Symbol* symbol_at(std::string_view text) {
  for (const Symbol& s : kSymbols) {
    if (!text.starts_with(s.metric)) continue;
    const char next = text.size() == s.metric.size() ? '.' : text[s.metric.size()];
    const bool part =
        of_word(next) || next == '/' || (static_cast<unsigned char>(next) & 0x80) != 0;
    if (!part) return &s;
  }
  return nullptr;
}

bool ends_with_any(std::string_view text, std::initializer_list<std::string_view> ends) {
  for (const std::string_view end : ends)
    if (text.ends_with(end)) return true;
  return false;
}

bool starts_with_any(std::string_view text, std::initializer_list<std::string_view> starts) {
  for (const std::string_view start : starts)
    if (text.starts_with(start)) return true;
  return false;
}

bool limit_follows(std::string_view before) {
  return ends_with_any(before, {"between ", "than ", "least ", "most ", "usually "});
}

class SentenceInInch {
 public:
  SentenceInInch(std::string_view sentence, const KeyUnit* of) : text_(sentence), of_(of) {}

  std::string converted() {
    while (at_ < text_.size()) {
      const bool begins = at_ == 0 || (!of_word(text_[at_ - 1]) && text_[at_ - 1] != '.');
      const auto number = begins ? number_at(rest()) : std::nullopt;
      if (number) {
        take(*number);
      } else if (begins && of_word(text_[at_])) {
        take_word();
      } else {
        out_ += text_[at_++];
      }
    }
    return std::move(out_);
  }

 private:
  std::string_view rest() const { return text_.substr(at_); }

  void take(const NumberText& number) {
    const std::string_view before = text_.substr(0, at_);
    const std::string_view after = rest().substr(number.text.size());
    const Symbol* const symbol = symbol_at(after);
    const bool limit =
        of_ && !symbol &&
        (limit_follows(before) || (limits_ && ends_with_any(before, {"and ", "to "})));
    const bool bare = after.empty() || starts_with_any(after, {",", ";", ".", ":", ")", " and ",
                                                               " to ", " or ", " ("});
    at_ += number.text.size();
    if (symbol) {
      out_ += number_in(number, *metric_unit(symbol->key), before);
      out_ += symbol->inch;
      at_ += symbol->metric.size();
    } else if (limit && bare) {
      out_ += number_in(number, *of_, before);
      limits_ = true;
    } else {
      out_ += number.text;
    }
  }

  // Copies a word or a path of keys. The key of a length gets its name in inch. If " = " and a
  // number follow the key, the number is also converted.
  void take_word() {
    std::size_t end = 0;
    const auto joins = [&](std::size_t i) {
      return starts_with_any(rest().substr(i), {".", "[", "]"}) && i + 1 < rest().size() &&
             (of_word(rest()[i + 1]) || rest().substr(i).starts_with("]."));
    };
    while (end < rest().size() && (of_word(rest()[end]) || joins(end))) ++end;
    const std::string_view word = rest().substr(0, end);
    const KeyUnit* const unit = is_spec_key(word) ? metric_unit(word) : nullptr;
    out_ += unit ? key_in(UnitSystem::inch, word) : std::string(word);
    at_ += end;
    if (!unit || !rest().starts_with(" = ")) return;
    const auto value = number_at(rest().substr(3));
    if (!value || symbol_at(rest().substr(3 + value->text.size()))) return;
    out_ += " = " + number_in(*value, *unit, "");
    at_ += 3 + value->text.size();
  }

  std::string_view text_;
  const KeyUnit* of_;
  std::string out_;
  std::size_t at_ = 0;
  bool limits_ = false;  // true after a limit without a unit: "between 3" of "between 3 and 4"
};

}  // namespace

std::string numbers_in(UnitSystem units, std::string_view text, const KeyUnit& unit) {
  std::string made;
  while (!text.empty() && units != UnitSystem::mm) {
    const auto number = number_at(text);
    const std::size_t size = number ? number->text.size() : 1;
    made +=
        number ? fmt::format("{}", unit.to_inch(number->value)) : std::string(text.substr(0, size));
    text.remove_prefix(size);
  }
  return made.append(text);
}

std::string sentence_in(UnitSystem units, std::string_view sentence, const KeyUnit* of) {
  return units == UnitSystem::mm ? std::string(sentence) : SentenceInInch(sentence, of).converted();
}

}  // namespace gearwright
