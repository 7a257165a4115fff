// The corrections by which a workshop compensates the errors of a pair, and the task that computes
// them.
//
//   const auto setup = ContactSetup::of(*pair, {});
//   CompensationTask task = compensation_task(*setup, {{CorrectionOf::lead_slope, 1}}, scenarios);
//   const Compensation found = compensate(task);  // found.value[0] in µm
#pragma once

#include <vector>

#include "gearwright/contact/compensation.hpp"
#include "gearwright/contact/contact_setup.hpp"

namespace gearwright {

enum class CorrectionOf {
  tool_setting,      ///< Δb_F  mm, of the rack F that cuts convex circular arcs
  cutter_lead,       ///< Δλ  degrees, of the cutter of the gear
  lead_slope,        ///< µm, on the working flanks
  lead_crowning,     ///< µm, on both flanks
  profile_slope,     ///< µm, on the working flanks
  profile_crowning,  ///< µm, on both flanks
  tip_relief,        ///< µm, on both flanks; only if the drawing gives the reach of the relief
  root_relief,       ///< µm, as tip_relief
  end_relief,        ///< µm, as tip_relief
};

struct WorkshopCorrection {
  CorrectionOf what;
  int gear;  ///< 1, 2; 0 for the tool setting, which applies to the gear that the rack F cuts

  bool operator==(const WorkshopCorrection&) const = default;
  bool slope() const {
    return what == CorrectionOf::lead_slope || what == CorrectionOf::profile_slope;
  }
};

/// Usual lower and upper bound of a correction and its step, in the unit of the correction.
constexpr Correction usual_bounds(CorrectionOf what) {
  switch (what) {
    case CorrectionOf::tool_setting: return {-5.0, 5.0, 0.005};
    case CorrectionOf::cutter_lead: return {-0.5, 0.5, 0.005};
    case CorrectionOf::lead_slope: return {-100.0, 100.0, 2.0};
    case CorrectionOf::profile_slope: return {-50.0, 50.0, 1.0};
    case CorrectionOf::lead_crowning: return {0.0, 50.0, 2.0};
    case CorrectionOf::profile_crowning:
    case CorrectionOf::tip_relief:
    case CorrectionOf::root_relief:
    case CorrectionOf::end_relief: return {0.0, 50.0, 1.0};
  }
  return {};
}

/// True if the correction is possible. A tool setting requires a rack F, a cutter lead requires a
/// helical gear cut by a rack, and a relief requires a reach on both flanks.
bool can_take(const ContactSetup& setup, const WorkshopCorrection& correction);

/// The usual corrections: tool setting and cutter lead for circular arcs, otherwise lead slope and
/// lead crowning of gear 1.
std::vector<WorkshopCorrection> usual_corrections(const ContactSetup& setup);

/// The change that corresponds to these values, in the units of the corrections. `gear2_drives`
/// selects the flanks on which slopes act.
SetupChange change_of(const std::vector<WorkshopCorrection>& corrections,
                      const std::vector<double>& value, bool gear2_drives);

/// The influence by which the sensitivities to a correction are computed; none for a tool setting
/// and a cutter lead, which do not remove material from the flanks.
std::optional<Influence> influence_of(const WorkshopCorrection& correction);

/// The influences of all corrections; none if one of them has no influence.
std::optional<std::vector<Influence>> influences_of(
    const std::vector<WorkshopCorrection>& corrections);

/// The setup with fields of removed material on the gears whose corrections have an influence.
ContactSetup with_fields_for(const ContactSetup& setup,
                             const std::vector<WorkshopCorrection>& corrections);

/// The usual bounds for this pair. A tool setting is also limited to a tenth of the module.
Correction bounds_of(const ContactSetup& setup, const WorkshopCorrection& correction);

/// The task that computes these corrections, within bounds_of(), for the worst of the `scenarios`.
///
/// Domain    can_take() is true for every correction (contract)
CompensationTask compensation_task(const ContactSetup& setup,
                                   const std::vector<WorkshopCorrection>& corrections,
                                   const std::vector<ContactErrors>& scenarios,
                                   bool gear2_drives = false);

}  // namespace gearwright
