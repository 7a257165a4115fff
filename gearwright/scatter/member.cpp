#include "gearwright/scatter/member.hpp"

#include <algorithm>
#include <cmath>
#include <deque>
#include <memory>
#include <optional>

#include "gearwright/base/numbers.hpp"
#include "gearwright/contact/contact.hpp"
#include "gearwright/contact/continuous.hpp"
#include "gearwright/contact/halves.hpp"
#include "gearwright/contact/lane_track.hpp"
#include "gearwright/scatter/member_clearances.hpp"
#include "gearwright/scatter/uneven_teeth.hpp"

namespace gearwright {

namespace {

// True if the member differs from the nominal pair. The nominal pair is not searched in SIMD
// lanes, because its numbers must be equal to those of the verb `contact`.
bool deviates(const ContactSetup& drawn, const Deviation& deviation) {
  return deviation.modified || !(deviation.errors == drawn.place().errors);
}

}  // namespace

MemberSetup::MemberSetup(const ContactSetup& setup, const Deviation& deviation) : drawn_(setup) {
  if (!deviation.modified) return;
  auto made = setup.with_modifications(deviation.modifications);
  GW_EXPECTS(made);
  own_ = std::move(made).take();
}

double play_taken(const ContactSetup& setup, const std::array<double, 2>& thickness) {
  if (thickness[0] == 0.0 && thickness[1] == 0.0) return 0.0;
  const Gear& g2 = setup.gear(2);
  const double lever = std::abs(g2.base_radius()) * std::cos(g2.reference().base_helix_angle);
  double along_normal = 0.0;
  for (const int which : {1, 2}) {
    along_normal +=
        thickness[which - 1] * std::cos(setup.gear(which).spec.normal_pressure_angle.rad());
  }
  return along_normal / lever;
}

namespace {

// The touches of the working or the non-working flanks over a pitch, for a pair or for both halves
// of a double-helical pair. If both halves are equal, they are computed once.
class FlankTouches {
 public:
  // `lanes` permits the search in SIMD lanes. The touches that this search finds differ by
  // rounding from those of the verb `contact`.
  FlankTouches(const ContactSetup& setup, const ContactErrors& errors, const MemberRequest& request,
               bool gear2_drives, bool lanes) {
    if (request.stagger) {
      const HalvesPair both = HalvesSetup(setup, *request.stagger).pair(errors, gear2_drives);
      mesh_ = both.mesh;
      pairs_.assign(both.half.begin(), both.half.end() - (mesh_.alike() ? 1 : 0));
    } else {
      pairs_ = {setup.shared_pair(errors, gear2_drives)};
    }
    double first = -0.5 * pairs_[0]->pitch();
    for (const auto& pair : pairs_) {
      transmissions_.emplace_back(*pair);
      touches_.push_back(one_pitch(transmissions_.back(), first, request.positions,
                                   lanes && pairs_.size() == 1 ? &track_ : nullptr));
      if (pairs_.size() > 1) first += mesh_.behind().rad();
    }
  }

  double turned() const { return pairs_[0]->turned(); }
  // Returns TE in the frame N or, for a double-helical pair, the mean TE of both halves. Returns
  // none without contact.
  std::optional<double> te(std::size_t position) const {
    double sum = 0.0;
    for (const auto& touches : touches_) {
      if (!touches[position].found()) return std::nullopt;
      sum += touches[position].te();
    }
    return sum / static_cast<double>(touches_.size());
  }
  // Returns the score of the member. `along_face` and `along_profile` are each taken from the half
  // in which their magnitude is greater. `edge_share` is the mean of both halves.
  ContactScore score(const ProfileTarget& profile) {
    ContactScore worst;
    double edges = 0.0;
    for (std::size_t h = 0; h < touches_.size(); ++h) {
      const ContactScore s = curve_of(transmissions_[h], touches_[h], profile).score;
      take_worst(worst, s);
      edges += s.edge_share;
    }
    worst.edge_share = edges / static_cast<double>(touches_.size());
    return worst;
  }
  // Returns the peak to peak of the continuous curve, or none if contact is lost.
  std::optional<double> span() {
    for (std::size_t i = 0; i < touches_[0].size(); ++i)
      if (!te(i)) return std::nullopt;
    if (touches_.size() == 1) {
      if (track_) extremes_ = track_->extremes();
      if (!extremes_) extremes_ = continuous_extremes(transmissions_[0], touches_[0]);
      return without_rounding(extremes_->span(), kNoAngle);
    }
    const auto positions = static_cast<int>(touches_[0].size());
    const auto span = continuous_span(mesh_, positions);
    return span ? std::optional(without_rounding(span->rad(), kNoAngle)) : std::nullopt;
  }
  double long_period(const ContactSetup& setup, const Deviation& deviation) {
    const auto teeth = [&](int which) { return std::abs(setup.gear(which).spec.teeth); };
    return long_period_span(transmissions_[0], touches_[0], {teeth(1), teeth(2)}, deviation.pitch);
  }
  // Returns the derivative of span(), which must have been called before and must be > 0. The pair
  // must not be double-helical.
  double slope(const Influence& by) { return span_slope(transmissions_[0], *extremes_, by); }

 private:
  HalvesMesh mesh_;
  std::vector<std::shared_ptr<const ContactPair>> pairs_;
  std::deque<Transmission> transmissions_;
  std::vector<std::vector<PairTouch>> touches_;
  std::optional<detail::LaneTrack> track_;
  std::optional<CurveExtremes> extremes_;
};

}  // namespace

FamilyMember member_at(const ContactSetup& drawn, const Deviation& deviation,
                       const MemberRequest& request) {
  GW_EXPECTS(request.positions >= 2 && !(request.stagger && deviation.uneven_pitch()));
  using Q = ScatterQuantity;
  FamilyMember m;
  const auto set = [&](Q q, std::optional<double> value) {
    m.value[static_cast<std::size_t>(q)] = value;
  };
  const MemberSetup setup(drawn, deviation);
  const bool lanes = deviates(drawn, deviation);
  FlankTouches driving(*setup, deviation.errors, request, request.gear2_drives, lanes);
  const FlankTouches behind(*setup, deviation.errors, request, !request.gear2_drives, lanes);
  const double taken = play_taken(drawn, deviation.thickness);
  // A change of the tooth thickness is divided equally between the two flanks of the tooth.
  std::vector<double> te;
  double sum = 0.0;
  double least = kInfinity;
  for (int i = 0; i < request.positions; ++i) {
    const auto at = static_cast<std::size_t>(i);
    const auto driven = driving.te(at);
    if (!driven) continue;
    if (const auto back = behind.te(at)) least = std::min(least, -(*driven + *back) - taken);
    te.push_back(driving.turned() * (*driven + 0.5 * taken));
    sum += te.back();
  }
  if (std::isfinite(least)) set(Q::least_play, least);
  m.jam = std::isfinite(least) && jams(Angle::radians(least), drawn.gear(2));
  const ContactScore score = driving.score(request.profile);
  set(Q::edge_share, score.edge_share);
  const MemberClearances clearances = clearances_of(drawn, deviation);
  set(Q::tip_clearance1, clearances.tip[0]);
  set(Q::tip_clearance2, clearances.tip[1]);
  set(Q::form_clearance1, clearances.form[0]);
  set(Q::form_clearance2, clearances.form[1]);
  const auto span = driving.span();
  m.lost = !span;
  if (m.lost) return m;
  set(Q::along_face, score.along_face);
  if (request.profile.width > Angle()) set(Q::along_profile, score.along_profile);
  set(Q::peak_to_peak, span);
  if (deviation.uneven_pitch()) set(Q::long_period, driving.long_period(*setup, deviation));
  set(Q::mean, sum / static_cast<double>(te.size()));
  constexpr std::array<Q, 3> kHarmonics{Q::harmonic1, Q::harmonic2, Q::harmonic3};
  const auto waves = harmonics(te, static_cast<int>(kHarmonics.size()));
  for (std::size_t h = 0; h < waves.size(); ++h) set(kHarmonics[h], waves[h].rad());
  return m;
}

MemberSpan continuous_peak_to_peak(const ContactSetup& drawn, const Deviation& deviation,
                                   const MemberRequest& request,
                                   std::span<const Influence> influences) {
  GW_EXPECTS(influences.empty() || !request.stagger);
  const MemberSetup setup(drawn, deviation);
  FlankTouches driving(*setup, deviation.errors, request, request.gear2_drives,
                       deviates(drawn, deviation));
  MemberSpan span{driving.span(), {}};
  for (const Influence& by : influences)
    span.slope.push_back(span.value > 0.0 ? driving.slope(by) : 0.0);
  return span;
}

}  // namespace gearwright
