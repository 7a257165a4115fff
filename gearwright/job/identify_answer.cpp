#include "gearwright/job/fit_answer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "gearwright/base/number_text.hpp"
#include "gearwright/base/printable.hpp"
#include "gearwright/base/units.hpp"
#include "gearwright/catalogue/fit_quantities.hpp"
#include "gearwright/gear/gear.hpp"
#include "gearwright/job/listing.hpp"
#include "gearwright/job/result_json.hpp"
#include "gearwright/spec/parse_spec.hpp"

namespace gearwright {

namespace {

// True if another key of the spec determines the thickness of the teeth. A thickness allowance
// would contradict this key.
bool gives_thickness(const Json& tree, const Json& gear) {
  const auto has = [](const Json& table, std::initializer_list<const char*> keys) {
    return std::any_of(keys.begin(), keys.end(),
                       [&](const char* key) { return table.contains(key); });
  };
  const Json pair = tree.value("pair", Json::object());
  const Json tolerance = gear.value("tolerance", Json::object());
  return has(pair, {"backlash_mm", "backlash_circumferential_mm", "backlash_deg"}) ||
         has(tolerance, {"thickness_series", "span_mm", "over_balls_mm"});
}

// Rounds a computed value to six decimals, because readings are less accurate.
double six_decimals(double value) { return std::round(1e6 * value) / 1e6; }

double six_decimals(UnitSystem units, double mm) {
  if (units == UnitSystem::mm) return six_decimals(mm);
  const KeyUnit& inch = *metric_unit("tip_diameter_mm");
  return inch.to_metric(six_decimals(inch.to_inch(mm)));
}

// Returns the spec with the computed data of a gear in place of its readings. Other keys are kept.
Json spec_of(const JobSpec& spec, int which, const IdentifiedGear& found) {
  Json tree = spec.tree->tables;
  Json& gear = tree[gear_field(which)];
  gear.erase("measured");
  if (found.diametral_pitch) {
    gear["normal_diametral_pitch_per_in"] = *found.diametral_pitch;
  } else {
    gear["normal_module_mm"] = six_decimals(found.normal_module);
  }
  gear["normal_pressure_angle_deg"] = found.normal_pressure_angle.deg();
  gear["helix_angle_deg"] = six_decimals(found.helix_angle.deg());
  gear["profile_shift"] = six_decimals(found.profile_shift);
  const double allowance = six_decimals(spec.units(), found.thickness_allowance);
  if (allowance != 0.0 && !gear.contains("thickness_allowance_mm") && !gives_thickness(tree, gear))
    gear["thickness_allowance_mm"] = allowance;
  // ISO53-A is the default rack, so the spec needs no key for it.
  if (!found.rack.empty() && found.rack != "ISO53-A") gear["rack"] = found.rack;
  if (!gear.contains("tip_diameter_mm"))
    gear["tip_diameter_mm"] = six_decimals(spec.units(), found.tip_diameter);
  return tree;
}

// Returns the name of a reading with its tool, for example "span over 3 teeth" or "dimension over
// balls of 5 mm".
std::string tool_text(Reading reading, double tool) {
  switch (reading) {
    case Reading::span: return fmt::format("span over {:.0f} teeth", tool);
    case Reading::over_balls:
      return fmt::format("dimension over balls of {} mm", format_number(tool));
    case Reading::lead: return "lead";
    case Reading::tip_diameter: return "tip diameter";
    case Reading::root_diameter: return "root diameter";
    default: return "helix angle";
  }
}

const char* reading_unit(Reading reading) { return reading == Reading::helix_angle ? "°" : " mm"; }

// Returns the beginning of a sentence about readings that seem to have the wrong unit, inch instead
// of mm or mm instead of inch.
const char* group_text(Reading mistake) {
  switch (mistake) {
    case Reading::all: return "all lengths are";
    case Reading::span: return "the spans are";
    case Reading::over_balls: return "the dimensions over balls are";
    case Reading::center_distance: return "the centre distance is";
    case Reading::root_diameter: return "the root diameter is";
    default: return "the tip diameter is";
  }
}

std::string plus_minus(double value, double uncertainty, int digits) {
  return uncertainty > 0.0 ? fmt::format("{:.{}f} ± {:.{}f}", value, digits, uncertainty, digits)
                           : fmt::format("{:.{}f}", value, digits);
}

std::string module_text(const IdentifiedGear& g) {
  if (g.diametral_pitch) return fmt::format("DP {:g}", *g.diametral_pitch);
  return g.series == ModuleSeries::none ? plus_minus(g.normal_module, g.module_uncertainty, 4)
                                        : fmt::format("{:g}", g.normal_module);
}

// Returns the sentence about a measured tip diameter that differs from the nominal one. The text is
// empty if both agree, or if there is no measured value.
std::string tip_fact(const IdentifiedGear& g, double measured) {
  const std::string nominal = fmt::format("{:.3f} mm", g.nominal_tip_diameter);
  switch (g.tip) {
    case TipReading::none:
    case TipReading::as_drawn: return "";
    case TipReading::worn: {
      const std::string fact = fmt::format(
          "The tip diameter is {:.3f} mm instead of {}, so the tip ", measured, nominal);
      // Over an odd number of teeth, a tip and the middle between two tips are opposite each other.
      const double most = g.nominal_tip_diameter / 2 * (1 - std::cos(std::numbers::pi / g.teeth));
      if (g.teeth < 0 || g.teeth % 2 == 0 || g.nominal_tip_diameter - measured > most)
        return fact + "is worn.";
      return fact + fmt::format(
                        "is worn, or the reading is a dimension over the tips. For this odd number "
                        "of teeth, a calliper over the tips reads up to {:.3f} mm less than the "
                        "tip diameter; twice the distance from the bore axis to a tip is exact.",
                        most);
    }
    case TipReading::shortened:
      return fmt::format(
          "The tip diameter is {:.3f} mm instead of {}, so the tip is shortened or badly worn; the "
          "spec has the measured tip diameter.",
          measured, nominal);
    case TipReading::longer:
      return fmt::format(
          "The tip diameter is {:.3f} mm, greater than the {} that the rack gives; the spec has "
          "the measured tip diameter.",
          measured, nominal);
  }
  return "";
}

// Returns sentences about a candidate. They describe an implausible profile shift, data that the
// readings do not determine, a basic rack other than the default, and a tip diameter that differs
// from the nominal one. `spec` is the table of the gear in the spec of this candidate.
std::vector<std::string> open_facts(const IdentifyProblem& problem, const IdentifiedGear& g,
                                    const Json& spec) {
  std::vector<std::string> facts;
  if (!g.plausible())
    facts.push_back(
        fmt::format("The profile shift x_E = {:.4f} is implausible; check the number of "
                    "teeth, the readings and their units.",
                    g.generating_shift));
  if (g.helix_angle.rad() != 0.0 && !problem.helix_angle && !problem.lead.value &&
      !problem.helix.value)
    facts.push_back("The readings do not determine the hand of the helix; right hand is assumed.");
  if (g.thickness_allowance != 0.0 && !spec.contains("thickness_allowance_mm")) {
    facts.push_back(fmt::format(
        "The spec has x = {:.4f}. The readings give a thickness allowance of {:.4f} mm. The spec "
        "does not contain this allowance, because the backlash or tolerance in the spec determines "
        "it.",
        g.profile_shift, g.thickness_allowance));
  } else if (g.thickness_allowance != 0.0) {
    const char* const why =
        problem.profile_shift || problem.thickness_allowance ? "as the spec gives"
        : g.shift_of_tip && g.tip == TipReading::as_drawn    ? "because the tip agrees with this x"
        : problem.tip.value ? "because such an allowance is more usual than this x_E"
                            : "because such an allowance is more usual than this x_E; a measured "
                              "tip diameter would confirm this";
    facts.push_back(
        fmt::format("The spec describes x_E = {:.4f} by x = {:.4f} and the thickness allowance "
                    "{:.4f} mm, {}.",
                    g.generating_shift, g.profile_shift, g.thickness_allowance, why));
  }
  if (!g.rack.empty() && g.rack != "ISO53-A")
    facts.push_back(fmt::format("The basic rack is {}.", g.rack));
  if (problem.tip.value) {
    std::string fact = tip_fact(g, *problem.tip.value);
    if (!fact.empty()) facts.push_back(std::move(fact));
  }
  return facts;
}

// Returns the sentence about a mating gear whose profile shift is not measured. The text is empty if
// the spec determines the profile shift or has no mating gear.
std::string mate_fact(const Json& tree, int which) {
  const std::string name = gear_field(3 - which);
  if (!tree.contains(name) || !tree[name].contains("teeth") ||
      !tree.value("pair", Json::object()).contains("center_distance_mm"))
    return "";
  for (const char* key : {"profile_shift", "measured", "cut_by", "form"})
    if (tree[name].contains(key)) return "";
  return fmt::format(
      "The profile shift of gear {0} is not measured; the program computes it from the centre "
      "distance. If this gear exists, measure its spans and give them in [{1}.measured].",
      3 - which, name);
}

std::vector<Warning> unused_readings(const JobSpec& spec) {
  if (!spec.measured[0] || !spec.measured[1]) return {};
  return {
      {WarningCode::not_read,
       "gear2.measured was not used, because this verb identifies one gear at a time, and these "
       "candidates are for gear 1. To identify gear 2 with candidate 1 as gear 1, use the command "
       "`gearwright identify SPEC --take 1 | gearwright identify -`",
       2}};
}

std::string alternative_text(const Identification& found, UnitSystem units) {
  const Alternative& a = *found.alternative;
  const IdentifiedGear& g = a.gear;
  const std::string gear =
      fmt::format("{} {}, α_n = {:g}°, β = {:g}° and x = {:.4f}",
                  g.diametral_pitch ? "with" : "with the module", module_text(g),
                  g.normal_pressure_angle.deg(), g.helix_angle.deg(), g.profile_shift);
  if (a.mistake == Reading::teeth)
    return fmt::format(
        "Count the teeth again, because all readings agree with a gear of {} teeth {}.", g.teeth,
        gear);
  if (a.mistake == Reading::span_teeth)
    return fmt::format(
        "Count the teeth in the spans again. With one tooth {} in each span, all readings agree "
        "with a gear of {} teeth {}.{}",
        a.step > 0 ? "more" : "fewer", g.teeth, gear,
        found.candidates.empty() || g.tip != TipReading::none
            ? ""
            : sentence_in(units,
                          fmt::format(" Measure the tip diameter, which is about {:.3f} mm "
                                      "for this gear and {:.3f} mm for candidate 1.",
                                      g.tip_diameter, found.candidates.front().tip_diameter)));
  const char* const other = units == UnitSystem::inch ? "mm" : "inch";
  return fmt::format("Check the units. If {} in {}, all readings agree with a gear of {} teeth {}.",
                     group_text(a.mistake), other, g.teeth, gear);
}

// Returns the sentence about the measurement that decides between the candidates.
std::string next_text(const NextMeasurement& n) {
  const char* const unit = reading_unit(n.reading);
  const auto expected = [&](std::size_t i) {
    return fmt::format("{:.3f}{} ± {:.3f}{}", n.expect[i], unit, n.spread[i], unit);
  };
  std::vector<std::string> others;
  for (const int i : n.separates)
    if (i != n.rival) others.push_back(std::to_string(i + 1));
  return fmt::format(
      "\nTo decide between candidates 1 and {}, measure the {}, which is {} or {}.{}\n",
      n.rival + 1, tool_text(n.reading, n.tool), expected(0), expected(1),
      others.empty() ? ""
                     : fmt::format(" This measurement also distinguishes candidate "
                                   "1 from candidate{} {}.",
                                   others.size() > 1 ? "s" : "", enumerated(others)));
}

// True if the candidates differ only in a fitted helix angle whose range contains that of the other
// candidate.
bool same_within_range(const IdentifiedGear& a, const IdentifiedGear& b) {
  return a.normal_module == b.normal_module &&
         a.normal_pressure_angle.rad() == b.normal_pressure_angle.rad() &&
         std::abs(a.helix_angle.rad() - b.helix_angle.rad()) <=
             a.helix_uncertainty.rad() + b.helix_uncertainty.rad();
}

// Returns the sentence about two likely candidates that no usual measurement distinguishes. The
// text is empty if there is only one likely candidate, or if a further measurement distinguishes
// the candidates.
std::string undecided_text(const Identification& found) {
  // kLikely is the least likelihood of a likely candidate. kClear, in degrees, is the least
  // difference of two helix angles that a measurement can distinguish.
  constexpr double kLikely = 0.01, kClear = 0.1;
  if (found.next || found.candidates.empty()) return "";
  const IdentifiedGear& first = found.candidates.front();
  const auto rival =
      std::find_if(found.candidates.begin() + 1, found.candidates.end(),
                   [&](const IdentifiedGear& g) { return !same_within_range(first, g); });
  if (rival == found.candidates.end() || rival->likelihood < kLikely) return "";
  const double one = first.helix_angle.deg(), other = rival->helix_angle.deg();
  return fmt::format(
      "\nNo further span and no dimension over balls distinguishes candidates 1 and {}{}.\n",
      rival - found.candidates.begin() + 1,
      std::abs(one - other) < kClear ? ""
                                     : fmt::format("; measure the helix angle at the reference "
                                                   "cylinder ({:.3f}° or {:.3f}°) more accurately",
                                                   one, other));
}

}  // namespace

Result<IdentifyAnswer> answer_identify(const JobSpec& spec) {
  const int which = spec.measured[0] || !spec.measured[1] ? 1 : 2;
  const auto& problem = spec.measured[which - 1];
  if (!problem)
    return absent_input("gear1.measured",
                        "; the command `gearwright identify` needs the number of teeth of the "
                        "unknown gear in [gear1], and readings such as spans, dimensions over "
                        "balls and diameters in [gear1.measured]");
  IdentifyProblem in_unit = *problem;
  if (spec.units() == UnitSystem::inch) in_unit.other_unit = 1 / kMmPerInch;
  auto found = identify(in_unit);
  if (!found) return of_gear(which, found.error());
  IdentifyAnswer answer{{std::move(found).take()}, {}, {}, unused_readings(spec)};
  for (const IdentifiedGear& g : answer.found.candidates) {
    answer.specs.push_back(spec_of(spec, which, g));
    answer.candidates.push_back({g, to_value(answer.specs.back())});
    answer.notes.push_back({fmt::format("Candidate {} of the readings, likelihood {:.2f} %.",
                                        answer.notes.size() + 1, 100 * g.likelihood)});
    for (std::string& fact : open_facts(*problem, g, answer.specs.back()[gear_field(which)]))
      answer.notes.back().push_back(std::move(fact));
    if (std::string fact = mate_fact(answer.specs.back(), which); !fact.empty())
      answer.notes.back().push_back(std::move(fact));
  }
  return answer;
}

Json identify_json(const IdentifyAnswer& answer) {
  return {{"identify", to_json(identify_quantities().of(answer))}};
}

std::string identify_listing(const IdentifyAnswer& answer, UnitSystem units) {
  const Identification& found = answer.found;
  std::string text;
  if (const auto& c = found.contradiction) {
    const char* const unit = reading_unit(c->reading);
    const std::string expected =
        c->expected ? format_number(*c->expected, c->value) + unit : "infinite, as for a spur gear";
    text += fmt::format(
        "\n{}The gears below agree with all other readings.\n",
        sentence_in(units, fmt::format("The {} contradicts the other readings, because it is {}{} "
                                       "instead of {}. ",
                                       tool_text(c->reading, c->tool), format_number(c->value),
                                       unit, expected)));
  }
  if (!found.reason.empty()) text += "\n" + sentence_in(units, capitalised(found.reason)) + ".\n";
  if (found.alternative) text += "\n" + alternative_text(found, units) + "\n";
  if (found.candidates.empty()) return text;
  TextTable table{
      "", {"candidate", "likelihood", "module", "α_n", "helix angle", "x_E", "tip", "usual tip"}};
  const std::string length(unit_text(units, Unit::mm));
  table.units = {"", "%", "", "°", "°", "", length, length};
  for (const IdentifiedGear& g : found.candidates)
    table.rows.push_back(
        {"",
         "",
         {std::to_string(table.rows.size() + 1), fixed_decimals(100 * g.likelihood, 2),
          module_text(g), fmt::format("{:g}", g.normal_pressure_angle.deg()),
          plus_minus(g.helix_angle.deg(), g.helix_uncertainty.deg(), 3),
          plus_minus(g.generating_shift, g.shift_uncertainty, 4),
          text_in(units, Unit::mm, g.tip_diameter, 3),
          text_in(units, Unit::mm, g.nominal_tip_diameter, 3)}});
  text += "\n" + table_listing(table);
  for (std::size_t i = 1; i < answer.notes.front().size(); ++i)
    text += (i == 1 ? "\n" : "") + sentence_in(units, answer.notes.front()[i]) + "\n";
  if (found.next) text += sentence_in(units, next_text(*found.next));
  text += undecided_text(found);
  return text + "\nThe option --take NUMBER > gear.toml writes the spec of a candidate.\n";
}

}  // namespace gearwright
