// Computes a few numbers that describe the quality of the contact of a pair.
//
//   TE  transmission error (transmission.hpp)     N   frame of contact_pair.hpp
//   h   mean position of the contact along the face, from −1 to +1 in the direction of +z
//   q   mean position of the contact pattern along the face, −1 to 1
//   p   mean position of the contact along the profile, relative to a target; 0 without a target
//
// The touches are the points at which rigid teeth meet. If a flank without crowning has a slope
// error of a nanometre, its touches lie at an end of the face, although the whole face carries the
// load. In this case, h is ±1, and q is 0.
//                                 theory: docs/theory/08-contact.md, [T8.24]
#pragma once

#include <cmath>
#include <optional>
#include <vector>

#include "gearwright/base/angle.hpp"
#include "gearwright/base/units.hpp"
#include "gearwright/contact/transmission.hpp"

namespace gearwright {

/// A peak-to-peak transmission error below this limit is a rounding error.
inline constexpr double kNoAngle = 1e-9 * kRadPerArcsec;
inline double without_rounding(double v, double least) { return std::abs(v) < least ? 0.0 : v; }

struct ContactScore {
  Angle peak_to_peak;          ///< NaN if nothing touches at any position
  double along_face = 0.0;     ///< h
  double along_profile = 0.0;  ///< p; 0 without a target
  double edge_share = 0.0;     ///< fraction of the positions at which an edge touches; 0 to 1
  bool lost = false;           ///< true if contact is lost at some position
  /// Peak to peak of the continuous curve; none if contact is lost or if it was not computed.
  std::optional<Angle> span{};
  double pattern_middle = 0.0;  ///< q; 0 if q was not computed

  bool nothing_touches() const;
  Angle span_or_sampled() const { return span && !lost ? *span : peak_to_peak; }
};

/// The target for the position along the profile. If its width is 0, p is not computed.
struct ProfileTarget {
  Angle angle{};  ///< normal angle of the rack at which the contact should lie
  Angle width{};  ///< deviation from `angle` for which p is 1; 0 without a target
};

struct ContactCurve {
  std::vector<double> te;  ///< rad; NaN where contact is lost
  ContactScore score;
};

/// TE and score of a pair over one pitch.
///
/// Domain    positions ≥ 2 (contract)
/// Units     TE has its sign in the frame N
/// Accuracy  a peak to peak below 1e-9 arcsec is a rounding error and is set to 0. Values of h, q
///           and p below 1e-9 are also set to 0. `span` is as accurate as continuous_extremes(). q
///           is exact to 1 % if the gap is a parabola along the contact line
ContactCurve contact_curve(const ContactPair& pair, int positions, const ProfileTarget& target);

/// TE and score, computed from the touches of one pitch. TE has its sign in the frame N.
ContactCurve curve_of(Transmission& transmission, const std::vector<PairTouch>& touches,
                      const ProfileTarget& target);

/// Replaces each number of `worst` by the number of `score` if the latter is worse. Positions are
/// compared by magnitude and keep their sign. A pair without contact is worse than all others.
void take_worst(ContactScore& worst, const ContactScore& score);

}  // namespace gearwright
