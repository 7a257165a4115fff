#include "gearwright/contact/transmission.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "gearwright/base/numbers.hpp"
#include "gearwright/contact/wave_crests.hpp"

namespace gearwright {

namespace {

// A tooth pair is followed until its T decreases and is less than T of another pair by more than
// this limit, rad. T of a whole convex flank has only one maximum, so the limit is kBelow. With
// patches or concave flanks, another maximum may follow, so the limit is kFarBelow.
constexpr double kBelow = 1e-5;
constexpr double kFarBelow = 2e-3;

// If T of several pairs is equal within rounding, the pair nearest to the centre line is used.
constexpr double kTogether = 1e-13;  // rad

bool wins(const Touch& t, double phi, const PairTouch& best) {
  if (!best.found()) return true;
  const double ahead = t.te - best.touch.te;
  if (std::abs(ahead) > kTogether) return ahead > 0.0;
  return std::abs(phi) < std::abs(best.phi);
}

// Predicts the point of the next touch by the polynomial through the last four touches at equal
// steps. If the active bounds change, the path of the touches has a kink. Then only the touches
// after the change and one before it are used. Each additional order of the polynomial saves a step
// of the search.
class PlaceAhead {
 public:
  explicit PlaceAhead(const Touch& t) { add(t); }

  void add(const Touch& t) {
    if (!(t.active == active_)) count_ = std::min<std::size_t>(count_, 1);
    active_ = t.active;
    std::rotate(past_.begin(), past_.end() - 1, past_.end());
    past_[0] = {t.s, t.z};
    count_ = std::min(count_ + 1, past_.size());
  }
  std::array<double, 2> place() const {
    constexpr std::array<std::array<double, 4>, 4> kNext{
        {{1, 0, 0, 0}, {2, -1, 0, 0}, {3, -3, 1, 0}, {4, -6, 4, -1}}};
    std::array<double, 2> next{};
    for (std::size_t k = 0; k < count_; ++k)
      for (const std::size_t i : {0, 1}) next[i] += kNext[count_ - 1][k] * past_[k][i];
    return next;
  }

 private:
  std::array<std::array<double, 2>, 4> past_{};  // (s, z), the latest first
  std::size_t count_ = 0;
  detail::ActiveSet active_;
};

// True if no part of the flank is concave.
bool is_convex(const FlankPatch& f) {
  if (!f.removal || f.removal->none()) return true;
  if (f.removal->has_topography() || f.removal->wavy()) return false;
  using P = Modification;
  return f.removal->amount(P::profile_crowning) >= 0.0 &&
         f.removal->amount(P::lead_crowning) >= 0.0;
}

// Greatest angle from the mesh azimuth, rad, at which points of patch `one` can lie in the annulus
// of patch `two`. [T8.13]
double reach_of(const ContactPair& pair, const FlankPatch& one, const FlankPatch& two) {
  if (pair.place().axis_angle != Angle()) return pair.reach();
  const double a = pair.place().center_distance + pair.place().errors.center_distance;
  const double lo = std::exp(one.u_lo);
  const double hi = std::exp(one.u_hi);
  double least = 1.0;
  const auto take = [&](double rho1) {
    const double rho2 = std::exp(pair.internal() ? two.u_lo : two.u_hi);
    const double cosine = pair.is_rack() ? (a - pair.diameter(2, two.u_hi)) / rho1
                                         : (a * a + rho1 * rho1 - rho2 * rho2) / (2 * a * rho1);
    least = std::min(least, pair.internal() ? -cosine : cosine);
  };
  if (!(a > 0.0)) return pair.reach();
  take(lo);
  take(hi);
  const double rho2 = std::exp(two.u_hi);
  const double flattest = !pair.is_rack() && a > rho2 ? std::sqrt(a * a - rho2 * rho2) : 0.0;
  if (!pair.internal() && flattest > lo && flattest < hi) take(flattest);
  return std::acos(std::max(-1.0, least));
}

}  // namespace

Transmission::Transmission(const ContactPair& pair, Progress* progress)
    : pair_(pair), progress_(progress) {
  double widest = 0.0;
  for (const FlankPatch& a : pair.patches(1)) {
    widest = std::max(widest, std::abs(a.twist) * std::max(std::abs(a.z_lo), std::abs(a.z_hi)));
    for (const FlankPatch& b : pair.patches(2)) {
      fields_.push_back(std::make_unique<GapField>(pair.field(a, b)));
      searches_.push_back(std::make_unique<TouchSearch>(*fields_.back(), pair.mesh_azimuth(),
                                                        reach_of(pair, a, b)));
    }
  }
  for (const FlankPatch& a : pair.patches(1)) {
    for (const FlankPatch& b : pair.patches(2)) {
      auto crests = detail::WaveCrests::of(pair, a, b);
      if (crests) crests_.push_back(std::make_shared<const detail::WaveCrests>(*std::move(crests)));
    }
  }
  if (crests_.size() < fields_.size()) crests_.clear();
  farthest_pair_ = static_cast<int>(std::ceil((pair.reach() + widest) / pair.pitch())) + 2;
}

Touch Transmission::cold(int fields, double phi) {
  fields_[fields]->set_rotation(phi);
  const Touch t = searches_[fields]->cold();
  if (t.stop == Touch::Stop::too_long) ++too_long_;
  return t;
}

// Searches from a crest. If the search does not converge, the whole flank is searched.
Touch Transmission::from_crest(int fields, double s, double z) {
  const auto f = static_cast<std::size_t>(fields);
  const Touch t = searches_[f]->from(s, z, crests_[f]->s2(), {});
  return t.stop == Touch::Stop::too_long ? searches_[f]->cold() : t;
}

Touch Transmission::highest_crest(int fields, double phi) {
  const auto f = static_cast<std::size_t>(fields);
  auto crests = crests_[f]->at(phi, -kInfinity);
  std::sort(crests.begin(), crests.end(), [](const auto& a, const auto& b) { return a.te > b.te; });
  fields_[f]->set_rotation(phi);
  Touch best;
  for (const auto& c : crests) {
    if (best.found() && c.te < best.te - crests_[f]->margin()) break;
    const Touch t = from_crest(fields, c.s, c.z);
    if (t.found() && (!best.found() || t.te > best.te)) best = t;
  }
  return best;
}

PairTouch Transmission::at(double phi) {
  // Whole pitches change only the number of the tooth pair.
  const double whole = std::round(phi / pair_.pitch());
  phi -= whole * pair_.pitch();
  count_step(progress_);
  PairTouch best;
  // WaveCrests finds no crests far beyond the path of contact. If no tooth pair has a crest, a pair
  // beyond its path may still touch, so the whole flanks are searched.
  for (const bool of_crests : {true, false}) {
    if (of_crests && crests_.empty()) continue;
    if (best.found()) break;
    for (int f = 0; f < static_cast<int>(fields_.size()); ++f) {
      for (int k = -farthest_pair_; k <= farthest_pair_; ++k) {
        const double own = phi - k * pair_.pitch();
        const Touch t = of_crests ? highest_crest(f, own) : cold(f, own);
        if (t.found() && wins(t, own, best)) best = {t, f, own, k};
      }
    }
  }
  best.pair += static_cast<int>(whole);
  return best;
}

PairTouch Transmission::of_pair_0(double phi) {
  PairTouch best;
  for (int f = 0; f < static_cast<int>(fields_.size()); ++f) {
    const Touch t = wavy() ? highest_crest(f, phi) : cold(f, phi);
    if (t.found() && wins(t, phi, best)) best = {t, f, phi, 0};
  }
  return best;
}

PairTouch Transmission::follow(const PairTouch& from, double phi) {
  GW_EXPECTS(from.found());
  fields_[static_cast<std::size_t>(from.fields)]->set_rotation(phi);
  const Touch t =
      search(from.fields).from(from.touch.s, from.touch.z, from.touch.s2, from.touch.active);
  return {t, t.found() ? from.fields : -1, phi, from.pair};
}

std::vector<PairTouch> Transmission::every_of_pair_0(double phi) {
  std::vector<PairTouch> all;
  for (std::size_t f = 0; f < fields_.size(); ++f) {
    fields_[f]->set_rotation(phi);
    for (const Touch& t : searches_[f]->every_maximum())
      if (t.found()) all.push_back({t, static_cast<int>(f), phi, 0});
  }
  return all;
}

// Follows the touch of one pair of patches through the positions of tooth pair 0. For each position
// of a pitch, it records the touch with the greatest T in `best`.
class Transmission::Track {
 public:
  Track(Transmission& all, int fields, double first, int n, double below,
        std::vector<PairTouch>& best)
      : all_(all), fields_(fields), first_(first), n_(n), below_(below), best_(best) {}

  double own(int m) const { return first_ + m * (all_.pair_.pitch() / n_); }

  // Records a touch. Returns false if its T is well below T of another pair.
  bool offer(int m, const Touch& t) {
    // Position m of pair 0 is position i of pair k = (i − m)/n.
    const int i = ((m % n_) + n_) % n_;
    count_step(all_.progress_);
    PairTouch& b = best_[static_cast<std::size_t>(i)];
    if (wins(t, own(m), b)) b = {t, fields_, own(m), (i - m) / n_};
    return t.te >= b.touch.te - below_;
  }

  // Follows a touch from position m in one direction. The track ends if D is empty, if T decreases
  // and is well below T of another pair, or if `known` returns true because another track has
  // passed this touch.
  template <class Known>
  void walk(int m, const Touch& from, int direction, int most, bool cold_again, Known known) {
    GapField& field = *all_.fields_[static_cast<std::size_t>(fields_)];
    const TouchSearch& search = all_.search(fields_);
    const FlankPatch& a = field.one();
    Touch last = from;
    PlaceAhead ahead(from);
    while (std::abs(m) <= most) {
      m += direction;
      const auto [s, z] = ahead.place();
      field.set_rotation(own(m));
      Touch t = search.from(std::clamp(s, a.s_lo, a.s_hi), std::clamp(z, a.z_lo, a.z_hi), last.s2,
                            last.active);
      const bool lost = !t.found();
      if (lost && cold_again) t = all_.cold(fields_, own(m));
      if (!t.found() || known(m, t)) return;
      const bool near = offer(m, t);
      if (!near && t.te < last.te) return;
      if (lost) ahead = PlaceAhead(t);
      if (!lost) ahead.add(t);
      last = t;
    }
  }

 private:
  Transmission& all_;
  int fields_;
  double first_;
  int n_;
  double below_;
  std::vector<PairTouch>& best_;
};

// Follows the maximum of T on whole convex flanks, for which T has only one maximum and one
// interval of rotation.
void Transmission::follow_one(int fields, double first, int n, std::vector<PairTouch>& best) {
  Track track(*this, fields, first, n, kBelow, best);
  const int most = farthest_pair_ * n;
  const int stride = std::max(1, n / 4);
  for (int away = 0; away <= most; away += stride) {
    for (const int m : {away, -away}) {
      fields_[static_cast<std::size_t>(fields)]->set_rotation(track.own(m));
      const Touch t = searches_[static_cast<std::size_t>(fields)]->from_middle();
      if (!t.found()) continue;
      track.offer(m, t);
      const auto never = [](int, const Touch&) { return false; };
      // The direction in which T rises is followed first. The search in the other direction then
      // ends early if T is well below the values in the first direction.
      fields_[static_cast<std::size_t>(fields)]->set_rotation(track.own(m + 1));
      const Touch ahead =
          searches_[static_cast<std::size_t>(fields)]->from(t.s, t.z, t.s2, t.active);
      const int uphill = ahead.found() && ahead.te < t.te ? -1 : 1;
      for (const int direction : {uphill, -uphill}) track.walk(m, t, direction, most, true, never);
      return;
    }
  }
}

// Follows the maxima of T on flanks with several maxima and separate intervals of rotation. Cold
// starts at regular positions find the maxima. Each maximum is followed until it meets another
// track. On uneven flanks every position has a cold start, because a crest may touch only for a
// small part of a pitch.
void Transmission::follow_all(int fields, double first, int n, std::vector<PairTouch>& best) {
  Track track(*this, fields, first, n, kFarBelow, best);
  const int most = farthest_pair_ * n;
  const int stride = search(fields).uneven() ? 1 : std::max(1, n / 8);
  std::vector<std::vector<Touch>> passed(static_cast<std::size_t>(2 * (most + 1) + 1));
  const FlankPatch& a = fields_[static_cast<std::size_t>(fields)]->one();
  const auto known = [&](int m, const Touch& t) {
    constexpr double kSamePlace = 1e-5;  // greatest distance of equal touches, of the patch
    auto& here = passed[static_cast<std::size_t>(m + most + 1)];
    for (const Touch& p : here) {
      if (std::abs(p.s - t.s) <= kSamePlace * (a.s_hi - a.s_lo) &&
          std::abs(p.z - t.z) <= kSamePlace * (a.z_hi - a.z_lo))
        return true;
    }
    here.push_back(t);
    return false;
  };
  for (int m = -most; m <= most; m += stride) {
    fields_[static_cast<std::size_t>(fields)]->set_rotation(track.own(m));
    for (const Touch& t : searches_[static_cast<std::size_t>(fields)]->every_maximum()) {
      if (known(m, t)) continue;
      track.offer(m, t);
      for (const int direction : {1, -1}) track.walk(m, t, direction, most, false, known);
    }
  }
}

// Searches every position from the crests that may be the highest. The lines of contact of all
// tooth pairs are examined first, beginning near the centre line, where teeth usually touch.
void Transmission::over_crests(double first, int n, std::vector<PairTouch>& best) {
  struct Start {
    detail::WaveCrests::Crest crest;
    int fields, m;
  };
  const auto size = static_cast<std::size_t>(n);
  std::vector<std::vector<Start>> starts(size);
  std::vector<double> highest(size, -kInfinity);
  const int most = farthest_pair_ * n;
  for (int away = 0; away <= most; ++away) {
    for (const int m : {away, -away}) {
      if (m == 0 && away != 0) continue;
      const auto i = static_cast<std::size_t>(((m % n) + n) % n);
      const double own = first + m * (pair_.pitch() / n);
      for (int f = 0; f < static_cast<int>(crests_.size()); ++f) {
        const detail::WaveCrests& crests = *crests_[static_cast<std::size_t>(f)];
        for (const auto& c : crests.at(own, highest[i] - crests.margin())) {
          starts[i].push_back({c, f, m});
          highest[i] = std::max(highest[i], c.te);
        }
      }
      if (away == 0) break;
    }
  }
  for (std::size_t i = 0; i < size; ++i) {
    count_step(progress_);
    std::sort(starts[i].begin(), starts[i].end(),
              [](const Start& a, const Start& b) { return a.crest.te > b.crest.te; });
    for (const Start& s : starts[i]) {
      const auto f = static_cast<std::size_t>(s.fields);
      if (best[i].found() && s.crest.te < best[i].te() - crests_[f]->margin()) break;
      const double own = first + s.m * (pair_.pitch() / n);
      fields_[f]->set_rotation(own);
      const Touch t = from_crest(s.fields, s.crest.s, s.crest.z);
      if (t.found() && wins(t, own, best[i]))
        best[i] = {t, s.fields, own, (static_cast<int>(i) - s.m) / n};
    }
    // Far beyond the path of contact, T is less than WaveCrests estimates. Crests that were left
    // out because of too great an estimate of another crest may then be the highest.
    const bool astray = !best[i].found() || best[i].te() < highest[i] - crests_[0]->margin();
    if (astray) best[i] = at(first + static_cast<double>(i) * (pair_.pitch() / n));
  }
}

std::vector<PairTouch> Transmission::over_a_pitch(double first, int n) {
  const double whole = std::round(first / pair_.pitch());
  first -= whole * pair_.pitch();
  std::vector<PairTouch> best(n);
  if (!crests_.empty()) over_crests(first, n, best);
  const bool one =
      fields_.size() == 1 && is_convex(fields_[0]->one()) && is_convex(fields_[0]->two());
  for (int f = 0; f < static_cast<int>(fields_.size()) && crests_.empty(); ++f)
    one ? follow_one(f, first, n, best) : follow_all(f, first, n, best);
  for (PairTouch& t : best) t.pair += static_cast<int>(whole);
  return best;
}

GapJet Transmission::jet_at(const PairTouch& t, double s, double z) {
  GapField& field = *fields_[t.fields];
  field.set_rotation(t.phi);
  double s2 = t.touch.s2;
  const GapJet rough = field.at(s, z, s2);
  // The second evaluation starts with the exact parameter on flank 2.
  s2 = field.two().profile.s_of(rough.u.v, s2);
  return field.at(s, z, s2);
}

TouchCount Transmission::count() const {
  TouchCount sum;
  for (const auto& s : searches_) {
    sum.evaluations += s->count().evaluations;
    sum.searches += s->count().searches;
    sum.cold_starts += s->count().cold_starts;
  }
  return sum;
}

}  // namespace gearwright
