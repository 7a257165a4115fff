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
    SetupChange::Flank& flank = change.flank[gear];
    const double mm = value[k] * kMmPerUm;
    switch (corrections[k].what) {
      case CorrectionOf::tool_setting: change.tool_setting = value[k]; break;
      case CorrectionOf::cutter_lead: change.cutter_lead[gear] = Angle::degrees(value[k]); break;
      case CorrectionOf::lead_slope: flank.lead_slope = mm; break;
      case CorrectionOf::lead_crowning: flank.lead_crowning = mm; break;
      case CorrectionOf::profile_slope: flank.profile_slope = mm; break;
      case CorrectionOf::profile_crowning: flank.profile_crowning = mm; break;
      case CorrectionOf::tip_relief: flank.tip_relief = mm; break;
      case CorrectionOf::root_relief: flank.root_relief = mm; break;
      case CorrectionOf::end_relief: flank.end_relief = mm; break;
    }
  }
  return change;
}

bool can_take(const ContactSetup& setup, const WorkshopCorrection& correction) {
  const auto placed = [&](Relief FlankModifications::*relief) {
    const auto& flanks = setup.modifications()[static_cast<std::size_t>(correction.gear - 1)];
    return (flanks[0].*relief).reach && (flanks[1].*relief).reach;
  };
  switch (correction.what) {
    case CorrectionOf::tool_setting: return setup.convex_gear().has_value();
    case CorrectionOf::cutter_lead: {
      const Gear& gear = setup.gear(correction.gear);
      return gear.twist() != 0.0 && !gear.cut_by;
    }
    case CorrectionOf::tip_relief: return placed(&FlankModifications::tip_relief);
    case CorrectionOf::root_relief: return placed(&FlankModifications::root_relief);
    case CorrectionOf::end_relief: return placed(&FlankModifications::end_relief);
    default: return true;
  }
}

std::optional<Influence> influence_of(const WorkshopCorrection& correction) {
  using P = RemovalField::Parameter;
  const auto of = [&](P parameter) {
    return Influence{ErrorKind::center_distance, correction.gear, parameter};
  };
  switch (correction.what) {
    case CorrectionOf::tool_setting:
    case CorrectionOf::cutter_lead: break;
    case CorrectionOf::lead_slope: return of(P::lead_slope);
    case CorrectionOf::lead_crowning: return of(P::lead_crowning);
    case CorrectionOf::profile_slope: return of(P::profile_slope);
    case CorrectionOf::profile_crowning: return of(P::profile_crowning);
    case CorrectionOf::tip_relief: return of(P::tip_relief);
    case CorrectionOf::root_relief: return of(P::root_relief);
    case CorrectionOf::end_relief: return of(P::end_relief);
  }
  return std::nullopt;
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
    if (influence_of(c)) wanted[static_cast<std::size_t>(c.gear - 1)] = true;
  return setup.with_fields(wanted);
}

Correction bounds_of(const ContactSetup& setup, const WorkshopCorrection& correction) {
  Correction bounds = usual_bounds(correction.what);
  if (correction.what != CorrectionOf::tool_setting) return bounds;
  const double most = 0.1 * setup.gear(*setup.convex_gear()).spec.normal_module;
  bounds.lo = std::max(bounds.lo, -most);
  bounds.hi = std::min(bounds.hi, most);
  return bounds;
}

std::vector<WorkshopCorrection> usual_corrections(const ContactSetup& setup) {
  const WorkshopCorrection setting{CorrectionOf::tool_setting, 0};
  if (can_take(setup, setting)) return {setting, {CorrectionOf::cutter_lead, 1}};
  return {{CorrectionOf::lead_slope, 1}, {CorrectionOf::lead_crowning, 1}};
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
