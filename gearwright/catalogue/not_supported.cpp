#include "gearwright/catalogue/key_hint.hpp"

#include <algorithm>
#include <array>
#include <cctype>

namespace gearwright {

namespace {

// In a path, `#` is any number. A path that begins with "*." matches a key of any table. A path
// that begins with "**." matches a key of any table except the spec itself.
struct Row {
  std::string_view path;
  std::string_view value;  // value of a known key; empty for an unknown key
  std::string_view sentence;
};

constexpr std::string_view kRackMate =
    "is not a table. A rack that meshes with gear 1 is described by [gear2] with form = \"rack\". "
    "A rack that cuts gear 1 is described by [gear1.rack]";
constexpr std::string_view kTwoHalves =
    "is not allowed; describe a double-helical gear by the table [gear1.double_helical], for "
    "example with gap_mm = 0. In this case helix_angle_deg is the angle of the half at z > 0";
constexpr std::string_view kModuleInInch =
    "is not a key, because modules are in mm; give normal_diametral_pitch_per_in, which is 1 "
    "divided by the normal module in inch";
constexpr std::string_view kUnits =
    "is not a key; give units = \"inch\" at the top of the spec, before the first table, to have "
    "the "
    "lengths of all tables in inch";
constexpr std::string_view kInternal =
    "is determined by the number of teeth; teeth = -61 is an internal gear with 61 teeth, and a "
    "positive number is an external gear";

constexpr std::string_view kOtherGears =
    "is not supported, because this program computes cylindrical gears and racks only, not bevel "
    "gears or worm gears. Shafts at an angle can have crossed helical gears, with helix_angle_deg "
    "in [gear1] and [gear2] and shaft_angle_deg in [pair]";
constexpr std::string_view kRoundBore =
    "is not supported, because a bore is round; the bore may have a keyway, given by "
    "keyway_width_mm and keyway_depth_mm";
constexpr std::string_view kOutputTorque =
    "is not a key; for a pair, give the torque on the driven gear by output_torque_Nm in [load] or "
    "[rating]. For a drive, give the torque on the input by torque_Nm, which is the torque on the "
    "output divided by ratio and efficiency, T_in = T_out/(i η). The command `gearwright drive` "
    "computes i and η without a torque";

constexpr std::string_view kHorsepower =
    "is not a key; give the power by power_kW, which is 0.7457 times the power in hp";

constexpr std::string_view kReading =
    "is not a key of a gear; give a reading of an unknown gear in [gear1.measured], for example "
    "span_mm = { 3 = 19.751 }, and the limits of the span of a drawing by span_mm in "
    "[gear1.tolerance]";
constexpr std::string_view kDeviation =
    "is not a key; give the deviation of the axes as an angle, by crossing_deg if the axes cross "
    "or by intersecting_deg if they are inclined in their common plane. A deviation of 0.01 mm "
    "over 100 mm is 0.00573°";

constexpr auto kRows = std::to_array<Row>({
    {"gear#", "",
     "is not allowed, because a spec of a pair has at most two gears, [gear1] and [gear2]; "
     "describe a train of more gears as a drive, with a table [[stage]] for each mesh"},
    {"bevel", "", kOtherGears},
    {"worm", "", kOtherGears},
    {"*.cone_angle_deg", "", kOtherGears},
    {"*.form", "\"bevel\"", kOtherGears},
    {"*.form", "\"worm\"", kOtherGears},
    {"gear#.bore.shape", "", kRoundBore},
    {"rack", "", kRackMate},
    {"gear1.form", "\"rack\"",
     "must not be a rack; give the rack as gear 2 and its pinion as gear 1"},
    {"gear#.teeth", "0",
     "must not be 0. A rack is [gear2] with form = \"rack\". An internal gear has a negative "
     "number of teeth, for example teeth = -61"},
    {"gear#.internal", "", kInternal},
    {"gear#.rack.points", "",
     "is not supported, because a rack cannot be given by points. Give a rack with straight flanks "
     "by addendum, dedendum and root_fillet_radius, or a chain of arcs by kind = \"arcs\""},
    {"gear#.measured.helix_deg", "",
     "is not a key; give the reading of the helix angle at the reference cylinder by "
     "helix_angle_deg"},
    {"measured", "", "is not a table of the spec; give the readings of a gear in [gear1.measured]"},
    {"compensate.aim", "\"percentile\"",
     "is not an aim of [compensate], which uses given errors. To minimise a percentile over the "
     "tolerances of [scatter], give [scatter.robust] with percentile = 95"},
    {"errors.crossing_um", "", kDeviation},
    {"errors.crossing_mm", "", kDeviation},
    {"errors.intersecting_um", "", kDeviation},
    {"errors.intersecting_mm", "", kDeviation},
    {"errors.misalignment_um", "", kDeviation},
    {"errors.misalignment_mm", "", kDeviation},
    {"errors.parallelism_um", "", kDeviation},
    {"errors.parallelism_mm", "", kDeviation},
    {"gear#.span", "", kReading},
    {"gear#.span_mm", "", kReading},
    {"*.herringbone", "", kTwoHalves},
    {"gear#.double_helical", "true", kTwoHalves},
    {"stage[#].gears[#].form", "\"rack\"",
     "is not supported in a stage, because both gears of a stage turn; describe a rack by "
     "[[drive.gear]] with form = \"rack\""},
    {"*.normal_module_in", "", kModuleInInch},
    {"*.transverse_module_in", "", kModuleInInch},
    {"*.transverse_diametral_pitch_per_in", "",
     "is not a key; give normal_diametral_pitch_per_in (the transverse diametral pitch divided by "
     "cos β) or transverse_module_mm (25.4 divided by the transverse diametral pitch)"},
    {"*.torque_output_Nm", "", kOutputTorque},
    {"pair.output_torque_Nm", "", kOutputTorque},
    {"planetary.output_torque_Nm", "", kOutputTorque},
    {"stage[#].output_torque_Nm", "", kOutputTorque},
    {"drive.output_torque_Nm", "", kOutputTorque},
    {"search.output_torque_Nm", "", kOutputTorque},
    {"*.torque_out_Nm", "", kOutputTorque},
    {"*.power_hp", "", kHorsepower},
    {"*.hp", "", kHorsepower},
    {"*.horsepower", "", kHorsepower},
    {"**.units", "", kUnits},
    {"*.unit", "", kUnits},
});

bool digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

bool matches(std::string_view pattern, std::string_view path) {
  if (pattern.starts_with("**."))
    return path.find('.') != path.npos && matches(pattern.substr(1), path);
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
