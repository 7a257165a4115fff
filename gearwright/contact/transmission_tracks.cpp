// Computes the touches over a pitch. One tooth pair is followed through its positions.
#include <algorithm>
#include <array>
#include <cmath>

#include "gearwright/contact/transmission.hpp"

namespace gearwright {

namespace {

// A tooth pair is followed until its gap field T decreases and is below T of another pair by more
// than a limit, rad. On convex flanks, T has only one maximum, and the limit is kBelow. On other
// flanks, another maximum may follow, and the limit is kFarBelow.
constexpr double kBelow = 1e-5;
constexpr double kFarBelow = 2e-3;

// Predicts the point of the next touch by the polynomial through the last four touches at equal
// steps. If the active bounds change, the path of the touches has a kink. In this case, the
// polynomial uses only the touches after the change and one touch before the change. Each
// additional order of the polynomial saves a step of the search.
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

}  // namespace

// Returns the touch with the greatest T of a convex flank at φ. The search starts at `from`, which
// is a touch or a point near one. T over the flank is concave. A touch therefore has the greatest T
// if no pair of patches beyond an active border has a greater T. On a ridge, both sides have the
// same T, and the pair of patches with the lower index is used.
PairTouch Transmission::climb(const PairTouch& from, double phi) {
  const int count = static_cast<int>(fields_.size());
  const int most_crossings = 2 * count;  // so that rounding errors cannot cause an endless loop
  const auto on = [&](PairTouch start, int fields) {
    start.fields = fields;
    start.touch.active = {};
    return follow(start, phi);
  };
  PairTouch best = follow(from, phi);
  for (int f = 0; f < count && !best.found(); ++f)
    if (f != from.fields) best = on(from, f);
  for (int f = 0; f < count && !best.found(); ++f)
    if (const Touch t = cold(f, phi); t.found()) best = {t, f, phi, from.pair};
  int before = -1;
  for (int k = 0; best.found() && k < most_crossings; ++k) {
    const int here = best.fields;
    const detail::ActiveSet active = best.touch.active;
    for (const int bound : {active.first, active.second}) {
      const int next =
          bound < 0 ? -1 : across_[static_cast<std::size_t>(here)][static_cast<std::size_t>(bound)];
      if (next < 0 || next == before) continue;
      const PairTouch t = on(best, next);
      if (!t.found()) continue;
      const double ahead = t.te() - best.te();
      if (ahead > detail::kTogether || (ahead > -detail::kTogether && next < best.fields)) best = t;
    }
    if (best.fields == here) break;
    before = here;
  }
  return best;
}

// Follows a touch through the positions of tooth pair 0. For each position of a pitch, the touch
// with the greatest T is recorded in `best`.
class Transmission::Track {
 public:
  Track(Transmission& all, double first, int n, double below, std::vector<PairTouch>& best)
      : all_(all),
        first_(first),
        n_(n),
        most_(all.farthest_pair_ * n),
        below_(below),
        best_(best) {}

  int most() const { return most_; }  // greatest |m|
  double own(int m) const { return first_ + m * (all_.pair_.pitch() / n_); }

  // Records a touch. Returns false if its T is well below T of another pair.
  bool offer(int m, const PairTouch& t) {
    // Position m of pair 0 is position i of pair k = (i − m)/n.
    const int i = ((m % n_) + n_) % n_;
    count_step(all_.progress_);
    PairTouch& b = best_[static_cast<std::size_t>(i)];
    if (detail::wins(t.touch, own(m), b)) b = {t.touch, t.fields, own(m), (i - m) / n_};
    return t.te() >= b.te() - below_;
  }

  // Follows a touch from position m in one direction. `step` computes the touch at a rotation from
  // a predicted touch. The track ends if no touch is found, if another track contains the touch
  // (`known`), or if T decreases and is well below T of another pair.
  template <class Step, class Known>
  void walk(int m, const PairTouch& from, int direction, const Step& step, const Known& known) {
    PairTouch last = from;
    PlaceAhead ahead(from.touch);
    while (std::abs(m) <= most_) {
      m += direction;
      const FlankPatch& a = all_.field(last.fields).one();
      const auto [s, z] = ahead.place();
      PairTouch start = last;
      start.touch.s = std::clamp(s, a.s_lo, a.s_hi);
      start.touch.z = std::clamp(z, a.z_lo, a.z_hi);
      const PairTouch t = step(start, own(m));
      if (!t.found() || known(m, t.touch)) return;
      const bool near = offer(m, t);
      if (!near && t.te() < last.te()) return;
      ahead.add(t.touch);
      last = t;
    }
  }

 private:
  Transmission& all_;
  double first_;
  int n_, most_;
  double below_;
  std::vector<PairTouch>& best_;
};

// Returns the indices of the pairs of patches, the pair with the largest patches first.
std::vector<int> Transmission::largest_first() const {
  std::vector<std::pair<double, int>> order;
  for (int f = 0; f < static_cast<int>(fields_.size()); ++f) {
    const FlankPatch &a = field(f).one(), &b = field(f).two();
    order.emplace_back(
        (a.u_lo - a.u_hi) * (a.z_hi - a.z_lo) * (b.u_hi - b.u_lo) * (b.z_hi - b.z_lo), f);
  }
  std::sort(order.begin(), order.end());
  std::vector<int> numbers;
  for (const auto& [size, f] : order) numbers.push_back(f);
  return numbers;
}

// Returns the touch of tooth pair 0 on convex flanks. If there is none, the result is not found().
PairTouch Transmission::first_touch(double phi) {
  for (const int f : largest_first()) {
    fields_[static_cast<std::size_t>(f)]->set_rotation(phi);
    const Touch t = search(f).from_middle();
    if (t.found()) return climb({t, f, phi, 0}, phi);
  }
  return {};
}

// Follows the maximum of T on convex flanks, where T has only one maximum. These flanks touch in
// only one interval of rotation.
void Transmission::follow_one(double first, int n, std::vector<PairTouch>& best) {
  Track track(*this, first, n, kBelow, best);
  const int stride = std::max(1, n / 4);
  for (int away = 0; away <= track.most(); away += stride) {
    for (const int m : {away, -away}) {
      const PairTouch t = first_touch(track.own(m));
      if (!t.found()) continue;
      track.offer(m, t);
      const auto never = [](int, const Touch&) { return false; };
      const auto step = [&](const PairTouch& start, double phi) { return climb(start, phi); };
      // The direction in which T rises is followed first. The search in the other direction then
      // ends early if its T is well below the values found in the first direction.
      const PairTouch ahead = follow(t, track.own(m + 1));
      const int uphill = ahead.found() && ahead.te() < t.te() ? -1 : 1;
      for (const int direction : {uphill, -uphill}) track.walk(m, t, direction, step, never);
      return;
    }
  }
}

// Follows the maxima of T for one pair of patches. T may have several maxima on these flanks, and
// the flanks may touch in several intervals of rotation. Searches of the whole flank at regular
// positions find the maxima. Each maximum is followed until its track meets another track. On
// uneven flanks, the whole flank is searched at every position, because a crest may touch only for
// a small part of a pitch.
void Transmission::follow_all(int fields, double first, int n, std::vector<PairTouch>& best) {
  Track track(*this, first, n, kFarBelow, best);
  const int most = track.most();
  const int stride = search(fields).uneven() ? 1 : std::max(1, n / 8);
  std::vector<std::vector<Touch>> passed(static_cast<std::size_t>(2 * (most + 1) + 1));
  const FlankPatch& a = fields_[static_cast<std::size_t>(fields)]->one();
  const auto known = [&](int m, const Touch& t) {
    constexpr double kSamePlace =
        1e-5;  // distance, relative to the patch, below which touches are the same
    auto& here = passed[static_cast<std::size_t>(m + most + 1)];
    for (const Touch& p : here) {
      if (std::abs(p.s - t.s) <= kSamePlace * (a.s_hi - a.s_lo) &&
          std::abs(p.z - t.z) <= kSamePlace * (a.z_hi - a.z_lo))
        return true;
    }
    here.push_back(t);
    return false;
  };
  const auto step = [&](const PairTouch& start, double phi) { return follow(start, phi); };
  for (int m = -most; m <= most; m += stride) {
    fields_[static_cast<std::size_t>(fields)]->set_rotation(track.own(m));
    for (const Touch& touch : searches_[static_cast<std::size_t>(fields)]->every_maximum()) {
      if (known(m, touch)) continue;
      const PairTouch t{touch, fields, track.own(m), 0};
      track.offer(m, t);
      for (const int direction : {1, -1}) track.walk(m, t, direction, step, known);
    }
  }
}

}  // namespace gearwright
