#include "gearwright/job/measures.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <numbers>

#include "gearwright/gear/basic.hpp"
#include "gearwright/job/result_json.hpp"

namespace gearwright {

namespace {

double deg(double rad) { return Angle::radians(rad).deg(); }

double reference_diameter(const ReferenceInput<double>& rack) {
  return rack.normal_module / std::cos(rack.helix_angle) * std::abs(rack.teeth);
}

// Where nobody said: the reference diameter if there is usable flank, else the flank's middle.
double default_chord_diameter(const Gear& g) {
  const double d = g.reference.reference_diameter;
  const double end = 2 * g.tip_form_radius();
  const auto form = g.root_form_radius();
  const double begin = form           ? 2 * *form
                       : g.internal() ? g.root_diameter
                                      : g.reference.base_diameter;
  const double lo = std::min(begin, end), hi = std::max(begin, end);
  return d >= lo && d <= hi ? d : 0.5 * (lo + hi);
}

// Two names of one rack may differ by what people write down: a part in a million.
constexpr double kSameRack = 1e-6;

}  // namespace

Result<ChordMeasure> chord_measure(const SolvedJob& job, int which) {
  const auto i = static_cast<std::size_t>(which - 1);
  const Gear& gear = job.gears[i];
  if (!gear.involute()) {
    const std::string key = fmt::format("gear{}.measure.chord_diameter_mm", which);
    return Error{key, "",
                 key + ": chords are measured on involute flanks; these are circular arcs"};
  }
  const double d = job.spec.gears[i]->chord_diameter.value_or(default_chord_diameter(gear));
  auto chord = chordal_thickness(gear, d);
  if (!chord) {
    Error e = chord.error();
    const std::string table = fmt::format("gear{}.measure.", which);
    e.key = table + e.key;
    e.message = table + e.message;
    return e;
  }
  return ChordMeasure{d, *chord};
}

Result<std::vector<MaybeChord>> chord_measures(SolvedJob& job) {
  std::vector<MaybeChord> measures;
  for (int which = 1; which <= static_cast<int>(job.gears.size()); ++which) {
    auto measure = chord_measure(job, which);
    if (measure) {
      measures.push_back(*measure);
    } else if (job.spec.gears[static_cast<std::size_t>(which - 1)]->chord_diameter) {
      return measure.error();
    } else {
      measures.push_back(std::nullopt);
      job.warnings.push_back(
          {"no_chord", "No chordal thickness: " + measure.error().message, which});
    }
  }
  return measures;
}

Json measures_json(const SolvedJob& job, const std::vector<MaybeChord>& measures) {
  Json j = job_json(job);
  for (std::size_t i = 0; i < measures.size(); ++i)
    j["gears"][i]["measure"] = measure_json(measures[i]);
  return j;
}

Json measure_json(const MaybeChord& m) {
  if (!m) return {{"chordal_thickness", nullptr}};
  return {{"chordal_thickness",
           {{"diameter_mm", m->diameter},
            {"chord_mm", m->chord.chord},
            {"height_mm", m->chord.height},
            {"tip_to_chord_mm", m->chord.tip_to_chord},
            {"caliper_angle_deg", deg(m->chord.caliper_angle)}}}};
}

std::string measure_listing(const std::vector<MaybeChord>& measures) {
  std::string text = "\nchordal tooth thickness (shortest over all inclinations of the calliper)\n";
  const auto row = [&](const char* what, const auto& value, const char* unit) {
    text += fmt::format("  {:<38}", what);
    for (const MaybeChord& m : measures) text += fmt::format("{:>14}", m ? value(*m) : "-");
    text += fmt::format("  {}\n", unit);
  };
  const auto mm = [](double v) { return fmt::format("{:.4f}", v); };
  row(
      "at the diameter", [&](const ChordMeasure& m) { return mm(m.diameter); }, "mm");
  row(
      "chord", [&](const ChordMeasure& m) { return mm(m.chord.chord); }, "mm");
  row(
      "height of the arc over the chord", [&](const ChordMeasure& m) { return mm(m.chord.height); },
      "mm");
  row(
      "calliper's depth, from the tip",
      [&](const ChordMeasure& m) { return mm(m.chord.tip_to_chord); }, "mm");
  row(
      "calliper to the transverse plane",
      [&](const ChordMeasure& m) { return fmt::format("{:.3f}", deg(m.chord.caliper_angle)); },
      "°");
  return text;
}

std::optional<RackQuestion> parse_rack_question(const std::string& text) {
  const std::size_t comma = text.find(',');
  if (comma == std::string::npos || text.find(',', comma + 1) != std::string::npos)
    return std::nullopt;
  const auto number = [](const std::string& part, bool& good) -> std::optional<double> {
    if (part.empty()) return std::nullopt;
    char* end = nullptr;
    const double v = std::strtod(part.c_str(), &end);
    good = good && part.find_first_not_of("0123456789.eE+-") == std::string::npos;  // no hex
    good = good && end == part.c_str() + part.size() && std::isfinite(v) && v > 0.0;
    return v;
  };
  bool good = true;
  RackQuestion q;
  q.normal_module = number(text.substr(0, comma), good);
  if (const auto angle = number(text.substr(comma + 1), good)) {
    q.normal_pressure_angle = Angle::degrees(*angle).rad();
    good = good && *angle >= 1.0 && *angle <= 60.0;  // as a gear's own
  }
  if (!good || (!q.normal_module && !q.normal_pressure_angle)) return std::nullopt;
  return q;
}

Result<ReferenceInput<double>> gear_as_rack(const Gear& gear, const RackQuestion& question) {
  if (!gear.involute())
    return Error{"--as-rack", "", "--as-rack: only involute teeth have racks of other angles"};
  const BaseGear<double> base = base_gear(gear.spec.teeth, gear.reference);
  const double m_cos = normal_base_pitch(base) / std::numbers::pi;
  const auto bad = [](const std::string& value, const std::string& why) {
    return Error{"--as-rack", value, fmt::format("--as-rack {}: {}", value, why)};
  };
  double alpha = question.normal_pressure_angle.value_or(0.0);
  if (question.normal_module) {
    const double m = *question.normal_module;
    if (!(m > m_cos)) {
      return bad(fmt::format("{},", m),
                 fmt::format("no rack of this module has the gear: m_n cos α_n is {} mm, and the "
                             "module must be greater",
                             m_cos));
    }
    const double of_module = std::acos(m_cos / m);
    if (!question.normal_pressure_angle) {
      alpha = of_module;
    } else if (std::abs(m * std::cos(alpha) - m_cos) > kSameRack * m_cos) {
      return bad(fmt::format("{},{}", m, deg(alpha)),
                 fmt::format("this rack has another base pitch: at {}° the module is {} mm, and at "
                             "{} mm the angle is {}°",
                             deg(alpha), m_cos / std::cos(alpha), m, deg(of_module)));
    }
  }
  if (!has_rack(base, alpha)) {
    return bad(fmt::format(",{}", deg(alpha)),
               fmt::format("no rack of this angle has the gear; it must be less than {}°, 90° less "
                           "the base helix angle",
                           90 - std::abs(deg(base.helix_angle))));
  }
  return as_rack(base, alpha);
}

Json rack_json(const ReferenceInput<double>& rack) {
  return {{"normal_module_mm", rack.normal_module},
          {"normal_pressure_angle_deg", deg(rack.normal_pressure_angle)},
          {"helix_angle_deg", deg(rack.helix_angle)},
          {"profile_shift", rack.profile_shift},
          {"reference_diameter_mm", reference_diameter(rack)}};
}

std::string rack_listing(const std::vector<ReferenceInput<double>>& racks) {
  std::string text = "\nas the rack asked for has it\n";
  const auto row = [&](const char* what, const char* symbol, const auto& value, const char* unit) {
    text += fmt::format("  {:<38}{:<7}", what, symbol);
    for (const auto& r : racks) text += fmt::format("{:>14}", value(r));
    text += std::string(*unit ? "  " : "") + unit + "\n";
  };
  using Rack = ReferenceInput<double>;
  row(
      "normal module", "m_n", [](const Rack& r) { return fmt::format("{:.6f}", r.normal_module); },
      "mm");
  row(
      "normal pressure angle", "α_n ",
      [](const Rack& r) { return fmt::format("{:.5f}", deg(r.normal_pressure_angle)); }, "°");
  row(
      "helix angle", "β ", [](const Rack& r) { return fmt::format("{:.5f}", deg(r.helix_angle)); },
      "°");
  row(
      "profile shift", "x", [](const Rack& r) { return fmt::format("{:.5f}", r.profile_shift); },
      "");
  row(
      "reference diameter", "d",
      [](const Rack& r) { return fmt::format("{:.4f}", reference_diameter(r)); }, "mm");
  return text;
}

}  // namespace gearwright
