#include "gearwright/scatter/uneven_teeth.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <numbers>
#include <numeric>

#include "gearwright/math/sobol.hpp"

namespace gearwright {

namespace {

double range_of(const std::vector<double>& v) {
  const auto [least, greatest] = std::minmax_element(v.begin(), v.end());
  return *greatest - *least;
}

// Returns the greatest step from a tooth to the next tooth, around the gear.
double greatest_step(const std::vector<double>& v) {
  double step = 0.0;
  for (std::size_t k = 0; k < v.size(); ++k)
    step = std::max(step, std::abs(v[(k + 1) % v.size()] - v[k]));
  return step;
}

// Returns a random walk that closes after one turn, with mean 0.
std::vector<double> closed_walk(std::size_t teeth, std::uint64_t key) {
  std::vector<double> walk(teeth);
  double at = 0.0;
  double mean_step = 0.0;
  std::vector<double> steps;
  for (std::size_t k = 0; k < teeth; ++k) {
    steps.push_back(random_unit(key, k) - 0.5);
    mean_step += steps.back() / static_cast<double>(teeth);
  }
  double mean = 0.0;
  for (std::size_t k = 0; k < teeth; ++k) {
    walk[k] = at;
    mean += at / static_cast<double>(teeth);
    at += steps[k] - mean_step;
  }
  for (double& w : walk) w -= mean;
  return walk;
}

constexpr double kNone = -std::numeric_limits<double>::infinity();

// T of one tooth pair as a function of its own rotation, which is counted in steps m from the first
// touch. T is kNone without contact.
class PairCurve {
 public:
  PairCurve(Transmission& transmission, const std::vector<PairTouch>& touches)
      : transmission_(transmission),
        n_(static_cast<int>(touches.size())),
        step_(transmission.pair().turned() * transmission.pair().pitch() / n_),
        most_(transmission.farthest_pair() * n_),
        te_(static_cast<std::size_t>(2 * most_ + 1), kNone),
        passed_(te_.size()) {
    const double first = touches[0].phi;
    for (const PairTouch& t : touches) {
      const auto m = static_cast<int>(std::lround((t.phi - first) / step_));
      if (transmission_.wavy()) {
        offer(m, t);
      } else {
        offer_and_walk(m, t);
      }
    }
    // If the pitches are equal, some branches never determine TE. With unequal pitches, such a
    // branch may determine TE, so one more pitch is searched on each side.
    const int from = std::max(-most_, least() - n_);
    const int to = std::min(most_, greatest() + n_);
    if (transmission_.wavy()) {
      for (int m = from; m <= to; ++m)
        if (const PairTouch t = transmission_.of_pair_0(first + m * step_); t.found()) offer(m, t);
      return;
    }
    const int stride = std::max(1, n_ / 4);
    for (int m = from; m <= to; m += stride)
      for (const PairTouch& t : transmission_.every_of_pair_0(first + m * step_))
        offer_and_walk(m, t);
  }

  int least() const { return first_found(1) - most_; }
  int greatest() const { return static_cast<int>(te_.size()) - 1 - first_found(-1) - most_; }
  double at(int m) const { return te_[static_cast<std::size_t>(m + most_)]; }

 private:
  int first_found(int way) const {
    int i = 0;
    const auto size = static_cast<int>(te_.size());
    while (i < size && te_[static_cast<std::size_t>(way > 0 ? i : size - 1 - i)] == kNone) ++i;
    return i;
  }
  // Records a touch. Returns true if it is new.
  bool offer(int m, const PairTouch& t) {
    if (std::abs(m) > most_) return false;
    const auto at = static_cast<std::size_t>(m + most_);
    constexpr double kSame = 1e-12;  // rad: difference of equal touches, from rounding
    for (const auto& [fields, te] : passed_[at])
      if (fields == t.fields && std::abs(te - t.te()) < kSame) return false;
    passed_[at].push_back({t.fields, t.te()});
    te_[at] = std::max(te_[at], t.te());
    return true;
  }
  void offer_and_walk(int m, const PairTouch& start) {
    if (!offer(m, start)) return;
    for (const int way : {1, -1}) {
      PairTouch last = start;
      for (int at = m + way; std::abs(at) <= most_; at += way) {
        last = transmission_.follow(last, last.phi + way * step_);
        if (!last.found() || !offer(at, last)) break;
      }
    }
  }

  struct Passed {
    int fields;
    double te;
  };
  Transmission& transmission_;
  int n_;
  double step_;
  int most_;
  std::vector<double> te_;
  std::vector<std::vector<Passed>> passed_;
};

}  // namespace

std::vector<double> uneven_pitch(const Gear& gear, const VaryingPitch& tolerance, double share,
                                 double phase, double eccentric) {
  GW_EXPECTS(share >= 0.0 && eccentric >= 0.0 && eccentric <= 1.0);
  const auto teeth = static_cast<std::size_t>(std::abs(gear.spec.teeth));
  std::uint64_t key = hash64(static_cast<std::uint64_t>(tolerance.gear));
  for (const double x : {share, phase, eccentric}) {
    std::uint64_t bits;  // std::bit_cast is missing in the standard library of the browser build
    std::memcpy(&bits, &x, sizeof bits);
    key = hash64(key ^ bits);
  }
  const std::vector<double> walk = closed_walk(teeth, key);
  const double walk_range = range_of(walk);
  const auto sum = [&](double wave, double random) {
    std::vector<double> v(teeth);
    for (std::size_t k = 0; k < teeth; ++k) {
      const double turn =
          2.0 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(teeth);
      v[k] = 0.5 * wave * std::sin(turn + phase) +
             (walk_range > 0.0 ? random * walk[k] / walk_range : 0.0);
    }
    return v;
  };
  std::vector<double> v = sum(eccentric, 1.0 - eccentric);
  const double range = range_of(v);
  if (!(range > 0.0)) return std::vector<double>(teeth, 0.0);
  const double limit = std::min(share * tolerance.total / range,
                                tolerance.single / std::max(greatest_step(v), 1e-300));
  const double radius = std::abs(gear.reference_diameter) / 2;
  for (double& e : v) e *= limit / radius;
  return v;
}

double long_period_span(Transmission& transmission, const std::vector<PairTouch>& touches,
                        const std::array<int, 2>& teeth,
                        const std::array<std::vector<double>, 2>& pitch) {
  for (const std::size_t i : {0, 1})
    GW_EXPECTS(pitch[i].empty() || static_cast<int>(pitch[i].size()) == teeth[i]);
  const PairCurve curve(transmission, touches);
  const int n = static_cast<int>(touches.size());
  const double ratio = transmission.pair().ratio();
  const auto ahead = [&](long p) {
    const auto of = [&](std::size_t i) {
      return pitch[i].empty() ? 0.0 : pitch[i][static_cast<std::size_t>(p % teeth[i])];
    };
    return ratio * of(0) - of(1);
  };
  const long period = std::lcm(static_cast<long>(teeth[0]), static_cast<long>(teeth[1]));
  // At position i of a pitch, the tooth pair of k pitches before is at step m = i + k n of `curve`.
  const int lo = curve.least();
  const int hi = curve.greatest();
  const int from = static_cast<int>(std::floor(static_cast<double>(lo) / n));
  const int to = static_cast<int>(std::floor(static_cast<double>(hi) / n));
  // Element p − k + to is the offset of T of the tooth pair k pitches before pitch p.
  std::vector<double> offset;
  for (long p = -to; p < period - from; ++p)
    offset.push_back(ahead((p % period + period) % period));
  double least = std::numeric_limits<double>::infinity();
  double greatest = kNone;
  std::vector<double> te(static_cast<std::size_t>(period));  // at position i of each pitch
  for (int i = 0; i < n; ++i) {
    std::fill(te.begin(), te.end(), kNone);
    for (int k = from; k <= to; ++k) {
      const int m = i + k * n;
      if (m < lo || m > hi || curve.at(m) == kNone) continue;
      const double* const ahead_of = offset.data() + (to - k);
      for (std::size_t p = 0; p < te.size(); ++p)
        te[p] = std::max(te[p], curve.at(m) + ahead_of[p]);
    }
    const auto [low, high] = std::minmax_element(te.begin(), te.end());
    least = std::min(least, *low);
    greatest = std::max(greatest, *high);
  }
  return greatest - least;
}

}  // namespace gearwright
