// The numbers of a REXS file that are read, with their units, and their check. The file also finds
// the components that can affect a spec.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <map>
#include <set>
#include <vector>

#include "gearwright/base/lists.hpp"
#include "gearwright/base/number_text.hpp"
#include "gearwright/base/printable.hpp"
#include "gearwright/spec/rexs_set.hpp"

namespace gearwright {

namespace {

constexpr std::size_t kLongValue = 60;  // longest part of a value in a sentence, in bytes
constexpr double kMostTeeth = 100'000;  // greatest number of teeth of a spec

struct RexsNumber {
  std::array<std::string_view, 2> types;
  std::string_view attribute, unit;
};

using Types = std::array<std::string_view, 2>;
constexpr Types kGears{"cylindrical_gear", "ring_gear"};
constexpr Types kFlanks{"cylindrical_gear_flank", "flank_geometry"};
constexpr Types kTools{"rack_shaped_tool", "cutter_wheel_tool"};
constexpr std::string_view kTeeth = "number_of_teeth";

// Every attribute that is read as a number. The units are those of the public REXS database.
constexpr std::array kRows{
    RexsNumber{kGears, kTeeth, "none"},
    RexsNumber{kGears, "normal_module", "mm"},
    RexsNumber{kGears, "helix_angle_reference_diameter", "deg"},
    RexsNumber{kGears, "face_width", "mm"},
    RexsNumber{kGears, "tip_diameter", "mm"},
    RexsNumber{kFlanks, "normal_pressure_angle", "deg"},
    RexsNumber{kFlanks, "addendum_modification_coefficient", "none"},
    RexsNumber{kFlanks, "generated_addendum_modification_coefficient", "none"},
    RexsNumber{kTools, kTeeth, "none"},
    RexsNumber{kTools, "addendum_coefficient_reference_profile", "none"},
    RexsNumber{kTools, "tip_radius_factor", "none"},
    RexsNumber{kTools, "tip_corner_radius_factor_reference_profile", "none"},
    RexsNumber{{"cylindrical_stage"}, "center_distance", "mm"},
    RexsNumber{{"shaft"}, "rotational_speed", "1 / min"},
    RexsNumber{{"external_load"}, "torque_around_u_axis", "N m"}};

const RexsNumber* row_of(std::string_view type, std::string_view attribute) {
  const auto it = std::find_if(kRows.begin(), kRows.end(), [&](const RexsNumber& row) {
    return row.attribute == attribute && is_in(type, row.types);
  });
  return it == kRows.end() ? nullptr : &*it;
}

// True if the texts name the same unit. Spaces are ignored, and an empty text is the unit of the
// attribute. Versions 1.0 to 1.3 write the degree as a sign, in UTF-8 or in ISO 8859-1.
bool same_unit(std::string unit, std::string expected) {
  std::erase(unit, ' ');
  std::erase(expected, ' ');
  return unit.empty() || unit == expected || (expected == "deg" && (unit == "°" || unit == "\xB0"));
}

}  // namespace

std::optional<double> RexsComponent::number(std::string_view attribute) const {
  const auto it = attributes.find(attribute);
  if (it == attributes.end()) return std::nullopt;
  const auto value = decimal_number(it->second);
  return value == 0.0 ? 0.0 : value;  // gives 0 instead of −0
}

bool is_rexs_number(const RexsComponent& component, std::string_view attribute) {
  return row_of(component.type, attribute) != nullptr;
}

std::optional<Error> rexs_number_error(const RexsComponent& c) {
  for (const auto& [attribute, text] : c.attributes) {
    const RexsNumber* const row = row_of(c.type, attribute);
    if (!row) continue;
    const auto wrong = [&](std::string_view shown, const std::string& rule) {
      return Error{"", "",
                   fmt::format("component {} has `{}` = \"{}\"{}", rexs_name(c), row->attribute,
                               printable(std::string(shown), kLongValue), rule)};
    };
    const auto value = c.number(attribute);
    if (!value)
      return wrong(text,
                   ", which is not a number; write a number with a decimal point and without a "
                   "unit, such as 12.5");
    if (row->attribute == kTeeth && (*value != std::round(*value) || std::abs(*value) > kMostTeeth))
      return wrong(
          text, fmt::format("; the number of teeth must be whole and at most {:.0f}", kMostTeeth));
    if (const auto unit = c.units.find(attribute);
        unit != c.units.end() && !same_unit(unit->second, std::string(row->unit)))
      return wrong(text, fmt::format(" with the unit \"{}\"; convert the value to the unit "
                                     "\"{}\", which REXS specifies for this attribute",
                                     printable(unit->second, kLongValue), row->unit));
  }
  return std::nullopt;
}

std::set<std::string, std::less<>> rexs_parts_of_stages(const RexsModel& model) {
  std::set<std::string, std::less<>> units, parts;
  std::vector<std::string> next;
  for (const RexsComponent& c : model.components) {
    if (c.type == "gear_unit") units.insert(c.id);
    if (c.type == "cylindrical_stage") next.push_back(c.id);
  }
  std::multimap<std::string, const RexsRelation*> relations_of;
  for (const RexsRelation& r : model.relations)
    for (const auto& ref : r.refs)
      if (!units.contains(ref.second)) relations_of.emplace(ref.second, &r);
  std::set<const RexsRelation*> followed;
  while (!next.empty()) {
    const std::string id = std::move(next.back());
    next.pop_back();
    if (!parts.insert(id).second) continue;
    const auto [begin, end] = relations_of.equal_range(id);
    for (auto it = begin; it != end; ++it) {
      if (!followed.insert(it->second).second) continue;
      for (const auto& ref : it->second->refs)
        if (!units.contains(ref.second)) next.push_back(ref.second);
    }
  }
  return parts;
}

}  // namespace gearwright
