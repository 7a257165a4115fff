// A mounted pair for the contact analysis, with its gears, modifications and errors. A correction
// of the teeth gives a new setup.
//
// A ContactSetup owns the gears and the fields of removed material to which a ContactPair points.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>

#include "gearwright/base/result.hpp"
#include "gearwright/contact/contact.hpp"
#include "gearwright/gear/modifications.hpp"
#include "gearwright/pair/pair.hpp"

namespace gearwright {

constexpr bool is_slope(Modification m) {
  return m == Modification::lead_slope || m == Modification::profile_slope;
}

/// Corrections that a workshop makes. Each amount is added to the amount on the drawing.
struct SetupChange {
  double tool_setting = 0.0;           ///< Δb_F  mm, change for the gear that a rack F cuts
  std::array<Angle, 2> cutter_lead{};  ///< Δλ of the cutter of each gear
  /// Amounts of each gear. Slopes are added to the working flanks only, and all other amounts to
  /// both flanks. An amount of a relief requires that the drawing has this relief.
  std::array<ModificationAmounts, 2> flank;
  bool left = false;  ///< true if the left flanks of gear 1 are the working flanks (gear 2 drives)
};

/// The material that the modifications of a gear remove from its right and from its left flanks.
using FlankRemoval = std::array<std::shared_ptr<const RemovalField>, 2>;

/// A gear and the material that its modifications remove. Copies share both.
struct SetupGear {
  std::shared_ptr<const Gear> gear;
  FlankRemoval removal{};

  /// Checks the gear and the change of the lead angle of its cutter.
  ///
  /// Errors    `gearN` without a usable flank; `errors.cutter_lead[N−1]` as check_cutter_lead
  static Result<SetupGear> of(const Gear& gear, int which, Angle cutter_lead);
  /// Makes the fields. Without modifications, a gear without fields gets them only if `wanted`.
  ///
  /// Errors    `gearN.modifications.…` as make_removal_field
  std::optional<Error> modify(int which, const BothFlanks& flanks, bool wanted);
  ContactGear flanks() const { return {gear.get(), {removal[0].get(), removal[1].get()}}; }
};

class ContactSetup {
 public:
  /// Makes the setup of a pair. If `fields` is true for a gear, the gear gets a field of removed
  /// material even if nothing is removed, because derivatives need the field.
  ///
  /// Errors    `gearN` if the gear has no usable flank; `gearN.modifications.…` as
  ///           make_removal_field; `errors.cutter_lead[N−1]` as check_cutter_lead
  static Result<ContactSetup> of(const Pair& pair, const ContactErrors& errors,
                                 const PairModifications& modifications = {},
                                 std::array<bool, 2> fields = {});

  /// The pair for the analysis. It refers to the data of this setup, which must outlive the pair.
  ContactPair pair(bool gear2_drives) const { return pair(place_.errors, gear2_drives); }
  ContactPair pair(const ContactErrors& errors, bool gear2_drives) const;
  /// Returns the pair under `errors`. The pair owns a copy of this setup and may outlive it.
  std::shared_ptr<const ContactPair> shared_pair(const ContactErrors& errors,
                                                 bool gear2_drives) const;
  /// Returns the pair with root fillets and rounded tips in addition to the flanks. Returns none if
  /// the errors change the lead angle of a cutter, and recut_outline() returns no outline for the
  /// gear of this cutter.
  std::optional<ContactPair> outlines(bool gear2_drives) const;
  const ContactMount& place() const { return place_; }
  const Gear& gear(int which) const { return *gears_[which - 1].gear; }
  std::array<const Gear*, 2> gears() const { return {&gear(1), &gear(2)}; }
  const RemovalField* removal(int gear, bool left) const;
  /// Returns the setup after this change.
  ///
  /// Domain    a tool setting of 0 if convex_gear() is none (contract)
  /// Errors    `gearN.modifications.…` as make_removal_field; `gearN.…` as make_gear for the
  ///           changed tool setting; `compensate.corrections` if this setting leaves no tooth
  Result<ContactSetup> changed(const SetupChange& change) const;
  const PairModifications& modifications() const { return modifications_; }
  /// Returns this setup with other modifications.
  ///
  /// Errors    `gearN.modifications.…` as make_removal_field
  Result<ContactSetup> with_modifications(const PairModifications& modifications) const;
  /// Returns the setup of one half of a double-helical pair. `middle` contains z of the middle of
  /// each face. If `below` is true, the half lies at z < 0, and the setup describes its mirror
  /// image in the plane z = 0.
  ContactSetup half_at(const std::array<double, 2>& middle, bool below) const;
  /// Returns this setup with fields of removed material on the gears that `wanted` selects.
  /// Derivatives need these fields even if nothing is removed.
  ContactSetup with_fields(std::array<bool, 2> wanted) const;
  /// The gear that a rack F cuts, 1 or 2; none for other teeth.
  std::optional<int> convex_gear() const;

 private:
  ContactPair at(const ContactMount& place) const;
  std::optional<Error> make_fields(std::array<bool, 2> wanted);

  std::array<SetupGear, 2> gears_;
  PairModifications modifications_;
  ContactMount place_;
};

/// True if a flank has a modification, a topography or a form wave. A relief whose reach is given
/// counts, even if its amount is 0.
bool any_modification(const BothFlanks& flanks);

/// Returns an error if the lead angle of the cutter cannot change by this amount.
///
/// Errors    `errors.cutter_lead[which−1]` if the gear is a spur gear or was cut by a pinion
///           cutter, or if the lead angle is not between kMinLead and kMaxLead, these ends
///           excluded. A change of 0 is never an error
std::optional<Error> check_cutter_lead(const Gear& gear, int which, Angle change);
constexpr Angle kMinLead = Angle::degrees(0.5), kMaxLead = Angle::degrees(90);

/// Makes the fields of material that the modifications remove.
///
/// Domain    a gear with a root form radius (contract)
/// Errors    `modifications.right.…` or `modifications.left.…` as make_removal_field
Result<FlankRemoval> removal_of(const Gear& gear, const BothFlanks& flanks);

/// The usable flank of a gear, to which its modifications apply.
///
/// Domain  a gear with a root form radius (contract)
FlankExtent flank_extent(const Gear& gear);

/// Return the error for a pair whose teeth touch at no position. The text of the error gives the
/// reason, for example tips that do not reach each other. The field is `errors` or, without errors,
/// `pair.center_distance`. The second function applies to the scenario `name` of
/// [compensate.range], which has these `errors`. Its field is `compensate.range`.
Error nothing_touches(const ContactSetup& setup);
Error nothing_touches_under(const ContactSetup& setup, const std::string& name,
                            const ContactErrors& errors);
/// True if the cause of the error is a gear without usable flank, or teeth that never touch. An
/// error of nothing_touches_under() does not count.
bool without_contact(const Error& error);

}  // namespace gearwright
