#include "gearwright/catalogue/unit_system.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

#include "gearwright/base/lists.hpp"
#include "gearwright/base/number_text.hpp"

namespace gearwright {

namespace {

constexpr long double kMm = 25.4L, kUm = 0.0254L;

// A unit that the inch system replaces. Some units occur only in keys.
struct UnitPair {
  KeyUnit key;
  Unit metric = Unit::none, inch = Unit::none;
};

// The first row with a matching ending is used, so longer endings come before shorter ones. Keys of
// masses end in "_kg" in both systems, so the last row has no ending.
constexpr std::array kUnitPairs{
    UnitPair{{"_mm_per_rad", "_in_per_rad", kMm, false}, Unit::mm_per_rad, Unit::inch_per_rad},
    UnitPair{{"_mm_per_turn", "_in_per_turn", kMm, false}},
    UnitPair{{"_per_mm", "_per_in", kMm, true}, Unit::per_mm, Unit::per_inch},
    UnitPair{{"_per_um", "_per_uin", kUm, true}},
    UnitPair{{"_mm", "_in", kMm, false}, Unit::mm, Unit::inch},
    UnitPair{{"_um", "_uin", kUm, false}, Unit::um, Unit::microinch},
    UnitPair{{"", "", 0.45359237L, false}, Unit::kg, Unit::pound}};

// Keys that have the same name in both systems, although the rule for endings would give them
// another name in the other system. The list also contains these other names.
constexpr std::array<std::string_view, 12> kInBoth{"module_mm",
                                                   "module_in",
                                                   "normal_module_mm",
                                                   "normal_module_in",
                                                   "transverse_module_mm",
                                                   "transverse_module_in",
                                                   "modules_mm",
                                                   "modules_in",
                                                   "normal_diametral_pitch_per_in",
                                                   "normal_diametral_pitch_per_mm",
                                                   "diametral_pitches_per_in",
                                                   "diametral_pitches_per_mm"};

// Keys whose numbers do not have the unit of the enclosing key. In the table of a toleranced
// length, for example { range = [-1, 1], cpk = 1.33 }, `cpk` and `shape` are pure numbers. The
// members of `samples` have their own units.
constexpr std::array<std::string_view, 3> kPureNumbers{"cpk", "shape", "samples"};

// Returns the unit at the end of one key, without its index.
const KeyUnit* unit_at_end(std::string_view key, std::string_view KeyUnit::*ending) {
  const bool force = key.find("_N_") != std::string_view::npos || key.ends_with("_per_N");
  if (force || is_in(key, kInBoth)) return nullptr;
  for (const UnitPair& pair : kUnitPairs)
    if (const std::string_view end = pair.key.*ending; !end.empty() && key.ends_with(end))
      return &pair.key;
  return nullptr;
}

std::string_view without_index(std::string_view key) { return key.substr(0, key.find('[')); }

const KeyUnit* unit_with(std::string_view path, std::string_view KeyUnit::*ending) {
  for (;;) {
    const std::size_t dot = path.rfind('.');
    const std::string_view key = without_index(path.substr(dot + 1));  // npos + 1 is 0
    const KeyUnit* const unit = unit_at_end(key, ending);
    if (unit || dot == std::string_view::npos || !is_in_unit_of_table(key)) return unit;
    path = path.substr(0, dot);
  }
}

// Returns the path with every ending `from` replaced by the ending `to` of the same unit.
std::string renamed(std::string_view path, std::string_view KeyUnit::*from,
                    std::string_view KeyUnit::*to) {
  std::string made;
  for (;;) {
    const std::string_view part = path.substr(0, path.find('.'));
    const std::string_view key = without_index(part);
    const KeyUnit* const unit = unit_at_end(key, from);
    made += unit ? key.substr(0, key.size() - (unit->*from).size()) : key;
    if (unit) made += unit->*to;
    made += part.substr(key.size());
    if (part.size() == path.size()) return made;
    made += '.';
    path.remove_prefix(part.size() + 1);
  }
}

double rounded(double x, int digits) {
  return std::strtod(fmt::format("{:.{}e}", x, digits - 1).c_str(), nullptr);
}

constexpr int kSafeDigits = 15;  // every decimal of 15 digits survives a conversion to double

const UnitPair* pair_of(UnitSystem units, Unit unit) {
  if (units == UnitSystem::mm || unit == Unit::none) return nullptr;
  const auto it = std::find_if(kUnitPairs.begin(), kUnitPairs.end(),
                               [&](const UnitPair& p) { return p.metric == unit; });
  return it == kUnitPairs.end() ? nullptr : &*it;
}

}  // namespace

std::string_view to_string(UnitSystem units) { return units == UnitSystem::mm ? "mm" : "inch"; }

std::vector<Unit> units_to_convert() {
  std::vector<Unit> units;
  for (const UnitPair& pair : kUnitPairs)
    if (pair.metric != Unit::none) units.push_back(pair.metric);
  return units;
}

Unit unit_in(UnitSystem units, Unit unit) {
  const UnitPair* pair = pair_of(units, unit);
  return pair ? pair->inch : unit;
}

double value_in(UnitSystem units, Unit unit, double value) {
  const UnitPair* pair = pair_of(units, unit);
  return pair ? pair->key.to_inch(value) : value;
}

int digits_in(UnitSystem units, Unit unit, int digits) {
  const UnitPair* pair = pair_of(units, unit);
  if (!pair || unit == Unit::kg) return digits;
  // True if the inch unit is larger than the metric unit, as 1 in is larger than 1 mm.
  const bool larger = (pair->key.size > 1) != pair->key.inverse;
  return std::max(0, digits + (larger ? 1 : -1));
}

std::string text_in(UnitSystem units, Unit unit, double value, int decimals) {
  return fixed_decimals(value_in(units, unit, value), digits_in(units, unit, decimals));
}

std::string_view unit_text(UnitSystem units, Unit unit) { return unit_text(unit_in(units, unit)); }

double KeyUnit::to_metric(double inch_value) const {
  const auto there = [&](double y) { return static_cast<double>(inverse ? y / size : y * size); };
  const double exact = there(inch_value);
  const double shorter = rounded(exact, kSafeDigits);
  // The inch value may come from a short number in mm, divided by 25.4 in double. The quotient then
  // has one rounding error, and this function returns the short number.
  const auto back = static_cast<double>(inverse ? shorter * size : shorter / size);
  return std::nextafter(back, inch_value) == inch_value ? shorter : exact;
}

double KeyUnit::to_inch(double metric_value) const {
  const auto exact = static_cast<double>(inverse ? metric_value * size : metric_value / size);
  if (!std::isfinite(exact)) return exact;
  for (int digits = kSafeDigits; digits < kSafeDigits + 2; ++digits)
    if (const double shorter = rounded(exact, digits); to_metric(shorter) == metric_value)
      return shorter;
  return exact;
}

const KeyUnit* metric_unit(std::string_view key) { return unit_with(key, &KeyUnit::metric); }
const KeyUnit* inch_unit(std::string_view key) { return unit_with(key, &KeyUnit::inch); }

bool is_in_unit_of_table(std::string_view key) {
  return unit_of(key) == Unit::none && !is_in(key, kPureNumbers);
}

std::string key_in(UnitSystem units, std::string_view key) {
  return units == UnitSystem::mm ? std::string(key)
                                 : renamed(key, &KeyUnit::metric, &KeyUnit::inch);
}

std::string metric_key(std::string_view key) {
  return renamed(key, &KeyUnit::inch, &KeyUnit::metric);
}

}  // namespace gearwright
