// A mounted pair for the contact analysis: its gears, their modifications and its errors, and the
// effect of corrections.
//
// A ContactPair points to its gears and to the material removed from their flanks; a ContactSetup
// owns them.
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

/// The modifications of gear 1 and gear 2: the right flank, the left flank.
using PairModifications = std::array<std::array<FlankModifications, 2>, 2>;

/// Changes made by a workshop, as amounts in addition to those of the drawing.
struct SetupChange {
  double tool_setting = 0.0;           ///< Δb_F  mm, of the gear that F cuts
  std::array<Angle, 2> cutter_lead{};  ///< Δλ
  struct Flank {
    double lead_slope = 0.0, lead_crowning = 0.0;        ///< mm; the slope on the driven flanks
    double profile_slope = 0.0, profile_crowning = 0.0;  ///< only, right if gear 1 drives
    double tip_relief = 0.0, root_relief = 0.0, end_relief = 0.0;  ///< of reliefs that are placed

    bool operator==(const Flank&) const = default;
  };
  std::array<Flank, 2> flank;
  bool left = false;  ///< the slopes apply to the left flanks of gear 1 (gear 2 drives)
};

class ContactSetup {
 public:
  /// `fields`: gears that need a field of removed material for its derivatives, even if nothing is
  /// removed.
  ///
  /// Errors    `gearN` without a usable flank; `gearN.modifications.…` as make_removal_field;
  ///           `errors.cutter_lead[N]` as check_cutter_lead
  static Result<ContactSetup> of(const Pair& pair, const ContactErrors& errors,
                                 const PairModifications& modifications = {},
                                 std::array<bool, 2> fields = {});

  /// The pair points to this setup, which must outlive it.
  ContactPair pair(bool gear2_drives) const { return pair(place_.errors, gear2_drives); }
  ContactPair pair(const ContactErrors& errors, bool gear2_drives) const;
  /// The same pair with a copy of this setup.
  std::shared_ptr<const ContactPair> shared_pair(const ContactErrors& errors,
                                                 bool gear2_drives) const;
  /// The pair with root fillets and tips in addition to the flanks; none if a cutter's lead was
  /// changed and the root was not cut by a rack.
  std::optional<ContactPair> outlines(bool gear2_drives) const;
  const ContactMount& place() const { return place_; }
  const Gear& gear(int which) const { return *gears_[which - 1]; }
  std::array<const Gear*, 2> gears() const { return {gears_[0].get(), gears_[1].get()}; }
  const RemovalField* removal(int gear, bool left) const;
  /// The setup with these corrections; an error if there are no such teeth.
  Result<ContactSetup> changed(const SetupChange& change) const;
  const PairModifications& modifications() const { return modifications_; }
  /// The setup with other modifications.   Errors `gearN.modifications.…` as make_removal_field
  Result<ContactSetup> with_modifications(const PairModifications& modifications) const;
  /// The setup of one half of a double-helical pair, whose faces have their middles at these heights.
  /// The half at z < 0 (`below`) is represented by its mirror image in the plane z = 0.
  ContactSetup half_at(const std::array<double, 2>& middle, bool below) const;
  /// The setup with fields of removed material on these gears, even if nothing is removed, because
  /// their derivatives need the fields.
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

/// True if material is removed or a relief of amount 0 has a place.
bool any_modification(const std::array<FlankModifications, 2>& flanks);

/// Checks that the lead angle of a cutter can deviate by this amount; empty if it can.
///
/// Errors    `errors.cutter_lead[N]` of a spur gear, of one that a gear has cut, or if the lead
///           angle leaves kMinLead to kMaxLead
std::optional<Error> check_cutter_lead(const Gear& gear, int which, Angle change);
constexpr Angle kMinLead = Angle::degrees(0.5), kMaxLead = Angle::degrees(90);

/// The error of the modifications of a flank (side 0 is the right one), as an error of gear 1 or 2.
Error of_flank(int which, int side, Error error);

/// The usable flank of a gear, to which its modifications apply.
///
/// Domain  a gear with a root form radius (contract)
FlankExtent flank_extent(const Gear& gear);

/// The error that no teeth touch at any position, with the reason, such as tips that pass each
/// other. The second form names the corner of [compensate.range] with these errors.
Error nothing_touches(const ContactSetup& setup);
Error nothing_touches_under(const ContactSetup& setup, const std::string& name,
                            const ContactErrors& errors);
/// True if the error is that this pair has no contact at all, rather than an invalid number.
bool without_contact(const Error& error);

}  // namespace gearwright
