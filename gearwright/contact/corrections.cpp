#include "gearwright/contact/corrections.hpp"

#include <algorithm>

#include "gearwright/base/units.hpp"

namespace gearwright {

SetupChange change_of(const std::vector<WorkshopCorrection>& corrections,
                      const std::vector<double>& value, bool gear2_drives) {
  SetupChange change;
  change.left = gear2_drives;
  for (std::size_t k = 0; k < corrections.size(); ++k) {
    const auto gear = static_cast<std::size_t>(std::max(1, corrections[k].gear) - 1);
    if (const Modification* m = corrections[k].modification()) {
      change.flank[gear][*m] = value[k] * kMmPerUm;
    } else if (corrections[k].is(CutterSetting::cutter_lead)) {
      change.cutter_lead[gear] = Angle::degrees(value[k]);
    } else {
      change.tool_setting = value[k];
    }
  }
  return change;
}

bool can_take(const ContactSetup& setup, const WorkshopCorrection& correction) {
  if (correction.is(CutterSetting::tool_setting)) return setup.convex_gear().has_value();
  if (const Modification* m = correction.modification()) {
    const auto& flanks = setup.modifications()[correction.gear - 1];
    return member_of(*m).placed(flanks[0]) && member_of(*m).placed(flanks[1]);
  }
  const Gear& gear = setup.gear(correction.gear);
  return gear.twist() != 0.0 && !gear.cut_by;
}

std::optional<Influence> influence_of(const WorkshopCorrection& correction) {
  const Modification* m = correction.modification();
  if (!m) return std::nullopt;
  return Influence{ErrorKind::center_distance, correction.gear, *m};
}

std::optional<std::vector<Influence>> influences_of(
    const std::vector<WorkshopCorrection>& corrections) {
  std::vector<Influence> all;
  for (const WorkshopCorrection& c : corrections) {
    const auto influence = influence_of(c);
    if (!influence) return std::nullopt;
    all.push_back(*influence);
  }
  return all;
}

ContactSetup with_fields_for(const ContactSetup& setup,
                             const std::vector<WorkshopCorrection>& corrections) {
  std::array<bool, 2> wanted{};
  for (const WorkshopCorrection& c : corrections)
    if (influence_of(c)) wanted[c.gear - 1] = true;
  return setup.with_fields(wanted);
}

Correction bounds_of(const ContactSetup& setup, const WorkshopCorrection& correction) {
  if (correction.is(CutterSetting::cutter_lead)) return {-0.5, 0.5, 0.005};
  const Modification* m = correction.modification();
  if (!m) {
    const double most = std::min(5.0, 0.1 * setup.gear(*setup.convex_gear()).spec.normal_module);
    return {-most, most, 0.005};
  }
  switch (*m) {
    case Modification::lead_slope: return {-100.0, 100.0, 2.0};
    case Modification::profile_slope: return {-50.0, 50.0, 1.0};
    case Modification::lead_crowning: return {0.0, 50.0, 2.0};
    default: return {0.0, 50.0, 1.0};
  }
}

std::vector<WorkshopCorrection> usual_corrections(const ContactSetup& setup) {
  const WorkshopCorrection setting{CutterSetting::tool_setting, 0};
  if (can_take(setup, setting)) return {setting, {CutterSetting::cutter_lead, 1}};
  return {{Modification::lead_slope, 1}, {Modification::lead_crowning, 1}};
}

CompensationTask compensation_task(const ContactSetup& setup,
                                   const std::vector<WorkshopCorrection>& corrections,
                                   const std::vector<ContactErrors>& scenarios, bool gear2_drives) {
  CompensationTask task;
  task.scenarios = static_cast<int>(scenarios.size());
  task.along_face = setup.gear(1).involute() != nullptr;
  for (const WorkshopCorrection& c : corrections) {
    GW_EXPECTS(can_take(setup, c));
    task.corrections.push_back(bounds_of(setup, c));
  }
  task.pair_at = [=](const std::vector<double>& value,
                     int s) -> std::shared_ptr<const ContactPair> {
    const auto changed = setup.changed(change_of(corrections, value, gear2_drives));
    if (!changed) return nullptr;
    ContactErrors errors = scenarios[static_cast<std::size_t>(s)];
    for (int i = 0; i < 2; ++i)
      errors.cutter_lead[i] +=
          changed->place().errors.cutter_lead[i] - setup.place().errors.cutter_lead[i];
    return changed->shared_pair(errors, gear2_drives);
  };
  return task;
}

}  // namespace gearwright
