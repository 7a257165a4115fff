// The quality of the contact of a pair, in the few numbers by which corrections are judged.
//
//   h   mean place of the contact along the face, −1 to 1      p   the same along the profile,
//       if it has a target          theory: docs/theory/08-contact.md, [T8.24]
#pragma once

#include <vector>

#include "gearwright/base/angle.hpp"
#include "gearwright/contact/transmission.hpp"

namespace gearwright {

struct ContactScore {
  Angle peak_to_peak;          ///< NaN if nothing touches at any position
  double along_face = 0.0;     ///< h
  double along_profile = 0.0;  ///< p; 0 without a target
  double edge_share = 0.0;     ///< fraction of the positions at which an edge touches; 0 to 1
  bool lost = false;           ///< true if contact is lost at some position

  bool nothing_touches() const;
};

/// The reference of p. Without a width there is no p.
struct ProfileTarget {
  Angle angle{};  ///< of the rack, at which the contact should lie
  Angle width{};  ///< the distance that counts as the end; 0 without a target
};

/// TE and score of a pair over one pitch.
struct ContactCurve {
  std::vector<double> te;  ///< rad, NaN where lost
  ContactScore score;      ///< edge_share is 0 if it was not requested
};

/// Domain    positions ≥ 2 (contract)
/// Accuracy  rounding errors are set to 0: a peak to peak below 1e-9 arcsec, places below 1e-9
ContactCurve contact_curve(const ContactPair& pair, int positions, const ProfileTarget& target,
                           bool edges);

/// The same curve, computed from touches over a pitch. TE is that of N.
ContactCurve curve_of(Transmission& transmission, const std::vector<PairTouch>& touches,
                      const ProfileTarget& target, bool edges);

/// The score of one pair over a pitch.
inline ContactScore score_of(const ContactPair& pair, int positions,
                             const ProfileTarget& target = {}) {
  return contact_curve(pair, positions, target, true).score;
}

/// Sets each number of `worst` to the worse of both. Places keep their sign, and a pair without any
/// contact is the worst.
void take_worst(ContactScore& worst, const ContactScore& score);

}  // namespace gearwright
