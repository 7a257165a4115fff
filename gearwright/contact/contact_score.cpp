#include "gearwright/contact/contact_score.hpp"

#include <algorithm>

#include "gearwright/base/contract.hpp"
#include "gearwright/base/numbers.hpp"
#include "gearwright/contact/contact.hpp"
#include "gearwright/contact/continuous.hpp"

namespace gearwright {

namespace {

constexpr double kNoPlace = 1e-9;  // magnitudes of h, p and q below this value are rounding errors

// The gap at which the density of the contact pattern is 1/e, mm. A small load closes such a gap.
constexpr double kPatternGap = 1e-3;

struct Interval {
  double lo, hi;
};
Interval face_of(const ContactPair& pair, int gear) {
  Interval face{kInfinity, -kInfinity};
  for (const FlankPatch& p : pair.patches(gear)) {
    face.lo = std::min(face.lo, p.z_lo);
    face.hi = std::max(face.hi, p.z_hi);
  }
  return face;
}

// Returns the middle of the contact pattern at one position, relative to the common part of the
// faces. The gap along the contact line is a parabola with the slope and the curvature of the gap
// field T at the touch. The middle is the mean height with the weight exp(−gap/kPatternGap).
double pattern_middle(Transmission& transmission, const PairTouch& t,
                      const std::array<Interval, 2>& faces) {
  const GapJet j = transmission.jet_at(t, t.touch.s, t.touch.z);
  const double arm = GapField::arm(j);
  const double along = j.t.ss < 0.0 ? -j.t.sz / j.t.ss : 0.0;  // ds/dz of the contact line
  const double slope = j.t.z + along * j.t.s;
  const double bend = std::min(0.0, j.t.zz + along * j.t.sz);
  const double moved = j.Z.v - t.touch.z;
  const double lo = std::max(faces[0].lo, faces[1].lo - moved);
  const double hi = std::min(faces[0].hi, faces[1].hi - moved);
  if (!(lo < hi)) return 0.0;
  constexpr int kParts = 32;
  double weight = 0.0, sum = 0.0;
  for (int i = 0; i < kParts; ++i) {
    const double place = (2.0 * i + 1.0) / kParts - 1.0;
    const double x = 0.5 * (lo + hi) + 0.5 * (hi - lo) * place - t.touch.z;
    const double gap = -arm * x * (slope + 0.5 * bend * x);
    const double w = std::exp(-std::max(0.0, gap) / kPatternGap);
    weight += w;
    sum += w * place;
  }
  return weight > 0.0 ? sum / weight : 0.0;
}

}  // namespace

bool ContactScore::nothing_touches() const { return std::isnan(peak_to_peak.rad()); }

ContactCurve contact_curve(const ContactPair& pair, int positions, const ProfileTarget& target) {
  GW_EXPECTS(positions >= 2);
  Transmission transmission(pair);
  auto touches = transmission.over_a_pitch(-0.5 * pair.pitch(), positions);
  ContactCurve c = curve_of(transmission, touches, target);
  const std::array<Interval, 2> faces{face_of(pair, 1), face_of(pair, 2)};
  double middle = 0.0;
  int n = 0;
  for (const PairTouch& t : touches) {
    if (!t.found()) continue;
    middle += pattern_middle(transmission, t, faces);
    ++n;
  }
  if (n > 0) c.score.pattern_middle = without_rounding(pair.turned() * middle / n, kNoPlace);
  if (c.score.lost) return c;
  if (pair.gear2_drives()) std::reverse(touches.begin(), touches.end());  // as in one_pitch()
  c.score.span =
      Angle::radians(without_rounding(continuous_extremes(transmission, touches).span(), kNoAngle));
  return c;
}

ContactCurve curve_of(Transmission& transmission, const std::vector<PairTouch>& touches,
                      const ProfileTarget& target) {
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
    // Every point of a contact line touches, so the touch has no definite position along the face.
    // Its height counts as 0.
    if (!t.touch.flat) height += transmission.pair().turned() * t.touch.z / z_half;
    if (target.width > Angle()) {
      const auto angle = transmission.field(t.fields).one().profile.rack_angle(t.touch.s);
      if (angle) profile += (*angle - target.angle.rad()) / target.width.rad();
    }
    if (on_edge(transmission, t)) ++edge_touches;
  }
  c.score.peak_to_peak = Angle::radians(without_rounding(peak_to_peak(c.te), kNoAngle));
  if (n == 0) return c;
  c.score.along_face = without_rounding(height / n, kNoPlace);
  c.score.along_profile = without_rounding(profile / n, kNoPlace);
  c.score.edge_share = static_cast<double>(edge_touches) / static_cast<double>(touches.size());
  return c;
}

void take_worst(ContactScore& worst, const ContactScore& s) {
  // std::max of NaN and a number depends on the order of its arguments, so NaN is set explicitly.
  if (s.nothing_touches() || worst.nothing_touches()) {
    worst.peak_to_peak = Angle::radians(kNoNumber);
  } else {
    worst.peak_to_peak = std::max(worst.peak_to_peak, s.peak_to_peak);
  }
  if (s.span) worst.span = std::max(worst.span.value_or(Angle()), *s.span);
  if (std::abs(s.along_face) > std::abs(worst.along_face)) worst.along_face = s.along_face;
  if (std::abs(s.pattern_middle) > std::abs(worst.pattern_middle))
    worst.pattern_middle = s.pattern_middle;
  if (std::abs(s.along_profile) > std::abs(worst.along_profile))
    worst.along_profile = s.along_profile;
  worst.edge_share = std::max(worst.edge_share, s.edge_share);
  worst.lost = worst.lost || s.lost;
}

}  // namespace gearwright
