// Chooses the profile shifts of a design within its region. If possible, the point lies on the line
// of balanced strength (Eq. 11, design/shift_region.hpp) and away from the borders.
//                                              theory: docs/theory/09-design-search.md, 9.4
#include <algorithm>
#include <limits>
#include <utility>

#include "gearwright/design/fillet_gap.hpp"
#include "gearwright/design/shift_region.hpp"
#include "gearwright/pair/shift.hpp"

namespace gearwright {

Vec2 balanced_point(int z1, int z2, double sum, double lambda) {
  const auto x = divided_shift_sum(z1, z2, sum, lambda);
  return {x[0], x[1]};
}

bool line_is_outside(const ShiftGraph& graph, double a, double b) {
  constexpr double kBarely = 1e-9;  // modules; rounding errors are much smaller
  const Trial& t = graph.trial();
  const Vec2 at_0 = balanced_point(t.z1, t.z2, 0.0, graph.problem().lambda);
  const Vec2 at_1 = balanced_point(t.z1, t.z2, 1.0, graph.problem().lambda);
  const auto limits = graph.shift_limits();
  for (const int i : {0, 1}) {
    // No shift on the line decreases when Σ increases.
    const double rise = at_1[i] - at_0[i];
    const Interval& limit = limits[static_cast<std::size_t>(i)];
    if (!(rise > 0.0)) {
      if (at_0[i] < limit.lo - kBarely || at_0[i] > limit.hi + kBarely) return true;
      continue;
    }
    a = std::max(a, (limit.lo - kBarely - at_0[i]) / rise);
    b = std::min(b, (limit.hi + kBarely - at_0[i]) / rise);
  }
  return a > b;
}

namespace {

constexpr double kFarOff = 1e9;  // modules; greater than the distance of any point from a border
// Smaller distances from a border, modules, are rounding errors.
constexpr double kSameEnd = 1e-9;

// Returns the greatest value of f over [a, b], from nodes and a golden section search around the
// highest node. If all values are negative, the search ends early and may miss the maximum.
template <class F>
double greatest(const F& f, double a, double b, double bend) {
  if (!(a < b)) return f(a);
  int best = 0;
  double top = f(a);
  const auto node = [&](int i) {
    return i == kIntervalNodes ? b : a + (b - a) * i / kIntervalNodes;
  };
  for (int i = 1; i <= kIntervalNodes; ++i) {
    const double value = f(node(i));
    if (value > top) top = value, best = i;
  }
  // climb() stops as soon as a value is positive. Therefore, climb() receives f minus a constant
  // that exceeds the maximum of f.
  const double above = top + 1.0;
  const double x =
      detail::climb([&](double s) { return f(s) - above; }, node(std::max(best - 1, 0)),
                    node(std::min(best + 1, kIntervalNodes)), {.bend = bend, .below = -above});
  return std::max(top, f(x));
}

// `asked` excludes points at which a tip cuts into a fillet. `left_out` permits these points.
enum class Fillets { asked, left_out };
std::optional<Vec2> place_off_walls(const ShiftGraph& graph, Fillets fillets) {
  const ShiftGraph::Sums range = graph.sums();
  if (!(range.lo <= range.hi) || line_is_outside(graph, range.lo, range.hi)) return std::nullopt;
  // If fillets are checked, the distance from the borders is a discontinuous function of Σ. There
  // is then no upper limit for its second derivative.
  const double bend =
      fillets == Fillets::asked ? std::numeric_limits<double>::infinity() : kMostBend;
  const Trial& t = graph.trial();
  const auto place = [&](double sum) {
    return balanced_point(t.z1, t.z2, sum, graph.problem().lambda);
  };
  const auto off_walls = [&](double sum) {
    const Vec2 p = place(sum);
    const double wall = graph.wall_distance(p[0], p[1]);
    // If a fillet is cut, the result is negative, as at a violated border. Its size has no meaning.
    return fillets == Fillets::asked && wall > 0.0 && fillet_is_cut(graph, p) ? -wall : wall;
  };
  const double nearest = std::clamp(0.0, range.lo, range.hi);
  const double at_nearest = off_walls(nearest);
  if (at_nearest >= kWallDistance) return place(nearest);
  // As a function of Σ, the distance from the borders has one maximum. The rare exceptions are
  // regions with several pieces. The search climbs from `nearest` in growing steps until the
  // distance is sufficient or decreases. A root finder then locates the point nearest to `nearest`
  // that is far enough from the borders.
  constexpr double kStep = 0.05;  // modules, first step of Σ
  const double right = std::min(nearest + kStep, range.hi);
  const double left = std::max(nearest - kStep, range.lo);
  const double at_right = right > nearest ? off_walls(right) : -kFarOff;
  const double at_left = left < nearest ? off_walls(left) : -kFarOff;
  const double side = at_right >= at_left ? 1.0 : -1.0;
  double before = nearest;
  double here = side > 0.0 ? right : left;
  double value = std::max(at_right, at_left);
  double beyond = here;
  for (double step = kStep; value < kWallDistance; step *= 2.0) {
    beyond = std::clamp(here + side * step, range.lo, range.hi);
    const double next = beyond == here ? value : off_walls(beyond);
    if (!(next > value)) break;
    before = std::exchange(here, beyond);
    value = next;
  }
  if (value < kWallDistance) {
    // The maximum lies between `before` and `beyond`. If the first step already failed, the maximum
    // may lie on either side of the start.
    if (before == nearest) before = side > 0.0 ? left : right;
    here = detail::climb([&](double sum) { return off_walls(sum) - kWallDistance; },
                         std::min(before, beyond), std::max(before, beyond),
                         {.bend = bend, .below = -kWallDistance});
    value = off_walls(here);
  }
  if (value > kSameEnd) {
    const double distance = std::min(kWallDistance, value / 2.0);
    if (at_nearest >= distance) return place(nearest);
    const Root root = find_root([&](double sum) { return off_walls(sum) - distance; },
                                std::min(nearest, here), std::max(nearest, here));
    if (root.found()) return place(root.x);
  }
  // For external gears at extended centres, the distance from the borders has only one maximum,
  // which the search above finds.
  const SearchProblem& problem = graph.problem();
  const bool one_hump = problem.mounting == Mounting::extended &&
                        problem.kind() == PairKind::parallel_external &&
                        fillets == Fillets::left_out;
  if (one_hump) return std::nullopt;
  const auto first_beyond = [&](double distance) {
    return nearest_zero(where_not_negative([&](double sum) { return off_walls(sum) - distance; },
                                           range.lo, range.hi, kIntervalNodes, {.bend = bend}));
  };
  if (const auto sum = first_beyond(kWallDistance)) return place(*sum);
  const double most = greatest(off_walls, range.lo, range.hi, bend);
  if (!(most > kSameEnd)) return std::nullopt;
  const auto sum = first_beyond(most / 2.0);
  return sum ? std::optional(place(*sum)) : std::nullopt;
}

}  // namespace

std::optional<Vec2> point_off_walls(const ShiftGraph& graph) {
  if (!graph.problem().limits.avoid_interference) {
    // If interference is permitted, the point with Σ nearest 0 is used. If this point lies at a
    // border, the result is empty. The caller then computes the region to choose a point.
    const ShiftGraph::Sums range = graph.sums();
    if (!(range.lo <= range.hi)) return std::nullopt;
    const Trial& t = graph.trial();
    const Vec2 p =
        balanced_point(t.z1, t.z2, std::clamp(0.0, range.lo, range.hi), graph.problem().lambda);
    return graph.wall_distance(p[0], p[1]) > kSameEnd ? std::optional(p) : std::nullopt;
  }
  // The check of fillets takes longer than all other checks and rarely excludes a point. The point
  // is therefore computed without this check first.
  const auto place = place_off_walls(graph, Fillets::left_out);
  return place && fillet_is_cut(graph, *place) ? place_off_walls(graph, Fillets::asked) : place;
}

Vec2 chosen_point(const ShiftGraph& graph, const ShiftRegion& region) {
  if (region.off_walls) return *region.off_walls;
  return region.balanced ? *region.balanced : middle_point(graph, region);
}

Vec2 middle_point(const ShiftGraph& graph, const ShiftRegion& region) {
  const auto longest = std::max_element(
      region.sums.begin(), region.sums.end(),
      [](const Interval& a, const Interval& b) { return a.hi - a.lo < b.hi - b.lo; });
  const double sum = (longest->lo + longest->hi) / 2.0;
  const double x1 = graph.slice(sum).middle();
  const Vec2 inside{x1, sum - x1};
  const Vec2 middle = (region.lo + region.hi) / 2.0;
  const bool runs = graph.problem().limits.avoid_interference;
  // If `middle` is at least half as far from the borders as `inside`, `middle` is used. If the
  // slice at one end of the region is a point, the ratio is exactly 1/2, so a tolerance is
  // subtracted.
  const double enough =
      (runs ? std::max(0.0, graph.wall_distance(inside[0], inside[1]) / 2.0) : 0.0) - kTouching;
  const bool one = region.sums.size() == 1;
  return one && graph.wall_distance(middle[0], middle[1]) >= enough ? middle : inside;
}

}  // namespace gearwright
