// The corrections that a workshop makes on a pair against its errors, and the task of finding them.
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
  tool_setting,      ///< Δb_F  mm, of the rack F of circular arcs
  cutter_lead,       ///< Δλ    degrees
  lead_slope,        ///< µm, on the driven flanks
  lead_crowning,     ///< µm, on both flanks
  profile_slope,     ///< µm, on the driven flanks
  profile_crowning,  ///< µm, on both flanks
  tip_relief,        ///< µm, likewise, of a relief that the drawing places
  root_relief,
  end_relief,
};

struct WorkshopCorrection {
  CorrectionOf what;
  int gear;  ///< 1, 2; 0: of the tool setting, the gear that the rack F cuts

  bool operator==(const WorkshopCorrection&) const = default;
  bool slope() const {
    return what == CorrectionOf::lead_slope || what == CorrectionOf::profile_slope;
  }
};

/// Bounds of everyday work and a small change, in the correction's unit.
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

/// A tool setting needs a rack F, a lead a helical gear that a rack cuts, a relief its place on both
/// flanks.
bool can_take(const ContactSetup& setup, const WorkshopCorrection& correction);

/// What a workshop would choose: tool setting and lead of arcs, else slope and crowning of gear 1.
std::vector<WorkshopCorrection> usual_corrections(const ContactSetup& setup);

/// These amounts, in the corrections' units; `gear2_drives`: which flanks a slope is meant for.
SetupChange change_of(const std::vector<WorkshopCorrection>& corrections,
                      const std::vector<double>& value, bool gear2_drives);

/// Of a flank's, the number whose influence is computed; none of a tool's.
std::optional<Influence> influence_of(const WorkshopCorrection& correction);

/// Its usual bounds on this pair: a tool setting ends at a tenth of the module as well.
Correction bounds_of(const ContactSetup& setup, const WorkshopCorrection& correction);

/// The pair under each of the `scenarios` with these corrections, within bounds_of().
///
/// Domain    corrections that the setup can take (contract)
CompensationTask compensation_task(const ContactSetup& setup,
                                   const std::vector<WorkshopCorrection>& corrections,
                                   const std::vector<ContactErrors>& scenarios,
                                   bool gear2_drives = false);

}  // namespace gearwright
