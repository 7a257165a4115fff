// Tooth contact analysis of a mounted pair with errors, over one pitch or more.
//
// The analysis uses four other files. gap_field.hpp computes the field T of two flanks, and
// touch.hpp finds the greatest T. transmission.hpp follows the tooth pairs over a pitch, and
// contact_point.hpp describes a touch.                    theory: docs/theory/08-contact.md
#pragma once

#include <vector>

#include "gearwright/contact/contact_point.hpp"
#include "gearwright/contact/sensitivity.hpp"

namespace gearwright {

namespace detail {
class LaneTrack;  // contact/lane_track.hpp
}

struct ContactRequest {
  int positions = 64;              ///< per pitch of gear 1, ≥ 2
  int pitches = 1;                 ///< length of the analysed range, ≥ 1
  double marking = 0.00635;        ///< δ  mm, thickness of the marking compound
  std::vector<Angle> rotations{};  ///< rotations of gear 1 to analyse; if empty, equal steps
  std::vector<Influence> influences{};
  Progress* progress = nullptr;
};

struct ContactResult {
  ContactResult() = default;  ///< empty; analyse_contact() fills it
  std::vector<ContactPoint> positions;
  /// The sensitivities [influence][position]; 0 if contact is lost.
  std::vector<std::vector<Sensitivity>> sensitivities;
  Angle peak_to_peak;            ///< of TE, over the positions with contact
  double mean_slope = 0.0;       ///< least squares slope of TE over rotation1, rad/rad
  std::vector<Angle> harmonics;  ///< of TE; empty if the request has rotations or contact is lost
  bool contact_lost = false;     ///< true if there is a position at which no tooth pair touches
  long unfinished = 0;           ///< number of searches that did not converge; normally 0
  RackTravel rack{};             ///< set if gear 2 is a rack
  TouchCount work;
};

/// Analyses the contact of the pair at the requested positions.
///
/// Domain    positions ≥ 2, pitches ≥ 1, marking > 0 (contract)
/// Accuracy  TE is exact to rounding; ledger rows `contact.*`
ContactResult analyse_contact(const ContactPair& pair, const ContactRequest& request);

/// Returns the play of gear 2 at one position. The play is the angle by which gear 2 can rotate
/// from contact of the working flanks to contact of the non-working flanks. It is negative if the
/// gears jam. Returns none if the working or the non-working flanks have no contact.
std::optional<Angle> play_between(const ContactPoint& working, const ContactPoint& non_working,
                                  bool gear2_drives);
/// Returns the least play_between() over all positions. Both results must have the same positions.
std::optional<Angle> least_play(const ContactResult& working, const ContactResult& non_working,
                                bool gear2_drives);
/// True if the gears jam at this least play. The condition is least_play · r cos β <=
/// −no_backlash(m_n), where r and β are the reference radius and the helix angle of `moved`. A
/// smaller overlap may result from rounding of the centre distance or of the profile shifts.
/// `moved` is gear 2, or the pinion if gear 2 is a rack.
///
/// Formula   the product of play and r cos β is the normal backlash at the reference cylinder,
///           j_n cos α_wn/cos α_n. It differs from j_n by at most 8 % (α_n = 20°, α_wn from 15° to
///           30°), so no_backlash(), a limit for j_n, also applies to the product
bool jams(Angle least_play, const Gear& moved);

/// Returns the touches at n positions over one pitch. At position i, the rotation of gear 1 in the
/// housing is `first` + i pitch/n. If `track` is not null, it receives the result of
/// LaneTrack::of(). If this result exists, its touches are returned.
std::vector<PairTouch> one_pitch(Transmission& transmission, double first, int n,
                                 std::optional<detail::LaneTrack>* track = nullptr);

/// Amplitudes of TE at the mesh frequency and its multiples. `te` contains the values of TE at
/// equal steps over one pitch. The result has at most `most` amplitudes, and fewer than half the
/// number of values.
///
/// Formula   [T8.18]
/// Domain    at least one value (contract)
std::vector<Angle> harmonics(const std::vector<double>& te, int most = 20);

/// Returns TE, in rad, at equal steps over the pitch that begins at −1/2 pitch. TE is NaN if
/// contact is lost.
std::vector<double> transmission_error(const ContactPair& pair, int positions);

/// Greatest minus least value; NaN if all values are NaN.
double peak_to_peak(const std::vector<double>& te);

/// Returns the greatest minus the least value of a TE in rad, or none if no position has contact.
std::optional<Angle> sampled_peak_to_peak(const std::vector<double>& te);

}  // namespace gearwright
