#include "gearwright/job/measures.hpp"

#include <nlohmann/json.hpp>

#include "gearwright/catalogue/spelling.hpp"
#include "gearwright/gear/gear.hpp"
#include "gearwright/inspection/balls.hpp"
#include "gearwright/job/listing.hpp"
#include "gearwright/job/result_json.hpp"

namespace gearwright {

namespace {

// Returns the pair if the gears can be mounted. Gears can be measured without a pair.
std::optional<Pair> mounted(const SolvedJob& job) {
  if (job.pair || job.gears.size() < 2) return job.pair;
  const auto arranged = arrange(job.completed, Scope::pair);
  return arranged ? arranged->pair : std::nullopt;
}

Result<GearMeasures> measured(const SolvedJob& job, const Arranged& arranged, int which,
                              const MeasureInput& tools, const std::optional<Pair>& pair,
                              std::vector<Warning>& warnings) {
  const auto& mounting = job.spec.rating.input.mounting;
  MeasureRequest request{.which = which, .tools = tools, .pair = pair ? &*pair : nullptr};
  request.bearing_span = job.spec.pair.bearing_span;
  if (!request.bearing_span && mounting) request.bearing_span = mounting->bearing_span;
  request.words = [&](const Error& e) { return spelled(e, job.spec.given).message(); };
  return measure(arranged, request, warnings);
}

// Returns the tools of a gear. If the spec gives no ball diameter, balls with the diameter of the
// given pins are used. If the spec gives no pins either, the balls have the diameter of
// pin_of_diametral_pitch(). Such balls are used only if they touch the usable flanks.
MeasureInput tools_of(const SolvedJob& job, int which) {
  MeasureInput tools = job.spec.gear(which).measure;
  if (tools.ball_diameter) return tools;
  const Gear& gear = job.gear(which);
  const auto size = tools.pin_diameter ? tools.pin_diameter
                                       : pin_of_diametral_pitch(job.spec, which, gear.internal(),
                                                                gear.spec.normal_module);
  if (!size) return tools;
  const auto seat = ball_in_space(gear, *size);
  if (seat && seat->usable()) tools.ball_diameter = size;
  return tools;
}

Result<GearMeasures> measured(const SolvedJob& job, int which, const std::optional<Pair>& pair,
                              std::vector<Warning>& warnings) {
  return measured(job, job, which, tools_of(job, which), pair, warnings);
}

}  // namespace

std::optional<double> pin_of_diametral_pitch(const JobSpec& spec, int which, bool internal,
                                             double normal_module) {
  constexpr double kExternal = 1.728, kInternal = 1.68;  // modules
  const auto pitch_given = [&](int gear) {
    return spec.given.contains(gear_field(gear, "normal_diametral_pitch_per_in"));
  };
  if (spec.units() != UnitSystem::inch || !(pitch_given(1) || pitch_given(which)))
    return std::nullopt;
  return (internal ? kInternal : kExternal) * normal_module;
}

Result<std::vector<GearMeasures>> measure_gears(SolvedJob& job) {
  std::vector<GearMeasures> measures;
  const std::optional<Pair> pair = mounted(job);
  for (int which = 1; which <= static_cast<int>(job.gears.size()); ++which) {
    auto one = measured(job, which, pair, job.warnings);
    if (!one) return one.error();
    measures.push_back(std::move(one).take());
  }
  return measures;
}

std::vector<ValueRecord> measure_records(const SolvedJob& job) {
  std::vector<ValueRecord> records;
  std::vector<Warning> ignored;  // only the verb `measure` reports these warnings
  for (int which = 1; which <= static_cast<int>(job.gears.size()); ++which) {
    const auto measures = measured(job, which, job.pair, ignored);
    records.push_back(measures ? measure_quantities().of(*measures) : ValueRecord());
  }
  return records;
}

namespace {

// Returns the measurements of a gear at one combination of its tolerances, with the tools of the
// nominal gear.
ValueRecord measured_at(const SolvedJob& job, const Arranged& end, std::size_t i,
                        const GearMeasures& nominal) {
  MeasureInput tools = tools_of(job, static_cast<int>(i) + 1);
  if (nominal.span) tools.span_teeth = nominal.span->teeth;
  if (nominal.balls) tools.ball_diameter = nominal.balls->seat.ball_diameter;
  if (nominal.pins) tools.pin_diameter = nominal.pins->seat.ball_diameter;
  if (nominal.chord) tools.chord_diameter = nominal.chord->diameter;
  if (!nominal.pins || !nominal.pins->reading.three) tools.pin_diameter.reset();
  std::vector<Warning> ignored;
  auto found = measured(job, end, static_cast<int>(i) + 1, tools, end.pair, ignored);
  if (!found) return {};
  GearMeasures measures = std::move(found).take();
  measures.sizes = nominal.sizes;  // balls have the same sizes at all tolerances
  return measure_quantities().of(measures);
}

RecordLimits measured_limits(const SolvedJob& job, std::size_t i, const GearMeasures& nominal) {
  return limits_of(job, [&](const Arranged& at) { return measured_at(job, at, i, nominal); });
}

}  // namespace

std::vector<std::vector<ValueRecord>> measure_end_records(const SolvedJob& job) {
  std::vector<std::vector<ValueRecord>> records;
  std::vector<Warning> ignored;
  for (std::size_t i = 0; job.ends && i < job.gears.size(); ++i) {
    records.emplace_back();
    const auto nominal = measured(job, static_cast<int>(i) + 1, job.pair, ignored);
    if (!nominal) continue;
    records.back() = differing(measured_limits(job, i, *nominal));
  }
  return records;
}

Json measures_record(const SolvedJob& job, const std::vector<GearMeasures>& measures) {
  Json j = job_record(job);
  for (std::size_t i = 0; i < measures.size(); ++i) {
    Json& measure = j["gears"][i]["measure"];
    measure = to_json(measure_quantities().of(measures[i]));
    if (!job.ends) continue;
    measure["interval"] = interval_json(measured_limits(job, i, measures[i]));
  }
  return j;
}

std::string measure_listing(const SolvedJob& job, const std::vector<GearMeasures>& measures) {
  std::vector<ValueRecord> records;
  for (const GearMeasures& m : measures) records.push_back(measure_quantities().of(m));
  const QuantityTable& table = measure_quantities().table();
  std::string text =
      quantity_listing(job.spec.units(), table, records, gear_columns(records.size()));
  for (std::size_t i = 0; job.ends && i < measures.size(); ++i)
    text += interval_listing(job, i, table, measured_limits(job, i, measures[i]));
  return text;
}

}  // namespace gearwright
