#include "gearwright/job/measures.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <numbers>

#include "gearwright/base/units.hpp"
#include "gearwright/catalogue/spelling.hpp"
#include "gearwright/gear/basic.hpp"
#include "gearwright/gear/gear_field.hpp"
#include "gearwright/job/listing.hpp"
#include "gearwright/job/result_json.hpp"
#include "gearwright/job/value_json.hpp"

namespace gearwright {

namespace {

double deg(double rad) { return Angle::radians(rad).deg(); }

// Where nobody said: the reference diameter if there is usable flank, else the flank's middle.
double default_chord_diameter(const Gear& g) {
  const double d = g.reference_diameter;
  const double end = 2 * g.tip_form_radius();
  const auto form = g.root_form_radius();
  const double begin = form           ? 2 * *form
                       : g.internal() ? g.root_diameter
                                      : g.reference().base_diameter;
  const double lo = std::min(begin, end), hi = std::max(begin, end);
  return d >= lo && d <= hi ? d : 0.5 * (lo + hi);
}

// Two names of one rack may differ by what people write down: a part in a million.
constexpr double kSameRack = 1e-6;
// Normal pressure angles of the racks that can be asked for, deg: as a gear's own.
constexpr double kMinRackAngle = 1.0, kMaxRackAngle = 60.0;

}  // namespace

Result<ChordView> chord_measure(const SolvedJob& job, int which) {
  const auto i = static_cast<std::size_t>(which - 1);
  const Gear& gear = job.gears[i];
  if (!gear.involute()) {
    return Error{gear_field(which, "measure.chord_diameter"), "",
                 "chords are measured on involute flanks; these are circular arcs"};
  }
  const double d = job.spec.gears[i]->chord_diameter.value_or(default_chord_diameter(gear));
  auto chord = chordal_thickness(gear, d);
  if (!chord) return within(gear_field(which, "measure"), chord.error());
  return ChordView{d, *chord};
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
      const Error why = spelled(measure.error(), job.spec.given);
      job.warnings.push_back({"no_chord", "No chordal thickness: " + why.message(), which});
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

Json measure_json(const MaybeChord& m) { return to_json(measure_quantities().of(m)); }

std::string measure_listing(const std::vector<MaybeChord>& measures) {
  std::vector<ValueRecord> records;
  for (const MaybeChord& m : measures) records.push_back(measure_quantities().of(m));
  return quantity_listing(measure_quantities().table(), records, gear_columns(records.size()));
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
    q.normal_pressure_angle = Angle::degrees(*angle);
    good = good && *angle >= kMinRackAngle && *angle <= kMaxRackAngle;
  }
  if (!good || (!q.normal_module && !q.normal_pressure_angle)) return std::nullopt;
  return q;
}

Result<ReferenceInput<double>> gear_as_rack(const Gear& gear, const RackQuestion& question) {
  if (!gear.involute())
    return Error{"--as-rack", "", "only involute teeth have racks of other angles"};
  const BaseGear<double> base = base_gear(gear.spec.teeth, gear.reference());
  const double m_cos = normal_base_pitch(base) / std::numbers::pi;
  const auto bad = [](const std::string& value, const std::string& why) {
    return Error{"--as-rack", value, why};
  };
  double alpha = question.normal_pressure_angle.value_or(Angle()).rad();
  if (question.normal_module) {
    const double m = *question.normal_module;
    if (!(m > m_cos)) {
      return bad(spoken(m, m_cos) + ",",
                 fmt::format("no rack of this module has the gear: m_n cos α_n is {} mm, and the "
                             "module must be greater",
                             spoken(m_cos, m)));
    }
    const double of_module = std::acos(m_cos / m);
    const double m_max = m_cos / std::cos(kMaxRackAngle * kRadPerDeg);
    if (m > m_max) {
      return bad(
          spoken(m, m_max) + ",",
          fmt::format("at this base pitch the angle would be {}°; it is at most {}°, of a "
                      "module of {} mm",
                      spoken(deg(of_module), kMaxRackAngle), kMaxRackAngle, spoken(m_max, m)));
    }
    if (!question.normal_pressure_angle) {
      alpha = of_module;
    } else if (std::abs(m * std::cos(alpha) - m_cos) > kSameRack * m_cos) {
      return bad(
          fmt::format("{:.9g},{:.9g}", m, deg(alpha)),
          fmt::format("this rack has another base pitch: at {:.9g}° the module is {:.9g} mm, "
                      "and at {:.9g} mm the angle is {:.9g}°",
                      deg(alpha), m_cos / std::cos(alpha), m, deg(of_module)));
    }
  }
  if (!has_rack(base, alpha)) {
    const double limit = 90 - std::abs(deg(base.helix_angle));
    return bad("," + spoken(deg(alpha), limit),
               fmt::format("no rack of this angle has the gear; it must be less than {}°, 90° less "
                           "the base helix angle",
                           spoken(limit, deg(alpha))));
  }
  return as_rack(base, alpha);
}

Json rack_json(const ReferenceInput<double>& rack) {
  return to_json(as_rack_quantities().of(rack));
}

std::string rack_listing(const std::vector<ReferenceInput<double>>& racks) {
  std::vector<ValueRecord> records;
  for (const auto& rack : racks) records.push_back(as_rack_quantities().of(rack));
  return quantity_listing(as_rack_quantities().table(), records, gear_columns(records.size()));
}

}  // namespace gearwright
