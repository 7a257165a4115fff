// The loops of the search. For each trial, the limits of the shifts and of the centre distance
// leave intervals of x_1, x_2 and S. It remains to be found whether the smallest of the other
// margins is ≥ 0 anywhere in these intervals. The cell of (S, x_1) with the greatest bound
// (plain_cells.hpp) is halved repeatedly, until a point in it satisfies all limits or the greatest
// bound is negative.
#include "tests/oracle/plain_search.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <queue>

#include "tests/oracle/plain_cells.hpp"
#include "tests/oracle/require.hpp"

namespace gearwright::oracle {
namespace {

using plain::Box;
using plain::Cell;
using plain::contact_margin;
using plain::Interval;
using plain::Pair;
using Real = long double;

constexpr Real kSure = 1e-9L;  // modules or ratio; a value closer to zero is undecided
constexpr int kMaxCells = 200000;
constexpr Real kNothing = -PlainMargins::kFree;

bool close_call(Real gap) { return gap != 0 && std::abs(gap) <= kSure; }

struct Found {
  PlainVerdict verdict = PlainVerdict::empty;
  Real min_margin = kNothing;
  Real x1 = std::nanl(""), x2 = std::nanl("");
};

/// The maximum of the smallest margin in the box, with the accuracy that its sign requires.
Found search_box(const Pair& pair, const Box& box) {
  Found best;
  const auto try_point = [&](Real sum, Real x1) {
    const Interval range = box.x1_at(sum);
    x1 = std::clamp(x1, range.low, range.high);
    const Real margin = contact_margin(pair, x1, sum - x1);
    if (margin > best.min_margin) best = {best.verdict, margin, x1, sum - x1};
  };
  const auto less = [](const Cell& a, const Cell& b) { return a.max < b.max; };
  std::priority_queue<Cell, std::vector<Cell>, decltype(less)> open(less);
  const auto look_into = [&](Cell cell) {
    try_point(cell.s.middle(), cell.x1.middle());
    if (cell.s.length() > 0)
      for (const Real x1 : {cell.x1.low, cell.x1.high}) try_point(cell.s.high, x1);
    for (const Real x1 : {cell.x1.low, cell.x1.high}) try_point(cell.s.low, x1);
    cell.max = plain::upper_bound(pair, box, cell);
    open.push(cell);
  };
  look_into({box.s, box.x1});
  for (int cells = 1; cells < kMaxCells; cells += 2) {
    if (best.min_margin > kSure) return best.verdict = PlainVerdict::not_empty, best;
    const Cell cell = open.top();
    if (cell.max < -kSure) return best.verdict = PlainVerdict::empty, best;
    if (cell.max <= kSure && best.min_margin >= -kSure) break;
    open.pop();
    Cell left = cell, right = cell;
    if (cell.s.length() >= cell.x1.length())
      left.s.high = right.s.low = cell.s.middle();
    else
      left.x1.high = right.x1.low = cell.x1.middle();
    look_into(left);
    look_into(right);
  }
  return best.verdict = PlainVerdict::ambiguous, best;
}

struct Boxes {
  std::vector<Box> boxes;
  std::string killed_by;  // the limit, if there is no point
  // The limits of the shift of a single gear overlap, or are separated by less than kSure.
  bool close_call = false;
};

Boxes boxes_of(const Pair& pair, Real m, Real c_min, Real c_max) {
  Boxes result;
  const plain::Pieces x1 = plain::shifts_1(pair);
  const std::optional<Interval> band = pair.shift_sums({c_min / m, c_max / m});
  plain::Pieces x2;
  if (!x1.held.empty())
    x2 = plain::shifts_2(pair, band ? band->low - x1.held.back().high - 1 : -1,
                         band ? band->high - x1.held.front().low + 1 : 1);
  result.close_call = x1.close_call || x2.close_call;
  if (x1.held.empty() || x2.held.empty()) return result.killed_by = "shift_limits", result;
  result.killed_by = "center_distance";
  if (!band) return result;
  for (const Interval a : x1.held)
    for (const Interval b : x2.held) {
      Interval s{std::max(band->low, a.low + b.low), std::min(band->high, a.high + b.high)};
      if (s.low > s.high + kSure) continue;
      const Interval domain = pair.shift_sum_domain();
      s = {std::max(s.low, domain.low), std::min(s.high, domain.high)};
      if (s.low > s.high + kSure)
        result.killed_by = "contact_ratio";  // Eq. 10 has no value
      else
        result.boxes.push_back({s, a, b});
    }
  return result;
}

}  // namespace

PlainAnswer region_not_empty(const PlainProblem& problem, Real m, int z1, int z2, Real c_min,
                             Real c_max) {
  require(m > 0 && c_min <= c_max, "m, c_min, c_max: must be > 0 and in order");
  const Pair pair(problem, z1, z2);
  const Boxes all = boxes_of(pair, m, c_min, c_max);
  Found best;
  for (Box box : all.boxes) {
    const Real middle = box.s.middle();
    const bool close = close_call(box.s.length()) || close_call(box.x1.length()) ||
                       close_call(box.x2.length()) || close_call(box.x1_at(middle).length());
    if (box.s.low > box.s.high) box.s = {middle, middle};
    Found found = search_box(pair, box);
    if (found.verdict == PlainVerdict::not_empty && close) found.verdict = PlainVerdict::ambiguous;
    const auto rank = [](const Found& f) {
      return f.verdict == PlainVerdict::not_empty ? 2 : f.verdict == PlainVerdict::ambiguous;
    };
    if (std::pair(rank(found), found.min_margin) > std::pair(rank(best), best.min_margin))
      best = found;
  }
  if (best.verdict == PlainVerdict::empty && all.close_call) best.verdict = PlainVerdict::ambiguous;

  std::string killed_by;
  if (best.verdict == PlainVerdict::empty) {
    killed_by = all.killed_by;
    if (!all.boxes.empty()) {
      PlainProblem ratio_alone = problem;
      ratio_alone.sliding_max = ratio_alone.clearance_min = std::nullopt;
      ratio_alone.avoid_interference = false;
      const Pair bare(ratio_alone, z1, z2);
      const bool other = std::any_of(all.boxes.begin(), all.boxes.end(), [&](const Box& box) {
        return search_box(bare, box).verdict != PlainVerdict::empty;
      });
      killed_by = other ? "other" : "contact_ratio";
    }
  }
  return {best.verdict, killed_by, best.min_margin, best.x1, best.x2};
}

namespace {

/// In one box, the x_1 for a given S that satisfy all margins.
struct Slice {
  Real length = 0;
  std::optional<Interval> ends;  // absent if empty
};

Slice slice_at(const Pair& pair, const Box& box, Real sum) {
  constexpr int kSamples = 48;
  const Interval range = box.x1_at(sum);
  const auto margin = [&](Real x1) { return contact_margin(pair, x1, sum - x1); };
  std::vector<Real> nodes;
  for (int i = 0; i <= kSamples; ++i) nodes.push_back(range.at(i / Real(kSamples)));
  // The best point is added as a node, because the interval around it may be narrower than the
  // distance of the samples.
  Real best = range.low, most = margin(best);
  for (Real width = range.length(); width > 1e-17L; width /= 8) {
    const Real centre = width == range.length() ? range.middle() : best;
    for (int i = -8; i <= 8; ++i) {
      const Real x = std::clamp(centre + i * width / 16, range.low, range.high);
      const Real here = margin(x);
      if (here > most) best = x, most = here;
    }
  }
  nodes.push_back(best);
  std::sort(nodes.begin(), nodes.end());
  Slice slice;
  for (const Interval held : plain::where_not_negative(margin, nodes)) {
    slice.length += held.length();
    slice.ends = {slice.ends ? slice.ends->low : held.low, held.high};
  }
  return slice;
}

}  // namespace

std::optional<PlainRegion> measure_region(const PlainProblem& problem, Real m, int z1, int z2,
                                          Real c_min, Real c_max, int slices) {
  const PlainAnswer answer = region_not_empty(problem, m, z1, z2, c_min, c_max);
  if (answer.verdict != PlainVerdict::not_empty) return std::nullopt;
  const Pair pair(problem, z1, z2);
  std::optional<PlainRegion> region;
  for (const Box& box : boxes_of(pair, m, c_min, c_max).boxes) {
    const auto there = [&](Real sum) { return slice_at(pair, box, sum).ends.has_value(); };
    std::vector<Real> nodes;
    for (int i = 0; i <= 100; ++i) nodes.push_back(box.s.at(i / 100.0L));
    const Real witness = answer.x1 + answer.x2;
    if (witness > box.s.low && witness < box.s.high) nodes.push_back(witness);
    std::sort(nodes.begin(), nodes.end());
    const auto held =
        plain::where_not_negative([&](Real sum) { return there(sum) ? 1.0L : -1.0L; }, nodes);
    if (held.empty()) continue;
    const Real low = held.front().low, high = held.back().high;
    Real area = 0;
    for (int i = 0; i < slices; ++i)
      area += slice_at(pair, box, low + (high - low) * (i + 0.5L) / slices).length;
    area *= (high - low) / slices;

    if (!region) region = PlainRegion{0, PlainMargins::kFree, kNothing, {}, {}, {}, {}};
    region->area += area;
    const auto point = [](Real sum, Real x1) { return std::array<Real, 2>{x1, sum - x1}; };
    if (low < region->s_lo) {
      const Interval ends = *slice_at(pair, box, region->s_lo = low).ends;
      region->lo_edge = {point(low, ends.low), point(low, ends.high)};
      region->lo = point(low, ends.middle());
    }
    if (high > region->s_hi) {
      const Interval ends = *slice_at(pair, box, region->s_hi = high).ends;
      region->hi_edge = {point(high, ends.low), point(high, ends.high)};
      region->hi = point(high, ends.middle());
    }
  }
  return region;
}

PlainSearch plain_search(const PlainProblem& problem, const std::vector<double>& modules,
                         PlainBand ratio, std::array<int, 2> z1_band, PlainBand center_distance,
                         bool coprime) {
  constexpr Real kRatioSlack = 1e-12L;
  require(ratio.low <= ratio.high && (ratio.low > 0 || ratio.high < 0),
          "ratio: must be in order and without 0");
  PlainSearch result;
  const bool rings = ratio.high < 0;
  const Real greatest = std::max(std::abs(ratio.low), std::abs(ratio.high));
  for (const double module : modules)
    for (int z1 = z1_band[0]; z1 <= z1_band[1]; ++z1)
      for (int teeth = rings ? z1 + 1 : z1; teeth <= greatest * z1 + 1; ++teeth) {
        const int z2 = rings ? -teeth : teeth;
        const Real achieved = Real(z2) / z1;
        if (achieved < ratio.low - kRatioSlack || achieved > ratio.high + kRatioSlack) continue;
        if (coprime && std::gcd(z1, teeth) != 1) continue;
        ++result.tested;
        const PlainAnswer answer =
            region_not_empty(problem, module, z1, z2, center_distance.low, center_distance.high);
        if (answer.verdict == PlainVerdict::not_empty)
          result.designs.emplace_back(module, z1, z2);
        else if (answer.verdict == PlainVerdict::ambiguous)
          result.ambiguous.emplace_back(module, z1, z2);
        else
          ++result.rejected[answer.killed_by];
      }
  return result;
}

}  // namespace gearwright::oracle
