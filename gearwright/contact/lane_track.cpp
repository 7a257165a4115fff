#include "gearwright/contact/lane_track.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "gearwright/base/numbers.hpp"

namespace gearwright::detail {

namespace {

constexpr double kRough = 1e-7;  // rad, margin for comparing the gap field T of two tooth pairs

}  // namespace

// The line of contact of two involute gears on parallel axes. The centre distance is the only
// quantity that may have an error. At a fixed z, the roll angle s of the line changes by the angle
// through which gear 1 turns.
struct LaneTrack::Path {
  double phi_w, s_w, phi_s, phi_z;  // φ = φ_w + φ_s (s − s_w) + φ_z z
  double s_lo, s_hi, z_lo, z_hi;    // part of flank 1 that faces flank 2
  double phi_lo, phi_hi;
  bool open = false;

  explicit Path(const ContactPair& pair) {
    const auto &ones = pair.patches(1), &twos = pair.patches(2);
    const FlankPatch& one = ones.front();
    const Involute& involute = *one.profile.involute();
    const double r1 = involute.base_radius();
    const double r2 = twos.front().profile.involute()->base_radius();
    const double sign = pair.side();
    const double a = pair.place().center_distance + pair.place().errors.center_distance;
    const double square = a * a - (r2 + sign * r1) * (r2 + sign * r1);
    if (!(square > 0.0)) return;
    const double action = std::sqrt(square);
    double u_lo = kInfinity, u_hi = -kInfinity;
    s_lo = z_lo = kInfinity;
    s_hi = z_hi = -kInfinity;
    double z2_lo = kInfinity, z2_hi = -kInfinity;
    for (const FlankPatch& p : ones) {
      s_lo = std::min(s_lo, p.s_lo);
      s_hi = std::max(s_hi, p.s_hi);
      z_lo = std::min(z_lo, p.z_lo);
      z_hi = std::max(z_hi, p.z_hi);
    }
    for (const FlankPatch& p : twos) {
      u_lo = std::min(u_lo, p.u_lo);
      u_hi = std::max(u_hi, p.u_hi);
      z2_lo = std::min(z2_lo, p.z_lo - pair.mount().shift.r.z());
      z2_hi = std::max(z2_hi, p.z_hi - pair.mount().shift.r.z());
    }
    z_lo = std::max(z_lo, z2_lo);
    z_hi = std::min(z_hi, z2_hi);
    const auto opposite = [&](double u) {
      return sign * (action - std::sqrt(std::max(0.0, std::exp(2 * u) - r2 * r2))) / r1;
    };
    const auto [from, to] = std::minmax({opposite(u_lo), opposite(u_hi)});
    s_lo = std::max(s_lo, from);
    s_hi = std::min(s_hi, to);
    if (!(s_lo < s_hi && z_lo < z_hi)) return;
    s_w = action / (r2 + sign * r1);
    const double azimuth = std::atan(one.profile.side() * s_w) +
                           one.profile.side() * (involute.base_half_angle() - s_w);
    phi_w = (pair.mesh_azimuth() - azimuth - one.center) / pair.rotation_sign();
    phi_s = pair.rotation_sign() * one.profile.side();
    phi_z = -one.twist / pair.rotation_sign();
    phi_lo = kInfinity;
    phi_hi = -kInfinity;
    for (const double s : {s_lo, s_hi}) {
      for (const double z : {z_lo, z_hi}) {
        phi_lo = std::min(phi_lo, phi_w + phi_s * (s - s_w) + phi_z * z);
        phi_hi = std::max(phi_hi, phi_w + phi_s * (s - s_w) + phi_z * z);
      }
    }
    open = true;
  }

  // Returns the middle of the line of contact, or none outside the path of contact.
  std::optional<std::array<double, 2>> middle(double phi) const {
    double a = s_lo, b = s_hi;
    if (phi_z != 0.0) {
      const double c = s_w + (phi - phi_w - phi_z * z_lo) / phi_s;
      const double d = s_w + (phi - phi_w - phi_z * z_hi) / phi_s;
      a = std::max(a, std::min(c, d));
      b = std::min(b, std::max(c, d));
      if (!(a < b)) return std::nullopt;
      const double s = 0.5 * (a + b);
      return std::array{s, (phi - phi_w - phi_s * (s - s_w)) / phi_z};
    }
    const double s = s_w + (phi - phi_w) / phi_s;
    if (!(s > a && s < b)) return std::nullopt;
    return std::array{s, 0.5 * (z_lo + z_hi)};
  }
};

// Touches of tooth pair 0 at the positions `from`, `from` + `stride`, `from` + 2 `stride`, …
struct LaneTrack::Rough {
  int from, stride;
  std::vector<PairTouch> touches;  // touches of failed searches are not found()

  // The touch with number k, or at position m; null if it was not found.
  const PairTouch* at(int k) const {
    const auto i = static_cast<std::size_t>(k);
    return k >= 0 && i < touches.size() && touches[i].found() ? &touches[i] : nullptr;
  }
  const PairTouch* at_position(int m) const {
    return (m - from) % stride == 0 ? at((m - from) / stride) : nullptr;
  }
};

LaneTrack::LaneTrack(Transmission& transmission, const LaneSearch& search, double first, int n)
    : transmission_(&transmission),
      search_(search),
      first_(first),
      step_(transmission.pair().pitch() / n),
      n_(n),
      best_(static_cast<std::size_t>(n)) {}

std::optional<LaneTrack> LaneTrack::of(Transmission& transmission, double first, int n) {
  const ContactPair& pair = transmission.pair();
  if (!transmission.convex_ || pair.place().axis_angle != Angle()) return std::nullopt;
  const auto search = LaneSearch::of(transmission);
  if (!search) return std::nullopt;
  const Path path(pair);
  if (!path.open) return std::nullopt;
  const double whole = std::round(first / pair.pitch());
  LaneTrack track(transmission, *search, first - whole * pair.pitch(), n);
  const Rough rough = track.search_path(path);
  const auto window = track.window_of(rough);
  if (!window) return std::nullopt;
  track.search_window(rough, *window);
  for (const int direction : {-1, 1}) track.extend(direction);
  for (const PairTouch& t : track.best_)
    if (!t.found()) return std::nullopt;
  track.whole_ = static_cast<int>(whole);
  for (PairTouch& t : track.best_) t.pair += track.whole_;
  return track;
}

const PairTouch* LaneTrack::at(int m) const {
  const auto i = static_cast<std::size_t>(m - lo_);
  return m >= lo_ && i < track_.size() && track_[i].found() ? &track_[i] : nullptr;
}

void LaneTrack::offer(int m, const PairTouch& t) {
  const int i = ((m % n_) + n_) % n_;
  PairTouch& b = best_[static_cast<std::size_t>(i)];
  if (!wins(t.touch, own(m), b)) return;
  b = t;
  b.pair = (i - m) / n_;
}

// Returns the start of a search between a and b, at the fraction `part` of their distance.
PairTouch LaneTrack::start_between(const PairTouch& a, const PairTouch& b, double part,
                                   double phi) const {
  PairTouch t = part < 0.5 ? a : b;
  if (a.fields == b.fields && a.touch.active == b.touch.active) {
    t.touch.s = a.touch.s + part * (b.touch.s - a.touch.s);
    t.touch.z = a.touch.z + part * (b.touch.z - a.touch.z);
  }
  t.phi = phi;
  return t;
}

// Moves touches across the borders of patches, like Transmission::climb(). On convex flanks, a
// touch has the greatest T if no pair of patches beyond an active border has a greater T.
void LaneTrack::cross_seams(std::vector<PairTouch>& touches) const {
  const auto& across = transmission_->across_;
  if (across.size() < 2) return;
  std::vector<int> before(touches.size(), -1);
  for (std::size_t pass = 0; pass < 2 * across.size(); ++pass) {
    std::vector<PairTouch> beyond;
    std::vector<std::size_t> of;
    for (std::size_t i = 0; i < touches.size(); ++i) {
      const PairTouch& t = touches[i];
      if (!t.found() || before[i] == t.fields) continue;
      for (const int bound : {t.touch.active.first, t.touch.active.second}) {
        const int next =
            bound < 0 ? -1
                      : across[static_cast<std::size_t>(t.fields)][static_cast<std::size_t>(bound)];
        if (next < 0 || next == before[i]) continue;
        PairTouch& start = beyond.emplace_back(touches[i]);
        start.fields = next;
        start.touch.active = {static_cast<std::int8_t>(bound ^ 1), -1};
        of.push_back(i);
      }
      before[i] = t.fields;
    }
    if (beyond.empty()) return;
    search_.solve(beyond);
    for (std::size_t k = 0; k < beyond.size(); ++k) {
      PairTouch& best = touches[of[k]];
      const PairTouch& t = beyond[k];
      const double ahead = t.found() ? t.te() - best.te() : -kInfinity;
      if (ahead > kTogether || (ahead > -kTogether && t.fields < best.fields)) best = beyond[k];
    }
  }
}

LaneTrack::Rough LaneTrack::search_path(const Path& path) const {
  const auto position = [&](double phi) {
    return static_cast<int>(std::floor((phi - first_) / step_));
  };
  Rough rough{position(path.phi_lo) + 1, std::max(1, n_ / 8), {}};
  const int count = std::max(0, (position(path.phi_hi) - rough.from) / rough.stride + 1);
  const int largest = transmission_->largest_first().front();
  std::vector<PairTouch> starts;
  starts.reserve(static_cast<std::size_t>(count));
  for (int k = 0; k < count; ++k) {
    const double phi = own(rough.from + k * rough.stride);
    const auto place = path.middle(phi);
    if (!place) continue;
    PairTouch& t = starts.emplace_back();
    t.phi = phi;
    t.fields = largest;
    t.pair = k;
    t.touch.s = (*place)[0];
    t.touch.z = (*place)[1];
  }
  search_.solve(starts);
  cross_seams(starts);
  rough.touches.resize(static_cast<std::size_t>(count));
  for (PairTouch& t : starts) rough.touches[static_cast<std::size_t>(std::exchange(t.pair, 0))] = t;
  return rough;
}

// Returns the first and the last position at which T of pair 0 may be greater than T of all other
// pairs. Returns none if there is no such position.
std::optional<std::array<int, 2>> LaneTrack::window_of(const Rough& rough) const {
  // The lower and the upper limit of T at every position. The slopes at two neighbouring touches
  // limit the distance of T from the straight line between these touches.
  const int all = (static_cast<int>(rough.touches.size()) - 1) * rough.stride + 1;
  std::vector<std::array<double, 2>> limits(static_cast<std::size_t>(std::max(0, all)),
                                            {-kInfinity, -kInfinity});
  for (int k = 0; k * rough.stride < all; ++k) {
    const PairTouch *a = rough.at(k), *b = rough.at(k + 1);
    if (!a || !b) continue;
    const double rise = b->te() - a->te(), width = rough.stride * step_;
    const double aside =
        (std::abs(rise - a->touch.slope * width) + std::abs(rise - b->touch.slope * width)) / 4;
    for (int i = 0; i <= rough.stride; ++i) {
      const double te = a->te() + i * rise / rough.stride;
      limits[static_cast<std::size_t>(k * rough.stride + i)] = {te - aside - kRough,
                                                                te + aside + kRough};
    }
  }
  std::optional<std::array<int, 2>> window;
  for (int i = 0; i < all; ++i) {
    double other = -kInfinity;
    for (int k = i % n_; k < all; k += n_)
      if (k != i) other = std::max(other, limits[static_cast<std::size_t>(k)][0]);
    const double most = limits[static_cast<std::size_t>(i)][1];
    if (most == -kInfinity || most < other) continue;
    if (!window) window = {rough.from + i, 0};
    (*window)[1] = rough.from + i;
  }
  return window;
}

// Returns the touch from which the search at position m starts. Its s and z come from the cubic
// through four rough touches around m if these touches have the same active bounds. Otherwise, they
// come from the two nearest rough touches. Without such touches, the result is not found().
PairTouch LaneTrack::start_at(int m, const Rough& rough) const {
  const int last = static_cast<int>(rough.touches.size()) - 1;
  const int k = std::clamp((m - rough.from) / rough.stride, 0, last);
  const double part = static_cast<double>(m - rough.from - k * rough.stride) / rough.stride;
  const PairTouch *a = rough.at(k), *b = rough.at(k + 1);
  if (!a && !b) return {};
  PairTouch t = start_between(a ? *a : *b, b ? *b : *a, part, own(m));
  const PairTouch *c = rough.at(k - 1), *d = rough.at(k + 2);
  const auto like = [&](const PairTouch* x) {
    return x && x->fields == t.fields && x->touch.active == t.touch.active;
  };
  if (!like(a) || !like(b) || !like(c) || !like(d)) return t;
  const double p = part, q = 1 - part;
  const std::array<double, 4> weight{-p * q * (1 + q) / 6, q * (1 + p) * (1 + q) / 2,
                                     p * (1 + p) * (1 + q) / 2, -p * q * (1 + p) / 6};
  const auto mix = [&](double Touch::*v) {
    return weight[0] * c->touch.*v + weight[1] * a->touch.*v + weight[2] * b->touch.*v +
           weight[3] * d->touch.*v;
  };
  t.touch.s = mix(&Touch::s);
  t.touch.z = mix(&Touch::z);
  return t;
}

// Searches every position of the window, and one more position beyond each end.
void LaneTrack::search_window(const Rough& rough, const std::array<int, 2>& window) {
  lo_ = window[0] - 1;
  track_.resize(static_cast<std::size_t>(window[1] + 1 - lo_ + 1));
  std::vector<PairTouch> fine;
  fine.reserve(track_.size());
  for (int m = lo_; m <= window[1] + 1; ++m) {
    const PairTouch* known = rough.at_position(m);
    if (known) track_[static_cast<std::size_t>(m - lo_)] = *known;
    PairTouch start = known ? PairTouch() : start_at(m, rough);
    if (!start.found()) continue;
    start.pair = m;
    fine.push_back(start);
  }
  search_.solve(fine);
  cross_seams(fine);
  for (PairTouch& t : fine) track_[static_cast<std::size_t>(std::exchange(t.pair, 0) - lo_)] = t;
  for (std::size_t i = 0; i < track_.size(); ++i)
    if (track_[i].found()) offer(lo_ + static_cast<int>(i), track_[i]);
}

// Continues the track of a tooth pair in one direction. The track ends, as in Transmission, when T
// of this tooth pair decreases from one position to the next. T must then also be more than kRough
// below the greatest T of all tooth pairs at that position.
void LaneTrack::extend(int direction) {
  const int most = transmission_->farthest_pair_ * n_;
  const int last = direction > 0 ? lo_ + static_cast<int>(track_.size()) - 1 : lo_;
  int m = last;
  while (m != last - direction * static_cast<int>(track_.size()) && !at(m)) m -= direction;
  if (!at(m)) return;
  PairTouch here = *at(m);
  const PairTouch* inner = at(m - direction);
  double before = inner ? inner->te() : kInfinity;
  while (std::abs(m) <= most) {
    const int i = ((m % n_) + n_) % n_;
    if (here.te() < best_[static_cast<std::size_t>(i)].te() - kRough && here.te() < before) return;
    before = here.te();
    m += direction;
    here = transmission_->climb(here, own(m));
    if (!here.found()) return;
    offer(m, here);
  }
}

}  // namespace gearwright::detail
