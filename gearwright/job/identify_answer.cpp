#include "gearwright/job/identify_answer.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "gearwright/catalogue/identify_quantities.hpp"
#include "gearwright/gear/gear.hpp"
#include "gearwright/job/result_json.hpp"
#include "gearwright/spec/parse_spec.hpp"

namespace gearwright {

namespace {

// The spec with the computed data of a gear instead of its readings.
Json spec_of(const JobSpec& spec, int which, const IdentifiedGear& found) {
  Json tree = spec.tree->tables;
  Json& gear = tree[gear_field(which)];
  gear.erase("measured");
  if (found.diametral_pitch) {
    gear["normal_diametral_pitch_per_in"] = *found.diametral_pitch;
  } else {
    gear["normal_module_mm"] = found.normal_module;
  }
  gear["normal_pressure_angle_deg"] = found.normal_pressure_angle.deg();
  gear["helix_angle_deg"] = found.helix_angle.deg();
  gear["profile_shift"] = found.generating_shift;
  gear["tip_diameter_mm"] = found.tip_diameter;
  return tree;
}

// The name of a reading with its tool: "span over 3 teeth", "dimension over balls of 5 mm".
std::string tool_text(const std::string& reading, double tool) {
  if (reading == "span") return fmt::format("span over {:.0f} teeth", tool);
  if (reading == "over_balls")
    return fmt::format("dimension over balls of {} mm", format_number(tool));
  return reading == "lead" ? "lead" : "helix angle";
}

std::string unit_of(const std::string& reading) { return reading == "helix_angle" ? "°" : " mm"; }

std::string plus_minus(double value, double uncertainty, int digits) {
  return uncertainty > 0.0 ? fmt::format("{:.{}f} ± {:.{}f}", value, digits, uncertainty, digits)
                           : fmt::format("{:.{}f}", value, digits);
}

std::string module_text(const IdentifiedGear& g) {
  if (g.diametral_pitch) return fmt::format("DP {:g}", *g.diametral_pitch);
  return g.series == ModuleSeries::none ? plus_minus(g.normal_module, g.module_uncertainty, 4)
                                        : fmt::format("{:g}", g.normal_module);
}

// The facts about a candidate that the readings do not determine.
std::vector<std::string> open_facts(const IdentifyProblem& problem, const IdentifiedGear& g) {
  std::vector<std::string> facts;
  if (g.helix_angle.rad() != 0.0 && !problem.helix_angle && !problem.lead.value &&
      !problem.helix.value)
    facts.push_back("The readings do not determine the hand of the helix; right hand is assumed.");
  const double apart = g.shift_of_tip ? g.generating_shift - *g.shift_of_tip : 0.0;
  if (problem.teeth > 0 && std::abs(apart) > g.shift_uncertainty) {
    const double allowance = 2 * g.normal_module * std::tan(g.normal_pressure_angle.rad()) * apart;
    facts.push_back(
        fmt::format("If the tip is neither worn nor shortened, x = {:.4f} and the thickness "
                    "allowance is {:.3f} mm.",
                    *g.shift_of_tip, allowance));
  }
  return facts;
}

}  // namespace

Result<IdentifyAnswer> answer_identify(const JobSpec& spec) {
  const int which = spec.measured[0] || !spec.measured[1] ? 1 : 2;
  const auto& problem = spec.measured[static_cast<std::size_t>(which - 1)];
  if (!problem)
    return absent_input(
        "gear1.measured",
        "; the verb identify needs the number of teeth of the unknown gear in [gear1], and "
        "readings such as spans, dimensions over balls and diameters in [gear1.measured]");
  auto found = identify(*problem);
  if (!found) return of_gear(which, found.error());
  IdentifyAnswer answer{which, std::move(found).take(), {}, {}};
  for (const IdentifiedGear& g : answer.found.candidates) {
    answer.specs.push_back(spec_of(spec, which, g));
    answer.notes.push_back({fmt::format("Candidate {} of the readings, likelihood {:.2f} %.",
                                        answer.notes.size() + 1, 100 * g.likelihood)});
    for (std::string& fact : open_facts(*problem, g))
      answer.notes.back().push_back(std::move(fact));
  }
  return answer;
}

Json identify_json(const IdentifyAnswer& answer) {
  return {{"identify", to_json(identify_quantities().of(answer.found))}};
}

std::string identify_listing(const IdentifyAnswer& answer, UnitSystem units) {
  const Identification& found = answer.found;
  std::string text;
  if (const auto& c = found.contradiction) {
    const std::string unit = unit_of(c->reading);
    text += fmt::format(
        "\n{}The gears below agree with all other readings.\n",
        sentence_in(units, fmt::format("The {} contradicts the other readings, because it is {}{} "
                                       "instead of {}{}. ",
                                       tool_text(c->reading, c->tool), format_number(c->value),
                                       unit, format_number(c->expected, c->value), unit)));
  }
  if (!found.reason.empty()) text += "\n" + sentence_in(units, capitalised(found.reason)) + ".\n";
  if (found.candidates.empty()) return text;
  text += fmt::format("\n  {:>9}  {:>10}  {:>12}  {:>5}  {:>19}  {:>17}  {:>10}\n", "candidate",
                      "likelihood", "module", "α_n", "helix angle", "x_E", "tip");
  int number = 0;
  for (const IdentifiedGear& g : found.candidates) {
    text += fmt::format("  {:>9}  {:>8.2f} %  {:>12}  {:>4g}°  {:>18}°  {:>17}  {:>7} {}\n",
                        ++number, 100 * g.likelihood, module_text(g), g.normal_pressure_angle.deg(),
                        plus_minus(g.helix_angle.deg(), g.helix_uncertainty.deg(), 3),
                        plus_minus(g.generating_shift, g.shift_uncertainty, 4),
                        text_in(units, Unit::mm, g.tip_diameter, 3), unit_text(units, Unit::mm));
  }
  for (std::size_t i = 1; i < answer.notes.front().size(); ++i)
    text += (i == 1 ? "\n" : "") + sentence_in(units, answer.notes.front()[i]) + "\n";
  if (const auto& n = found.next) {
    const std::string unit = unit_of(n->reading);
    text += sentence_in(units, fmt::format("\nTo decide between candidates 1 and {}, measure the "
                                           "{}, which is {:.3f}{} or {:.3f}{}.\n",
                                           n->rival + 1, tool_text(n->reading, n->tool),
                                           n->expect[0], unit, n->expect[1], unit));
  }
  return text + "\nThe option --take NUMBER > gear.toml writes the spec of a candidate.\n";
}

}  // namespace gearwright
