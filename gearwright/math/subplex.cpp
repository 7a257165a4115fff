// Each round of Subplex sorts the variables by their progress in the previous round. It divides
// them into groups, so that variables with similar progress are in the same group. A simplex search
// (Nelder and Mead) over each group then runs until the simplex has shrunk to a quarter of its
// first size. The next round takes steps in the direction of the progress.
#include "gearwright/math/subplex.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

#include "gearwright/base/numbers.hpp"

namespace gearwright::detail {

namespace {

constexpr double kShrunk = 0.25;  // a simplex search ends at this fraction of the first size
// Least factor by which the steps change from round to round. The greatest factor is its inverse.
constexpr double kLeastFactor = 0.1;
constexpr std::size_t kLeastGroup = 2, kMostGroup = 5;
// A step beyond the box ends at the border. If the border is nearer than this fraction of the step,
// the step is reversed instead.
constexpr double kWorthAStep = 0.1;

bool close(double a, double b) { return std::abs(a - b) <= 1e-13 * (std::abs(a) + std::abs(b)); }

enum class End { small, spent, no_simplex };

// Part of the minimisation task: the variables of one group.
struct Group {
  std::vector<double> lo, hi, step;
  std::function<double(const std::vector<double>&)> f;
};

struct Corner {
  double f;
  std::vector<double> x;
};

class SimplexSearch {
 public:
  SimplexSearch(const Group& group, const Trials& trials, Corner& best)
      : group_(group), trials_(trials), best_(best), corners_(group.lo.size() + 1, best) {}

  End run() {
    if (const End end = first_corners(); end != End::small) return end;
    double first_size = 0.0;
    for (;;) {
      const auto [low, next, high] = ranks();
      spread_ = corners_[high].f - corners_[low].f;
      const double size = distance(corners_[low].x, corners_[high].x);
      if (first_size == 0.0) first_size = size;
      if (size < kShrunk * first_size) return End::small;
      const std::vector<double> middle = middle_without(high);
      if (!moves(middle, low, next, high)) return end_;
    }
  }
  /// Difference of f between the worst and the best corner of the last simplex.
  double spread() const { return spread_; }

 private:
  struct Ranks {
    std::size_t low, next, high;  // best, second worst and worst corner
  };

  Ranks ranks() const {
    // Of two corners with equal values, the corner with the greater index counts as worse.
    std::vector<std::size_t> order(corners_.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return corners_[a].f < corners_[b].f; });
    return {order.front(), order[order.size() - 2], order.back()};
  }

  static double distance(const std::vector<double>& a, const std::vector<double>& b) {
    double sum = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += std::abs(a[i] - b[i]);
    return sum;
  }

  // Evaluates f at x. Returns false if no trials are left afterwards.
  bool tried(const std::vector<double>& x, double& f) {
    f = group_.f(x);
    if (f <= best_.f) best_ = {f, x};
    if (!trials_.spent()) return true;
    end_ = End::spent;
    return false;
  }

  // Returns the value of variable i after its first step from x. The result lies in the box.
  double stepped(std::size_t i, double x) const {
    const double lo = group_.lo[i], hi = group_.hi[i], reach = std::abs(group_.step[i]);
    double to = x + group_.step[i];
    if (to > hi) to = hi - x > reach * kWorthAStep ? hi : x - reach;
    if (!(to < lo)) return to;
    if (x - lo > reach * kWorthAStep) return lo;
    to = x + reach;
    return to > hi ? 0.5 * ((hi - x > x - lo ? hi : lo) + x) : to;
  }

  // Places each corner one step from the best point so far.
  End first_corners() {
    for (std::size_t i = 0; i + 1 < corners_.size(); ++i) {
      Corner& corner = corners_[i + 1];
      corner.x = best_.x;
      corner.x[i] = stepped(i, best_.x[i]);
      if (close(corner.x[i], best_.x[i])) return End::no_simplex;
      if (!tried(corner.x, corner.f)) return End::spent;
    }
    return End::small;
  }

  std::vector<double> middle_without(std::size_t corner) const {
    std::vector<double> sum(group_.lo.size(), 0.0);
    for (std::size_t k = 0; k < corners_.size(); ++k)
      if (k != corner)
        for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += corners_[k].x[i];
    const double part = 1.0 / static_cast<double>(sum.size());
    for (double& s : sum) s *= part;
    return sum;
  }

  // Sets `to` to the point `from` + factor·(from − x), clipped to the box, and to the function
  // value at this point.
  // Returns false if the point is equal to `from` or x, or if the trials are spent.
  bool away(const std::vector<double>& from, double factor, const std::vector<double>& x,
            Corner& to) {
    bool at_from = true, at_x = true;
    Corner found{0.0, std::vector<double>(x.size())};
    for (std::size_t i = 0; i < x.size(); ++i) {
      const double moved = from[i] + factor * (from[i] - x[i]);
      found.x[i] = moved < group_.lo[i]   ? group_.lo[i]
                   : moved > group_.hi[i] ? group_.hi[i]
                                          : moved;
      at_from = at_from && close(found.x[i], from[i]);
      at_x = at_x && close(found.x[i], x[i]);
    }
    if (at_from || at_x) {
      end_ = End::small;
      return false;
    }
    const bool goes_on = tried(found.x, found.f);
    to = std::move(found);
    return goes_on;
  }

  // One step of the simplex: replaces the worst corner, or moves all corners towards the best one.
  // Returns false if the search ends.
  bool moves(const std::vector<double>& middle, std::size_t low, std::size_t next,
             std::size_t high) {
    Corner& worst = corners_[high];
    Corner mirrored;
    if (!away(middle, 1.0, worst.x, mirrored)) return false;
    if (mirrored.f < corners_[low].f) {
      Corner farther;
      if (!away(middle, 2.0, worst.x, farther)) return false;
      worst = farther.f >= mirrored.f ? mirrored : farther;
      return true;
    }
    if (mirrored.f < corners_[next].f) {
      worst = mirrored;
      return true;
    }
    Corner nearer;
    if (!away(middle, worst.f <= mirrored.f ? -0.5 : 0.5, worst.x, nearer)) return false;
    if (nearer.f < mirrored.f && nearer.f < worst.f) {
      worst = nearer;
      return true;
    }
    for (std::size_t k = 0; k < corners_.size(); ++k)
      if (k != low && !away(corners_[low].x, -0.5, corners_[k].x, corners_[k])) return false;
    return true;
  }

  const Group& group_;
  const Trials& trials_;
  Corner& best_;
  std::vector<Corner> corners_;
  double spread_ = kInfinity;
  End end_ = End::small;
};

// Returns the number of variables of the next group, which begins at `first`. The end of the group
// is chosen so that the mean progress of all variables up to this end exceeds the mean progress of
// the following variables the most. `before` is the sum of the progress of the preceding groups,
// and `whole` is the sum of the progress of all variables.
std::size_t group_size(const std::vector<double>& progress, std::size_t first, double before,
                       double whole) {
  const std::size_t n = progress.size();
  std::size_t size = kLeastGroup;
  double best = -kInfinity, sum = before + progress[first];
  for (std::size_t k = first + 1; k < std::min(first + kMostGroup, n); ++k) {
    sum += progress[k];
    const std::size_t left = n - (k + 1);
    if (left < kLeastGroup) continue;
    const double fall =
        sum / static_cast<double>(k + 1) - (whole - sum) / static_cast<double>(left);
    if (!(fall > best)) continue;
    best = fall;
    size = k + 1 - first;
  }
  return size;
}

}  // namespace

std::vector<double> subplex(const MinimiserTask& task, Trials& trials, std::vector<double> start) {
  const std::size_t n = start.size();
  Corner best{trials.at(start), start};
  if (trials.spent()) return best.x;
  std::vector<double> step = task.step, moved(n, 0.0);
  for (;;) {
    const std::vector<double> before = best.x;
    std::vector<std::size_t> order(n);
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
      return std::abs(moved[a]) > std::abs(moved[b]);
    });
    std::vector<double> progress(n);
    for (std::size_t k = 0; k < n; ++k) progress[k] = std::abs(moved[order[k]]);
    double whole = 0.0, passed = 0.0, spread = 0.0;
    for (const double m : moved) whole += std::abs(m);
    int groups = 0;
    for (std::size_t first = 0; first < n;) {
      const bool last = !(first + kLeastGroup < n);
      const std::size_t size = last ? n - first : group_size(progress, first, passed, whole);
      Group group;
      Corner part{best.f, {}};
      for (std::size_t k = first; k < first + size; ++k) {
        passed += progress[k];
        part.x.push_back(best.x[order[k]]);
        group.step.push_back(step[order[k]]);
        group.lo.push_back(task.lo[order[k]]);
        group.hi.push_back(task.hi[order[k]]);
      }
      const auto put = [&](std::vector<double> x, const std::vector<double>& values) {
        for (std::size_t k = 0; k < values.size(); ++k) x[order[first + k]] = values[k];
        return x;
      };
      group.f = [&](const std::vector<double>& values) { return trials.at(put(best.x, values)); };
      ++groups;
      SimplexSearch search(group, trials, part);
      const End end = search.run();
      spread = std::max(spread, search.spread());
      best = {part.f, put(best.x, part.x)};
      if (end != End::small) return best.x;
      first += size;
    }
    if (trials.settled(best.f + spread, best.f)) return best.x;
    double all_steps = 0.0, all_moves = 0.0;
    for (std::size_t i = 0; i < n; ++i) {
      moved[i] = best.x[i] - before[i];
      all_steps += std::abs(step[i]);
      all_moves += std::abs(moved[i]);
    }
    const double factor =
        groups == 1 ? kShrunk : std::clamp(all_moves / all_steps, kLeastFactor, 1.0 / kLeastFactor);
    for (std::size_t i = 0; i < n; ++i)
      step[i] = moved[i] == 0.0 ? -(step[i] * factor) : std::copysign(step[i] * factor, moved[i]);
  }
}

}  // namespace gearwright::detail
