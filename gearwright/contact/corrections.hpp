// The corrections by which a workshop compensates the errors of a pair, and the task from which
// compensate() computes their values.
//
//   const auto setup = ContactSetup::of(*pair, {});
//   CompensationTask task = compensation_task(*setup, {{Modification::lead_slope, 1}}, scenarios);
//   const Compensation found = compensate(task);  // found.value[0] in µm
#pragma once

#include <variant>
#include <vector>

#include "gearwright/contact/compensation.hpp"
#include "gearwright/contact/contact_setup.hpp"

namespace gearwright {

enum class CutterSetting {
  tool_setting,  ///< Δb_F  mm, of the rack F that cuts convex circular arcs
  cutter_lead,   ///< Δλ  degrees, of the gear's cutter
};

/// A correction of a pair. Modifications are in µm. Slopes apply to the working flanks, and other
/// modifications to both flanks. A relief is possible only if the drawing gives its reach.
struct WorkshopCorrection {
  std::variant<CutterSetting, Modification> what;
  int gear;  ///< 1, 2; 0 for the tool setting, which applies to the gear that the rack F cuts

  bool operator==(const WorkshopCorrection&) const = default;
  bool is(CutterSetting setting) const { return what == decltype(what)(setting); }
  /// The modification; null if the correction is a tool setting or a cutter lead.
  const Modification* modification() const { return std::get_if<Modification>(&what); }
  bool slope() const { return modification() && is_slope(*modification()); }
};

/// True if the correction is possible for this pair. A tool setting requires a rack F. A cutter
/// lead requires a helical gear cut by a rack. A relief requires a reach on both flanks.
bool can_take(const ContactSetup& setup, const WorkshopCorrection& correction);

/// Returns the usual corrections. These are tool setting and cutter lead for circular arcs, and
/// lead slope and lead crowning of gear 1 for other teeth.
std::vector<WorkshopCorrection> usual_corrections(const ContactSetup& setup);

/// The change of the setup for these values, which are in the units of the corrections.
/// `gear2_drives` selects the flanks on which slopes act.
SetupChange change_of(const std::vector<WorkshopCorrection>& corrections,
                      const std::vector<double>& value, bool gear2_drives);

/// Returns the influence that corresponds to a correction, for derivatives with respect to it.
/// Returns none for a tool setting or a cutter lead, which remove no material from the flanks.
std::optional<Influence> influence_of(const WorkshopCorrection& correction);

/// Returns the influences of all corrections, or none if a correction has no influence_of().
std::optional<std::vector<Influence>> influences_of(
    const std::vector<WorkshopCorrection>& corrections);

/// The setup with fields of removed material on the gears whose corrections have an influence.
ContactSetup with_fields_for(const ContactSetup& setup,
                             const std::vector<WorkshopCorrection>& corrections);

/// The usual bounds of a correction and the usual step, in the unit of the correction. The bounds
/// of a tool setting are plus and minus a tenth of the module, but not more than 5 mm.
Correction bounds_of(const ContactSetup& setup, const WorkshopCorrection& correction);

/// Returns the task of computing these corrections within bounds_of(). The task minimises the cost
/// of the worst of the `scenarios`.
///
/// Domain    can_take() is true for every correction (contract)
CompensationTask compensation_task(const ContactSetup& setup,
                                   const std::vector<WorkshopCorrection>& corrections,
                                   const std::vector<ContactErrors>& scenarios,
                                   bool gear2_drives = false);

}  // namespace gearwright
