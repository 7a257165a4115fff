#include "gearwright/scatter/member.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "gearwright/base/units.hpp"
#include "gearwright/contact/contact.hpp"
#include "gearwright/contact/continuous.hpp"
#include "gearwright/contact/halves.hpp"
#include "gearwright/scatter/long_period.hpp"

namespace gearwright {

namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kTouching = 1e-12;                // rad; a play of −1e-12 is a rounding error
constexpr double kNoAngle = 1e-9 * kRadPerArcsec;  // a smaller peak to peak is the rounding error
                                                   // of 0

double without_rounding(double span) { return span < kNoAngle ? 0.0 : span; }

}  // namespace

MemberSetup::MemberSetup(const ContactSetup& setup, const Deviation& deviation) : drawn_(setup) {
  if (!deviation.modified) return;
  auto made = setup.with_modifications(deviation.modifications);
  GW_EXPECTS(made);
  own_ = std::move(made).take();
}

bool FamilyMember::jams() const { return (*this)[ScatterQuantity::least_play] < -kTouching; }

double play_taken(const ContactSetup& setup, const std::array<double, 2>& thickness) {
  if (thickness[0] == 0.0 && thickness[1] == 0.0) return 0.0;
  const Gear& g2 = setup.gear(2);
  GW_EXPECTS(setup.gear(1).involute() && g2.involute());
  const double lever = std::abs(g2.base_radius()) * std::cos(g2.reference().base_helix_angle);
  double along_normal = 0.0;
  for (const int which : {1, 2}) {
    along_normal += thickness[static_cast<std::size_t>(which - 1)] *
                    std::cos(setup.gear(which).spec.normal_pressure_angle.rad());
  }
  return along_normal / lever;
}

namespace {

// The contact of both halves of a double-helical pair, driven by one of its gears, and of the whole gears.
struct HalvesContact {
  std::array<ContactResult, 2> half;  // of half A, and of the mirror image of half B
  ContactResult whole;
  std::optional<Angle> span;

  HalvesContact(const ContactSetup& setup, const ContactErrors& errors, double stagger,
                bool gear2_drives, int positions) {
    const std::array middles{middle_of_half(setup.gear(1)), middle_of_half(setup.gear(2))};
    const ContactSetup one = setup.half_at(middles, false), image = setup.half_at(middles, true);
    const ContactPair a = one.pair(errors, gear2_drives);
    const ContactPair b = image.pair(mirrored(errors), gear2_drives);
    const HalvesMesh mesh{&one.gear(1), {&a, &b}, stagger};
    ContactRequest request;
    request.positions = positions;
    half[0] = analyse_contact(a, request);
    request.rotations = rotations_of_second(one.gear(1), stagger, {}, positions, 1);
    half[1] = analyse_contact(b, request);
    const ContactResult second = second_half(mesh, half[1], {}, positions);
    whole = whole_contact(mesh, {&half[0], &second}, positions).result;
    if (!whole.contact_lost) span = continuous_span(mesh, std::max(kLeastSpanPositions, positions));
  }

  double edge_share() const {
    double edges = 0.0;
    for (const ContactResult& r : half)
      edges += static_cast<double>(std::count_if(
          r.positions.begin(), r.positions.end(),
          [](const ContactPoint& p) { return p.kind != TouchKind::none && is_edge(p.kind); }));
    return edges / (2.0 * static_cast<double>(whole.positions.size()));
  }

  // The greater mean place of the two halves, relative to half the width of a face.
  double along_face(double face_width) const {
    double farthest = 0.0;
    for (const ContactResult& r : half) {
      double sum = 0.0;
      for (const ContactPoint& p : r.positions)
        if (p.kind != TouchKind::line) sum += p.height[0] / (face_width / 2);
      const double place = sum / static_cast<double>(r.positions.size());
      if (std::abs(place) > std::abs(farthest)) farthest = place;
    }
    return farthest;
  }
};

FamilyMember member_of_halves(const ContactSetup& drawn, const Deviation& deviation,
                              const MemberRequest& request) {
  using Q = ScatterQuantity;
  FamilyMember m;
  m.value.fill(kNan);
  const auto set = [&](Q q, double value) { m.value[static_cast<std::size_t>(q)] = value; };
  const MemberSetup setup(drawn, deviation);
  const auto contact = [&](bool gear2_drives) {
    return HalvesContact(*setup, deviation.errors, *request.stagger, gear2_drives,
                         request.positions);
  };
  const HalvesContact driving = contact(request.gear2_drives);
  const HalvesContact behind = contact(!request.gear2_drives);
  const double taken = play_taken(drawn, deviation.thickness);
  if (const auto play = least_play(driving.whole, behind.whole, request.gear2_drives))
    set(Q::least_play, play->rad() - taken);
  set(Q::edge_share, driving.edge_share());
  m.lost = driving.whole.contact_lost || !driving.span;
  if (m.lost) return m;
  set(Q::along_face, driving.along_face((*setup).gear(1).spec.face_width));
  set(Q::peak_to_peak, without_rounding(driving.span->rad()));
  double sum = 0.0;
  for (const ContactPoint& p : driving.whole.positions) sum += p.te.rad();
  // Each flank of a tooth takes half of the change of its thickness.
  const double forward = request.gear2_drives ? -1.0 : 1.0;
  set(Q::mean, sum / request.positions + forward * 0.5 * taken);
  constexpr std::array<Q, 3> kHarmonics{Q::harmonic1, Q::harmonic2, Q::harmonic3};
  for (std::size_t h = 0; h < std::min(driving.whole.harmonics.size(), kHarmonics.size()); ++h)
    set(kHarmonics[h], driving.whole.harmonics[h].rad());
  return m;
}

}  // namespace

FamilyMember member_at(const ContactSetup& drawn, const Deviation& deviation,
                       const MemberRequest& request) {
  GW_EXPECTS(request.positions >= 2);
  if (request.stagger) return member_of_halves(drawn, deviation, request);
  using Q = ScatterQuantity;
  FamilyMember m;
  m.value.fill(kNan);
  const auto set = [&](Q q, double value) { m.value[static_cast<std::size_t>(q)] = value; };
  const MemberSetup setup(drawn, deviation);
  const ContactPair driving = (*setup).pair(deviation.errors, request.gear2_drives);
  const ContactPair behind = (*setup).pair(deviation.errors, !request.gear2_drives);
  Transmission transmission(driving);
  Transmission other(behind);
  const double first = -0.5 * driving.pitch();
  const auto touches = one_pitch(transmission, first, request.positions);
  const auto other_touches = one_pitch(other, first, request.positions);
  const double taken = play_taken(drawn, deviation.thickness);
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < touches.size(); ++i) {
    if (!touches[i].found() || !other_touches[i].found()) continue;
    least = std::min(least, -(touches[i].te() + other_touches[i].te()) - taken);
  }
  if (std::isfinite(least)) set(Q::least_play, least);
  const ContactCurve curve = curve_of(transmission, touches, request.profile, true);
  set(Q::edge_share, curve.score.edge_share);
  m.lost = curve.score.lost;
  if (m.lost) return m;
  set(Q::along_face, curve.score.along_face);
  if (request.profile.width > Angle()) set(Q::along_profile, curve.score.along_profile);
  set(Q::peak_to_peak, without_rounding(continuous_extremes(transmission, touches).span()));
  if (deviation.uneven_pitch()) {
    const auto teeth = [&](int which) { return std::abs((*setup).gear(which).spec.teeth); };
    set(Q::long_period,
        long_period_span(transmission, touches, {teeth(1), teeth(2)}, deviation.pitch));
  }
  // A change of the tooth thickness is divided equally between the two flanks of the tooth.
  std::vector<double> te;
  double sum = 0.0;
  for (const double t : curve.te) {
    te.push_back(driving.turned() * (t + 0.5 * taken));
    sum += te.back();
  }
  set(Q::mean, sum / static_cast<double>(te.size()));
  const auto waves = harmonics(te);
  constexpr std::array<Q, 3> kHarmonics{Q::harmonic1, Q::harmonic2, Q::harmonic3};
  for (std::size_t h = 0; h < std::min(waves.size(), kHarmonics.size()); ++h)
    set(kHarmonics[h], waves[h].rad());
  return m;
}

MemberSpan continuous_peak_to_peak(const ContactSetup& drawn, const Deviation& deviation,
                                   const MemberRequest& request,
                                   std::span<const Influence> influences) {
  const MemberSetup setup(drawn, deviation);
  const ContactPair driving = (*setup).pair(deviation.errors, request.gear2_drives);
  Transmission transmission(driving);
  const auto touches = one_pitch(transmission, -0.5 * driving.pitch(), request.positions);
  for (const PairTouch& t : touches)
    if (!t.found()) return {kNan, std::vector<double>(influences.size(), 0.0)};
  const CurveExtremes extremes = continuous_extremes(transmission, touches);
  MemberSpan span{without_rounding(extremes.span()), {}};
  for (const Influence& i : influences)
    span.slope.push_back(span.value > 0.0 ? span_slope(transmission, extremes, i) : 0.0);
  return span;
}

}  // namespace gearwright
