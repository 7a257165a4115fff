#include "gearwright/catalogue/not_supported.hpp"

#include <algorithm>
#include <array>
#include <cctype>

namespace gearwright {

namespace {

// `#` in a path is any number. A path that begins with "*." is a key of any table.
struct Row {
  std::string_view path;
  std::string_view value;  // value of a known key; empty for an unknown key
  std::string_view sentence;
};

constexpr std::string_view kRackMate =
    "a rack as a mating part is gear 2: [gear2] with form = \"rack\". The rack that cuts a gear is "
    "[gear1.rack]";
constexpr std::string_view kTwoHalves =
    "double-helical gears have the table [gear1.double_helical], for example with gap_mm = 0; "
    "helix_angle_deg is the angle of the half at z > 0";
constexpr std::string_view kUnits =
    "units cannot be chosen. Lengths are in mm and angles in degrees, as the end of each key "
    "shows. An inch is 25.4 mm. Instead of the module, you can give normal_diametral_pitch_per_in";
constexpr std::string_view kInternal =
    "is determined by the number of teeth: teeth = -61 is an internal gear with 61 teeth, and a "
    "positive number is an external gear";

constexpr auto kRows = std::to_array<Row>({
    {"gear#", "",
     "a spec has at most two gears, [gear1] and [gear2]; write a separate spec for each mesh"},
    {"rack", "", kRackMate},
    {"gear1.form", "\"rack\"", "the rack must be gear 2 and its pinion gear 1"},
    {"gear#.teeth", "0",
     "must not be 0. A rack is [gear2] with form = \"rack\". An internal gear has a negative "
     "number of teeth, for example teeth = -61"},
    {"gear#.internal", "", kInternal},
    {"gear#.rack.points", "",
     "a rack given by points is not supported. Give a rack with straight flanks by addendum, "
     "dedendum and root_fillet_radius, or a chain of arcs and lines by kind = \"arcs\""},
    {"gear#.measured.helix_deg", "",
     "the key for the reading of the helix angle is helix_angle_deg, at the reference cylinder"},
    {"measured", "", "readings are given for a gear, in [gear1.measured]"},
    {"compensate.aim", "\"percentile\"",
     "is the aim of [scatter.robust], which minimises a percentile over the tolerances of "
     "[scatter]: "
     "percentile = 95 there; [compensate] works for given errors"},
    {"scatter.correlations", "",
     "correlated inputs are not supported, except bores, by [scatter.bearings]"},
    {"*.herringbone", "", kTwoHalves},
    {"gear#.double_helical", "true", kTwoHalves},
    {"stage[#].gears[#].form", "\"rack\"",
     "a rack is a gear of [drive]: [[drive.gear]] with form = \"rack\". Both gears of a stage "
     "turn"},
    {"*.units", "", kUnits},
    {"*.unit", "", kUnits},
});

bool digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

bool matches(std::string_view pattern, std::string_view path) {
  if (pattern.starts_with("*."))
    return path.substr(path.rfind('.') + 1) ==
           pattern.substr(2);  // npos + 1 is 0, the beginning of the path
  while (!pattern.empty() && !path.empty()) {
    if (pattern.front() == '#') {
      if (!digit(path.front())) return false;
      while (!path.empty() && digit(path.front())) path.remove_prefix(1);
    } else {
      if (pattern.front() != path.front()) return false;
      path.remove_prefix(1);
    }
    pattern.remove_prefix(1);
  }
  return pattern.empty() && path.empty();
}

}  // namespace

std::string_view not_supported(std::string_view path, std::string_view value) {
  const auto row = std::find_if(kRows.begin(), kRows.end(), [&](const Row& r) {
    return r.value == value && matches(r.path, path);
  });
  return row == kRows.end() ? std::string_view() : row->sentence;
}

}  // namespace gearwright
