// Computes the numbers that describe the contact of one member of the family over a pitch.
//
//   ΔE_sn   change of the tooth thickness
//   s       reduction of the backlash by ΔE_sn, as an angle of gear 2
//                                    theory: docs/theory/14-scatter.md, [T14.11], [T14.13]
//
// The verb `contact` gives the same numbers for the same errors, with two exceptions. It gives no
// clearances and no long period. Its `peak_to_peak` is that of the computed positions, while the
// peak to peak here is that of the continuous curve.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "gearwright/contact/contact_score.hpp"
#include "gearwright/contact/sensitivity.hpp"
#include "gearwright/scatter/tolerance.hpp"

namespace gearwright {

enum class ScatterQuantity {
  peak_to_peak,     ///< rad, peak to peak of the continuous TE curve
  harmonic1,        ///< rad
  harmonic2,        ///< rad
  harmonic3,        ///< rad
  mean,             ///< rad, mean of TE over the positions
  along_face,       ///< mean place of the contact along the face, −1 to 1
  along_profile,    ///< mean place along the profile, for circular-arc teeth
  edge_share,       ///< fraction of the positions at which an edge touches
  least_play,       ///< rad, least play of gear 2; < 0 if the gears jam
  long_period,      ///< rad, peak to peak over the long period, if pitches differ
  tip_clearance1,   ///< mm, from the tip of gear 1 to the root of gear 2
  tip_clearance2,   ///< mm, from the tip of gear 2 to the root of gear 1
  form_clearance1,  ///< mm, from the start of the usable flank of gear 1 to the nearest contact
  form_clearance2,  ///< mm, from the start of the usable flank of gear 2
};
constexpr std::size_t kScatterQuantities = 14;

struct FamilyMember {
  std::array<std::optional<double>, kScatterQuantities> value{};
  bool lost = false;  ///< true if nothing touches at some position
  bool jam = false;   ///< result of jams() for the least play

  std::optional<double> operator[](ScatterQuantity q) const {
    return value[static_cast<std::size_t>(q)];
  }
  bool edge() const { return (*this)[ScatterQuantity::edge_share] > 0.0; }
};

struct MemberRequest {
  int positions = 32;  ///< per pitch
  bool gear2_drives = false;
  ProfileTarget profile{};
  std::optional<double> stagger{};  ///< stagger of the halves of a double-helical pair, in pitches;
                                    ///< none for other pairs
};

/// The setup of a member. This is the nominal setup, unless the modifications of the member differ
/// from the nominal modifications.
///
/// Domain    modifications that check_ends() accepts (contract); `setup` must outlive the object
class MemberSetup {
 public:
  MemberSetup(const ContactSetup& setup, const Deviation& deviation);
  const ContactSetup& operator*() const { return own_ ? *own_ : drawn_; }

 private:
  const ContactSetup& drawn_;
  std::optional<ContactSetup> own_;
};

/// Returns the reduction of the backlash by thicker teeth, as an angle of gear 2, rad.
///
/// Formula   [T14.13], exact for involutes
/// Domain    involute teeth, or no change (contract)
double play_taken(const ContactSetup& setup, const std::array<double, 2>& thickness);

/// Returns the numbers of the member with this deviation. For a double-helical pair, TE and
/// backlash describe the whole gears, one of which floats along its axis. Errors of mounting apply
/// to both halves, and deviations of the teeth are the same on both halves. `edge_share` is the
/// mean of both halves. `along_face` and `along_profile` are each taken from the half with the
/// greater magnitude, and `along_face` is > 0 away from the apex. If contact is lost at some
/// position, only `edge_share`, `least_play` and the clearances have values.
///
/// Domain    positions ≥ 2; modifications that check_ends() accepts; no deviations of pitch for a
///           double-helical pair (contract)
/// Accuracy  as analyse_contact() and continuous_extremes()
/// Laws      (1) without deviations, the numbers are equal to the results of analyse_contact()
///           (2) the numbers of spur gears follow the closed forms of [T14.14]
///           (3) if no error tilts an axis, a double-helical pair has the numbers of a half
FamilyMember member_at(const ContactSetup& setup, const Deviation& deviation,
                       const MemberRequest& request);

/// Peak to peak of the continuous curve, rad, and its derivatives with respect to the influences,
/// in rad per mm or rad per rad.
struct MemberSpan {
  std::optional<double> value;  ///< none if contact is lost
  std::vector<double> slope;
};

/// Domain    as member_at(); if a modification of a gear is an influence, this gear has a field
///           of removed material; no influences for a double-helical pair (contract)
/// Accuracy  as continuous_extremes() and span_slope()
MemberSpan continuous_peak_to_peak(const ContactSetup& setup, const Deviation& deviation,
                                   const MemberRequest& request,
                                   std::span<const Influence> influences = {});

}  // namespace gearwright
