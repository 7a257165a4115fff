#include "gearwright/design/shift_region.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <boost/math/quadrature/gauss_kronrod.hpp>

namespace gearwright {

namespace {

Vec2 point(double sum, double x1) { return {x1, sum - x1}; }

// True if the edge is a straight line in the x1–x2 plane.
bool is_straight(ShiftEdge edge, const SearchProblem& problem) {
  switch (edge) {
    case ShiftEdge::eps:
    case ShiftEdge::sliding:
    case ShiftEdge::interference1:
    case ShiftEdge::eps_true:
    case ShiftEdge::interference2: return false;
    case ShiftEdge::s1max:
    case ShiftEdge::s2max: return !problem.shorten_tips;
    default: return true;
  }
}

// A slice of the region is an interval of x1. The lower ends of all slices form one side of the
// region, and the upper ends form the other side.
using Side = LineSide;
ShiftEdge edge_of(const ShiftSlice& s, Side side) {
  return side == Side::lo ? s.lo_edge : s.hi_edge;
}
double value_of(const ShiftSlice& s, Side side) { return side == Side::lo ? s.lo : s.hi; }

// Returns the difference between the bounds of x1 that belong to the edges a and b at a given Σ.
double difference(const ShiftGraph& graph, Side side, ShiftEdge a, ShiftEdge b, double sum) {
  const ShiftBounds bounds = graph.bounds_before_path(sum);
  // If an edge imposes no bound, its value is infinite. A large number replaces this value, because
  // the root finder requires finite values.
  constexpr double kFar = 1e3;
  const auto at = [&](ShiftEdge e) {
    const auto& all = side == Side::lo ? bounds.lo : bounds.hi;
    return std::clamp(all[static_cast<std::size_t>(e)], -kFar, kFar);
  };
  if (a == ShiftEdge::eps || b == ShiftEdge::eps) {
    const double x1 = at(a == ShiftEdge::eps ? b : a);
    const double d = graph.path_length(graph.place(sum), sum, x1) - graph.min_path();
    return a == ShiftEdge::eps ? d : -d;
  }
  return at(a) - at(b);
}

// Greatest number of corners of a side. More occur only if two bounds are practically equal.
constexpr std::size_t kMaxChanges = 40;
// Relative difference of two sums between which there is no other double.
constexpr double kSameSum = 4e-16;
// Edges are compared beside a corner, at the distance kBeside times the interval, but at least
// kMinBeside, modules. kMinBeside must exceed kOneBound, because bounds that differ by less than
// kOneBound have the same name.
constexpr double kBeside = 1e-9;
constexpr double kMinBeside = 1e-10;
// Several edges meet at an end of a piece. At this distance from the end, relative to the width of
// the piece, the edge is unique.
constexpr double kInset = 1e-7;
// Tolerance, modules, within which the end of a piece counts as the end of the whole range. Both
// ends are computed separately, so they may differ by rounding errors.
constexpr double kSameRegionEnd = 1e-9;
// Adds the sums between l and r at which the edge of the side changes from at_l to at_r.
void find_changes(const ShiftGraph& graph, Side side, double l, ShiftEdge at_l, double r,
                  ShiftEdge at_r, std::vector<double>& found) {
  if (at_l == at_r) return;
  if (r - l < kSameSum * (1.0 + std::abs(l) + std::abs(r)) || found.size() >= kMaxChanges) {
    found.push_back((l + r) / 2.0);
    return;
  }
  const Root root =
      find_root([&](double sum) { return difference(graph, side, at_l, at_r, sum); }, l, r);
  if (root.found() && root.x >= l && root.x <= r) {
    const double step = std::max(kBeside * (r - l), kMinBeside);
    const double before = std::max(l, root.x - step);
    const double after = std::min(r, root.x + step);
    if (edge_of(graph.slice(before), side) == at_l && edge_of(graph.slice(after), side) == at_r) {
      found.push_back(root.x);
      return;
    }
  }
  // Another edge lies between the edges at l and r.
  const double middle = (l + r) / 2.0;
  const ShiftEdge at_middle = edge_of(graph.slice(middle), side);
  find_changes(graph, side, l, at_l, middle, at_middle, found);
  find_changes(graph, side, middle, at_middle, r, at_r, found);
}

// A part of one side that belongs to a single edge.
struct Stretch {
  double from, to;
  ShiftEdge edge;
};

std::vector<Stretch> stretches(const ShiftGraph& graph, Side side, const Interval& piece) {
  constexpr int kNodes = 24;
  std::vector<double> changes;
  const double inset = kInset * (piece.hi - piece.lo);
  double l = piece.lo + inset;
  ShiftEdge at_l = edge_of(graph.slice(l), side);
  const ShiftEdge first = at_l;
  for (int i = 1; i <= kNodes; ++i) {
    const double angle = std::numbers::pi * i / kNodes;
    const double share = i == kNodes ? 1.0 : (1.0 - std::cos(angle)) / 2.0;
    const double r = piece.lo + inset + (piece.hi - piece.lo - 2.0 * inset) * share;
    const ShiftEdge at_r = edge_of(graph.slice(r), side);
    find_changes(graph, side, l, at_l, r, at_r, changes);
    l = r;
    at_l = at_r;
  }
  std::vector<Stretch> found;
  double from = piece.lo;
  ShiftEdge edge = first;
  for (const double change : changes) {
    found.push_back({from, change, edge});
    from = change;
    const double after = std::min(change + kBeside * (piece.hi - piece.lo), piece.hi - inset);
    edge = edge_of(graph.slice(after), side);
  }
  found.push_back({from, piece.hi, edge});
  return found;
}

// Maps an angle to a sum between `from` and `to`. If the two x1 with E = K coincide at an end, x1
// varies with the square root of the distance from this end, but it is smooth in the angle.
double sum_at(double from, double to, double theta) {
  return from + (to - from) * (1.0 - std::cos(theta)) / 2.0;
}

// Greatest number of bisections for the integral of the area. Near an end at which x1 varies as a
// square root, three bisections add seven correct digits.
constexpr unsigned kBisections = 10;
constexpr double kAreaTolerance = 1e-12;  // modules², for the area under one stretch of a side
// Rounding error of a bound of x1, relative to the two radii whose difference is the bound. If the
// tolerance of the integral were smaller, rounding errors would cause repeated bisections.
constexpr double kAreaRounding = 1e-13;

double area_under(const ShiftGraph& graph, Side side, const Stretch& s, bool straight) {
  const auto value = [&](double sum) { return graph.slice_end(sum, side); };
  if (straight) return (s.to - s.from) * value((s.from + s.to) / 2.0);
  const auto integrand = [&](double theta) {
    return value(sum_at(s.from, s.to, theta)) * (s.to - s.from) / 2.0 * std::sin(theta);
  };
  return boost::math::quadrature::gauss_kronrod<double, 15>::integrate(
      integrand, 0.0, std::numbers::pi, kBisections,
      std::max(kAreaTolerance,
               kAreaRounding * (std::abs(graph.gears()[0].r) + std::abs(graph.gears()[1].r))));
}

double area_of(const ShiftGraph& graph, const SearchProblem& problem, const Interval& piece) {
  if (!(piece.lo < piece.hi)) return 0.0;
  double area = 0.0;
  for (const Side side : {Side::lo, Side::hi}) {
    for (const Stretch& s : stretches(graph, side, piece)) {
      const double under = area_under(graph, side, s, is_straight(s.edge, problem));
      area += side == Side::hi ? under : -under;
    }
  }
  return area;
}

// If both ends of a slice are roots of the same limit, and the slice is narrower than this,
// modules, the slice counts as a point. At coinciding roots, the error of a root is the square root
// of the rounding error of Σ.
constexpr double kPinch = 2e-6;
// Returns a slice at an end of a piece. If the limit of the path length determines both ends of the
// slice, the point with the longest path replaces the slice. This point is exact except for
// rounding. The error of the two ends would be the square root of the rounding error.
ShiftSlice end_slice(const ShiftGraph& graph, double sum) {
  ShiftSlice s = graph.slice(sum);
  if (s.lo_edge == ShiftEdge::eps && s.hi_edge == ShiftEdge::eps) {
    const SumPlace at = graph.place(sum);
    s.lo = s.hi = graph.longest_path(at, sum, graph.ends_before_path(at, sum)).x1;
  } else if (s.lo > s.hi || (s.lo_edge == s.hi_edge && s.hi - s.lo < kPinch)) {
    s.lo = s.hi = s.middle();
  }
  return s;
}

// Returns the smallest margin at a point over the bounds of x1 and the path length. Σ of the point
// must lie within the range of a piece.
double margin_on_line(const ShiftGraph& graph, const Vec2& p) {
  const double sum = p[0] + p[1];
  const SumPlace at = graph.place(sum);
  const LineEnds s = graph.ends_before_path(at, sum);
  const double path = graph.path_length(at, sum, p[0]) - graph.min_path();
  return std::min({p[0] - s.lo, s.hi - p[0], path});
}

// Appends an edge to a loop. If the last edge of the loop has the same name, both edges are joined.
void append(std::vector<RegionEdge>& loop, RegionEdge next) {
  if (!loop.empty() && loop.back().edge == next.edge) {
    auto& points = loop.back().points;
    points.insert(points.end(), next.points.begin() + 1, next.points.end());
  } else {
    loop.push_back(std::move(next));
  }
}

}  // namespace

std::optional<ShiftRegion> shift_region(const ShiftGraph& graph, RegionDetail detail,
                                        OffWalls off_walls) {
  ShiftRegion region;
  region.detail = detail;
  region.sums = graph.feasible_sums();
  if (region.sums.empty()) return std::nullopt;
  const auto ends = [&](double sum) {
    const ShiftSlice s = end_slice(graph, sum);
    return std::array<Vec2, 2>{point(sum, s.lo), point(sum, s.hi)};
  };
  region.lo_edge = ends(region.sums.front().lo);
  region.hi_edge = ends(region.sums.back().hi);
  region.lo = (region.lo_edge[0] + region.lo_edge[1]) / 2.0;
  region.hi = (region.hi_edge[0] + region.hi_edge[1]) / 2.0;

  const SearchProblem& problem = graph.problem();
  const Trial& t = graph.trial();
  const auto margin = [&](double sum) {
    return margin_on_line(graph, balanced_point(t.z1, t.z2, sum, problem.lambda));
  };
  for (const Interval& piece : region.sums) {
    if (detail == RegionDetail::whole) region.area += area_of(graph, problem, piece);
    if (line_is_outside(graph, piece.lo, piece.hi)) continue;
    const auto on_line =
        where_not_negative_or_touching(margin, piece.lo, piece.hi, kTouching, {.bend = kMostBend});
    region.balanced_sums.insert(region.balanced_sums.end(), on_line.begin(), on_line.end());
  }
  if (const auto sum = nearest_zero(region.balanced_sums))
    region.balanced = balanced_point(t.z1, t.z2, *sum, problem.lambda);
  if (off_walls == OffWalls::sought) region.off_walls = point_off_walls(graph);
  return region;
}

std::vector<std::vector<RegionEdge>> region_boundary(const ShiftGraph& graph,
                                                     const ShiftRegion& region) {
  constexpr int kCurvePoints = 25;
  const SearchProblem& problem = graph.problem();
  const ShiftGraph::Sums range = graph.sums();
  std::vector<std::vector<RegionEdge>> loops;
  for (const Interval& piece : region.sums) {
    std::vector<RegionEdge> loop;
    const auto along = [&](Side side, bool downwards) {
      if (!(piece.lo < piece.hi)) return;
      auto parts = stretches(graph, side, piece);
      if (downwards) std::reverse(parts.begin(), parts.end());
      for (const Stretch& s : parts) {
        const int n = is_straight(s.edge, problem) ? 2 : kCurvePoints;
        RegionEdge e{s.edge, {}};
        for (int i = 0; i < n; ++i) {
          const int step = downwards ? n - 1 - i : i;
          const double sum = step == 0 ? s.from
                             : step == n - 1
                                 ? s.to
                                 : sum_at(s.from, s.to, std::numbers::pi * step / (n - 1));
          const bool at_end = sum == piece.lo || sum == piece.hi;
          const ShiftSlice slice = at_end ? end_slice(graph, sum) : graph.slice(sum);
          e.points.push_back(point(sum, value_of(slice, side)));
        }
        append(loop, std::move(e));
      }
    };
    const auto across = [&](double sum, bool lower) {
      const ShiftSlice s = end_slice(graph, sum);
      if (!(s.hi - s.lo > kTouching)) return;
      const bool at_range = std::abs(sum - (lower ? range.lo : range.hi)) <= kSameRegionEnd;
      const ShiftEdge edge = at_range ? (lower ? range.lo_edge : range.hi_edge)
                                      : graph.sum_margin(graph.place(sum), sum).edge;
      const double from = lower ? s.lo : s.hi;
      const double to = lower ? s.hi : s.lo;
      loop.push_back({edge, {point(sum, from), point(sum, to)}});
    };
    across(piece.lo, true);
    along(Side::hi, false);
    across(piece.hi, false);
    along(Side::lo, true);
    loops.push_back(std::move(loop));
  }
  return loops;
}

}  // namespace gearwright
