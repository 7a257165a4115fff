#include "gearwright/contact/contact_score.hpp"

#include <algorithm>
#include <cmath>

#include "gearwright/base/contract.hpp"
#include "gearwright/base/numbers.hpp"
#include "gearwright/base/units.hpp"
#include "gearwright/contact/contact.hpp"

namespace gearwright {

namespace {

// Angles (peak to peak) and mean positions (h, p) below these limits are rounding errors.
constexpr double kNoAngle = 1e-9 * kRadPerArcsec;
constexpr double kNoPlace = 1e-9;

double without_rounding(double v, double least) { return std::abs(v) < least ? 0.0 : v; }

}  // namespace

bool ContactScore::nothing_touches() const { return std::isnan(peak_to_peak.rad()); }

ContactCurve contact_curve(const ContactPair& pair, int positions, const ProfileTarget& target,
                           bool edges) {
  GW_EXPECTS(positions >= 2);
  Transmission transmission(pair);
  return curve_of(transmission, transmission.over_a_pitch(-0.5 * pair.pitch(), positions), target,
                  edges);
}

ContactCurve curve_of(Transmission& transmission, const std::vector<PairTouch>& touches,
                      const ProfileTarget& target, bool edges) {
  ContactCurve c;
  double z_half = 0.0;
  for (const FlankPatch& p : transmission.pair().patches(1))
    z_half = std::max({z_half, std::abs(p.z_lo), std::abs(p.z_hi)});
  double height = 0.0;
  double profile = 0.0;
  int edge_touches = 0;
  int n = 0;
  for (const PairTouch& t : touches) {
    if (!t.found()) {
      c.score.lost = true;
      c.te.push_back(kNoNumber);
      continue;
    }
    c.te.push_back(t.te());
    ++n;
    // On a contact line every point touches, so the touch has no definite position along the face.
    if (!t.touch.flat) height += transmission.pair().turned() * t.touch.z / z_half;
    if (target.width > Angle()) {
      const auto angle = transmission.field(t.fields).one().profile.rack_angle(t.touch.s);
      if (angle) profile += (*angle - target.angle.rad()) / target.width.rad();
    }
    if (edges && on_edge(transmission, t)) ++edge_touches;
  }
  c.score.peak_to_peak = Angle::radians(without_rounding(peak_to_peak(c.te), kNoAngle));
  if (n == 0) return c;
  c.score.along_face = without_rounding(height / n, kNoPlace);
  c.score.along_profile = without_rounding(profile / n, kNoPlace);
  c.score.edge_share = static_cast<double>(edge_touches) / static_cast<double>(touches.size());
  return c;
}

void take_worst(ContactScore& worst, const ContactScore& s) {
  // NaN is set explicitly, because std::max of NaN and a number depends on their order.
  if (s.nothing_touches() || worst.nothing_touches()) {
    worst.peak_to_peak = Angle::radians(kNoNumber);
  } else {
    worst.peak_to_peak = std::max(worst.peak_to_peak, s.peak_to_peak);
  }
  if (std::abs(s.along_face) > std::abs(worst.along_face)) worst.along_face = s.along_face;
  if (std::abs(s.along_profile) > std::abs(worst.along_profile))
    worst.along_profile = s.along_profile;
  worst.edge_share = std::max(worst.edge_share, s.edge_share);
  worst.lost = worst.lost || s.lost;
}

}  // namespace gearwright
