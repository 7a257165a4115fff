// A mounted pair for the contact analysis, with its gears, modifications and errors. Corrections
// turn it into another setup.
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

/// The modifications of gear 1 and of gear 2, each for the right and the left flank.
using PairModifications = std::array<std::array<FlankModifications, 2>, 2>;

constexpr bool is_slope(Modification m) {
  return m == Modification::lead_slope || m == Modification::profile_slope;
}

/// Changes made by a workshop. All amounts are added to the amounts on the drawing.
struct SetupChange {
  double tool_setting = 0.0;           ///< Δb_F  mm, of the gear that a rack F cuts
  std::array<Angle, 2> cutter_lead{};  ///< Δλ of the cutter of each gear
  /// Amounts of each gear. Slopes change the working flanks only, and crownings change both flanks.
  /// Reliefs change only where the drawing has a relief.
  std::array<ModificationAmounts, 2> flank;
  bool left = false;  ///< true if the left flanks of gear 1 are the working flanks (gear 2 drives)
};

class ContactSetup {
 public:
  /// Makes the setup of a pair. `fields` selects gears that get a field of removed material even if
  /// nothing is removed, because derivatives need the field.
  ///
  /// Errors    `gearN` without a usable flank; `gearN.modifications.…` as make_removal_field;
  ///           `errors.cutter_lead[N]` as check_cutter_lead
  static Result<ContactSetup> of(const Pair& pair, const ContactErrors& errors,
                                 const PairModifications& modifications = {},
                                 std::array<bool, 2> fields = {});

  /// The pair for the analysis. It refers to the data of this setup, which must outlive the pair.
  ContactPair pair(bool gear2_drives) const { return pair(place_.errors, gear2_drives); }
  ContactPair pair(const ContactErrors& errors, bool gear2_drives) const;
  /// The pair under these errors. It owns a copy of this setup, which need not outlive the pair.
  std::shared_ptr<const ContactPair> shared_pair(const ContactErrors& errors,
                                                 bool gear2_drives) const;
  /// The pair with root fillets and rounded tips in addition to the flanks. None if the cutter of a
  /// gear has a changed lead angle and the root of this gear was not cut by a rack.
  std::optional<ContactPair> outlines(bool gear2_drives) const;
  const ContactMount& place() const { return place_; }
  const Gear& gear(int which) const { return *gears_[which - 1]; }
  std::array<const Gear*, 2> gears() const { return {gears_[0].get(), gears_[1].get()}; }
  const RemovalField* removal(int gear, bool left) const;
  /// The setup after this change; an error if no teeth with this change exist.
  Result<ContactSetup> changed(const SetupChange& change) const;
  const PairModifications& modifications() const { return modifications_; }
  /// This setup, but with these modifications.
  ///
  /// Errors    `gearN.modifications.…` as make_removal_field
  Result<ContactSetup> with_modifications(const PairModifications& modifications) const;
  /// One half of a double-helical pair. `middle` contains z of the middle of each face. If `below`,
  /// the half is at z < 0 and is represented by its mirror image in the plane z = 0.
  ContactSetup half_at(const std::array<double, 2>& middle, bool below) const;
  /// The setup in which the gears selected by `wanted` have fields of removed material, even if
  /// nothing is removed, because derivatives need the fields.
  ContactSetup with_fields(std::array<bool, 2> wanted) const;
  /// The gear that a rack F cuts, 1 or 2; none for other teeth.
  std::optional<int> convex_gear() const;

 private:
  ContactPair at(const ContactMount& place) const;
  std::optional<Error> make_fields(std::array<bool, 2> wanted);

  std::array<std::shared_ptr<const Gear>, 2> gears_;
  PairModifications modifications_;
  std::array<std::array<std::shared_ptr<const RemovalField>, 2>, 2> removal_;
  ContactMount place_;
};

/// True if material is removed from a flank, or if a flank has a relief whose reach is given. The
/// amount of this relief may be 0.
bool any_modification(const std::array<FlankModifications, 2>& flanks);

/// Checks that the lead angle of the cutter can change by this amount. Returns nothing if it can.
///
/// Errors    `errors.cutter_lead[N]` if the gear is a spur gear or was cut by a pinion cutter,
///           or if the lead angle is not between kMinLead and kMaxLead
std::optional<Error> check_cutter_lead(const Gear& gear, int which, Angle change);
constexpr Angle kMinLead = Angle::degrees(0.5), kMaxLead = Angle::degrees(90);

/// Converts an error in the modifications of a flank to an error of gear `which`. Side 0 is the
/// right flank.
Error of_flank(int which, int side, Error error);

/// The usable flank of a gear, to which its modifications apply.
///
/// Domain  a gear with a root form radius (contract)
FlankExtent flank_extent(const Gear& gear);

/// The error for a pair whose teeth touch at no position. The text of the error gives the reason,
/// for example tips that do not reach each other. The field is `errors` or, without errors,
/// `pair.center_distance`. The second function makes the error for a pair under `errors`, a
/// scenario of [compensate.range] that is called `name`.
Error nothing_touches(const ContactSetup& setup);
Error nothing_touches_under(const ContactSetup& setup, const std::string& name,
                            const ContactErrors& errors);
/// True if the cause of the error is that the teeth touch at no position.
bool without_contact(const Error& error);

}  // namespace gearwright
