// The pair of a job as contact takes it: gears, errors and removed material, and what corrections
// would make of it. The verbs `contact`, `compensate` and `load` begin here.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "gearwright/contact/contact.hpp"
#include "gearwright/job/solved_job.hpp"

namespace gearwright {

/// A number whose influence is told: its key in results, and rad or mm of it per unit of the key.
struct NamedInfluence {
  std::string key;    ///< "crossing_per_deg", "gear1_lead_crowning_per_um"
  double unit = 1.0;  ///< rad or mm per unit of the key
  Influence influence;
};

/// What a workshop changes: amounts on top of the drawing's.
struct SetupChange {
  double tool_setting = 0.0;           ///< Δb_F  mm, of the gear that F cuts
  std::array<Angle, 2> cutter_lead{};  ///< Δλ
  struct Flank {
    double lead_slope = 0.0, lead_crowning = 0.0;        ///< mm; the slope on the driven flanks
    double profile_slope = 0.0, profile_crowning = 0.0;  ///< only, right if gear 1 drives
  };
  std::array<Flank, 2> flank;
  bool left = false;  ///< the slopes are meant for the left flanks of gear 1 (gear 2 drives)
};

/// The pair of a job as contact takes it, with what it points to.
class ContactSetup {
 public:
  /// Errors    `gearN.modifications.…`; `errors.cutter_lead[N]` where there is no lead to change;
  ///           `gearN` without a usable flank
  static Result<ContactSetup> of(const SolvedJob& job);

  ContactPair pair(bool gear2_drives) const { return pair(place_.errors, gear2_drives); }
  ContactPair pair(const ContactErrors& errors, bool gear2_drives) const;
  /// With root fillets and tips beside the flanks; none: a cutter's lead was changed, and the root
  /// is no rack's.
  std::optional<ContactPair> outlines(bool gear2_drives) const;
  const ContactMount& place() const { return place_; }
  const Gear& gear(int which) const { return *gears_[which - 1]; }
  const RemovalField* removal(int gear, bool left) const;
  /// Every error, and every modification that the drawing places.
  const std::vector<NamedInfluence>& influences() const { return influences_; }
  /// The same with corrections made; an error where there are no such teeth.
  Result<ContactSetup> changed(const SetupChange& change) const;
  /// The gear that a rack F cuts, 1 or 2; none: the teeth are no such pair.
  std::optional<int> convex_gear() const;
  /// The errors with one of error_entries set to a value in its own unit.
  ContactErrors with_error(ContactErrors errors, std::size_t index, double value) const;

 private:
  ContactPair at(const ContactMount& place) const;

  std::array<std::shared_ptr<const Gear>, 2> gears_;
  std::array<std::array<FlankModifications, 2>, 2> modifications_;
  std::array<std::array<std::shared_ptr<const RemovalField>, 2>, 2> removal_;
  ContactMount place_;
  std::vector<NamedInfluence> influences_;
};

/// No tooth touches at any position: the tips pass each other, or why else. The second: under
/// `errors`, a corner of [compensate.range] of this name.
Error nothing_touches(const ContactSetup& setup);
Error nothing_touches_under(const ContactSetup& setup, const std::string& name,
                            const ContactErrors& errors);

}  // namespace gearwright
