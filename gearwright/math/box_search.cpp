// The box is divided into cells. The value of a cell is the value of f at its middle. In a plot of
// the values over the sizes, the cells on the lower right part of the convex hull are those that
// can contain the least value of f for some greatest slope of f. Each round divides these cells. Of
// the cells of equal size, only the one with the least value is considered, which is the local bias
// of DIRECT-L.
//
//   size     half of the longest side, as a part of the box
//   f        value in the middle of the cell
#include "gearwright/math/box_search.hpp"

#include <algorithm>
#include <array>
#include <deque>
#include <limits>
#include <set>

#include "gearwright/base/numbers.hpp"

namespace gearwright::detail {

namespace {

constexpr double kThird = 1.0 / 3.0;
// Greatest relative difference of two sides that count as equal and are divided together. Unequal
// sides differ at least by the factor three.
constexpr double kSameSide = 0.05;

struct Cell {
  double size = 0.0, f = 0.0;
  long age = 0;  // order of creation; cells of the same size and value are divided in this order
  std::vector<double> middle, side;
};

struct BySize {
  bool operator()(const Cell* a, const Cell* b) const {
    if (a->size != b->size) return a->size < b->size;
    if (a->f != b->f) return a->f < b->f;
    return a->age < b->age;
  }
};

// Half of the longest side, in single precision. Sides that differ by rounding have the same size.
double size_of(const std::vector<double>& side) {
  return static_cast<float>(*std::max_element(side.begin(), side.end()) * 0.5);
}

double slope(const Cell& a, const Cell& b) { return (a.f - b.f) / (a.size - b.size); }

class BoxSearch {
 public:
  BoxSearch(const MinimiserTask& task, Trials& trials) : task_(task), trials_(trials) {}

  std::vector<double> best() {
    const std::size_t n = task_.lo.size();
    Cell whole;
    whole.middle.assign(n, 0.5);
    best_ = whole.middle;  // the result if every value is infinite
    whole.side.assign(n, 1.0);
    whole.size = size_of(whole.side);
    whole.f = tried(whole.middle);
    Cell& first = keep(std::move(whole));
    if (!divide(first)) return in_box(best_);
    for (;;) {
      const double before = least_;
      if (!divide_best()) break;
      if (least_ < before && trials_.settled(before, least_)) break;
    }
    return in_box(best_);
  }

 private:
  std::vector<double> in_box(const std::vector<double>& part) const {
    std::vector<double> x(part.size());
    for (std::size_t i = 0; i < x.size(); ++i)
      x[i] = task_.lo[i] + part[i] * (task_.hi[i] - task_.lo[i]);
    return x;
  }

  double tried(const std::vector<double>& part) {
    const double f = trials_.at(in_box(part));
    if (f < least_) {
      least_ = f;
      best_ = part;
    }
    return f;
  }

  Cell& keep(Cell cell) {
    cell.age = next_age_++;
    cells_.push_back(std::move(cell));
    sorted_.insert(&cells_.back());
    return cells_.back();
  }

  // Divides a cell along its longest sides, beginning with the direction in which the least value
  // of f was found. The parts with the least values are therefore the largest. Returns false if the
  // trials are spent.
  bool divide(Cell& cell) {
    const double longest = *std::max_element(cell.side.begin(), cell.side.end());
    std::vector<std::size_t> along;
    std::vector<std::array<double, 2>> beside(cell.side.size());
    for (std::size_t i = 0; i < cell.side.size(); ++i) {
      if (longest - cell.side[i] > longest * kSameSide) continue;
      along.push_back(i);
      for (const std::size_t end : {0u, 1u}) {
        std::vector<double> x = cell.middle;
        const double away = cell.side[i] * kThird;
        x[i] += end == 0 ? -away : away;
        beside[i][end] = tried(x);
        if (trials_.spent()) return false;
      }
    }
    std::stable_sort(along.begin(), along.end(), [&](std::size_t a, std::size_t b) {
      return std::min(beside[a][0], beside[a][1]) < std::min(beside[b][0], beside[b][1]);
    });
    for (const std::size_t i : along) {
      sorted_.erase(&cell);
      cell.side[i] *= kThird;
      cell.size = size_of(cell.side);
      cell.age = next_age_++;
      sorted_.insert(&cell);
      for (const std::size_t end : {0u, 1u}) {
        Cell part = cell;
        part.middle[i] += end == 0 ? -cell.side[i] : cell.side[i];
        part.f = beside[i][end];
        keep(std::move(part));
      }
    }
    return true;
  }

  // Returns the cell with the least value of each size, in ascending order of size.
  std::vector<Cell*> least_of_each_size() const {
    std::vector<Cell*> least;
    for (auto at = sorted_.begin(); at != sorted_.end();) {
      least.push_back(*at);
      Cell last;
      last.size = (*at)->size;
      last.f = kInfinity;
      // This age places `last` behind all cells of its size, even those with infinite values.
      last.age = std::numeric_limits<long>::max();
      at = sorted_.upper_bound(&last);
    }
    return least;
  }

  // Returns the cells on the lower convex hull, in ascending order of size. The second cell and the
  // last cell but one may lie above the hull, because the result is not checked at its two ends.
  std::vector<Cell*> hull() const {
    const std::vector<Cell*> all = least_of_each_size();
    if (all.size() == 1) return all;
    const Cell &smallest = *all.front(), &largest = *all.back();
    const double rise = (largest.f - smallest.f) / (largest.size - smallest.size);
    std::vector<Cell*> hull{all.front()};
    for (std::size_t i = 1; i + 1 < all.size(); ++i) {
      Cell* const c = all[i];
      if (c->f > smallest.f + (c->size - smallest.size) * rise) continue;
      while (hull.size() > 2) {
        const Cell &one = *hull[hull.size() - 2], &two = *hull.back();
        if ((two.size - one.size) * (c->f - one.f) - (two.f - one.f) * (c->size - one.size) >= 0.0)
          break;
        hull.pop_back();
      }
      hull.push_back(c);
    }
    hull.push_back(all.back());
    return hull;
  }

  // Divides the largest cell and each cell of the hull that can contain a value less than the least
  // known value. A cell that was divided in this round is compared with its new size.
  bool divide_best() {
    const std::vector<Cell*> list = hull();
    for (std::size_t i = 0; i < list.size(); ++i) {
      Cell& cell = *list[i];
      const bool last = i + 1 == list.size();
      double steepest = i > 0 ? slope(cell, *list[i - 1]) : -kInfinity;
      if (!last) steepest = std::max(steepest, slope(cell, *list[i + 1]));
      if (!last && !(cell.f - steepest * cell.size <= least_)) continue;
      if (!divide(cell)) return false;
    }
    return true;
  }

  const MinimiserTask& task_;
  Trials& trials_;
  std::deque<Cell> cells_;
  std::set<Cell*, BySize> sorted_;
  long next_age_ = 0;
  double least_ = kInfinity;
  std::vector<double> best_;
};

}  // namespace

std::vector<double> search_box(const MinimiserTask& task, Trials& trials) {
  return BoxSearch(task, trials).best();
}

}  // namespace gearwright::detail
