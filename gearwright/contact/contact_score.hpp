// A few numbers that describe the quality of the contact of a pair. Corrections improve them.
//
//   TE  transmission error (transmission.hpp)     N   frame of contact_pair.hpp
//   h   mean position of the contact along the face, −1 to 1, towards +z
//   p   mean position of the contact along the profile, relative to a target; 0 without a target
//                                 theory: docs/theory/08-contact.md, [T8.24]
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

/// The target for the position along the profile. If its width is 0, p is not computed.
struct ProfileTarget {
  Angle angle{};  ///< normal angle of the rack at which the contact should lie
  Angle width{};  ///< deviation from `angle` for which p is 1; 0 without a target
};

/// TE and score of a pair over one pitch.
struct ContactCurve {
  std::vector<double> te;  ///< rad; NaN where contact is lost
  ContactScore score;      ///< edge_share is 0 if contact_curve() got `edges` = false
};

/// TE and score of a pair over one pitch. edge_share is computed only if `edges` is true.
///
/// Domain    positions ≥ 2 (contract)
/// Accuracy  a peak to peak below 1e-9 arcsec is a rounding error and is set to 0, and so are h and
///           p below 1e-9
ContactCurve contact_curve(const ContactPair& pair, int positions, const ProfileTarget& target,
                           bool edges);

/// TE and score, computed from the touches of one pitch. TE has the sign that it has in N.
ContactCurve curve_of(Transmission& transmission, const std::vector<PairTouch>& touches,
                      const ProfileTarget& target, bool edges);

/// The score of one pair over a pitch.
inline ContactScore score_of(const ContactPair& pair, int positions,
                             const ProfileTarget& target = {}) {
  return contact_curve(pair, positions, target, true).score;
}

/// Sets each number of `worst` to the same number of `score` if this is worse. Positions are
/// compared by magnitude and keep their sign. A pair without any contact is worse than all others.
void take_worst(ContactScore& worst, const ContactScore& score);

}  // namespace gearwright
