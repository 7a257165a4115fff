// How good the contact of a pair is, in the few numbers that corrections are judged by.
//
//   h   mean place of the contact along the face, −1 to 1      p   the same along the profile,
//       where there is a target for it          theory: docs/theory/08-contact.md, [T8.24]
#pragma once

#include <vector>

#include "gearwright/base/angle.hpp"
#include "gearwright/contact/transmission.hpp"

namespace gearwright {

struct ContactScore {
  Angle peak_to_peak;          ///< NaN: nothing touches at any position
  double along_face = 0.0;     ///< h
  double along_profile = 0.0;  ///< p; 0 without a target
  double edge_share = 0.0;     ///< of the positions, at which an edge touches; 0 to 1
  bool lost = false;           ///< contact is lost somewhere

  bool nothing_touches() const;
};

/// What p is measured from. Without a width there is no p.
struct ProfileTarget {
  Angle angle{};  ///< of the rack, where the contact should lie
  Angle width{};  ///< what counts as the end; 0: no target
};

/// A pair over one pitch.
struct ContactCurve {
  std::vector<double> te;  ///< rad, NaN where lost
  ContactScore score;      ///< edge_share is left 0 where it is not asked for
};

/// Domain    positions ≥ 2 (contract)
/// Accuracy  what is rounding is 0: a peak to peak below 1e-9 arcsec, places below 1e-9
ContactCurve contact_curve(const ContactPair& pair, int positions, const ProfileTarget& target,
                           bool edges);

/// The same of touches over a pitch. TE is that of N.
ContactCurve curve_of(Transmission& transmission, const std::vector<PairTouch>& touches,
                      const ProfileTarget& target, bool edges);

/// Of one pair.
inline ContactScore score_of(const ContactPair& pair, int positions,
                             const ProfileTarget& target = {}) {
  return contact_curve(pair, positions, target, true).score;
}

/// Makes `worst` the worse of both, number by number: places keep their sign, a pair of which
/// nothing touches is the worst of all.
void take_worst(ContactScore& worst, const ContactScore& score);

}  // namespace gearwright
