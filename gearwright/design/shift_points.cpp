#include "gearwright/design/shift_points.hpp"

#include <algorithm>
#include <cmath>

#include "gearwright/base/contract.hpp"
#include "gearwright/design/candidate.hpp"
#include "gearwright/design/design_row.hpp"

namespace gearwright {

namespace {

CandidateConstants constants_of(const ShiftGraph& graph) {
  const SearchProblem& p = graph.problem();
  CandidateConstants c;
  c.tan_alpha = std::tan(p.normal_pressure_angle.rad());
  for (std::size_t i : {0, 1}) {
    c.addendum[i] = graph.gears()[i].addendum;
    c.dedendum[i] = graph.gears()[i].dedendum;
    c.edge_depth[i] = graph.gears()[i].edge_depth;
    c.flank_depth[i] = graph.gears()[i].flank_depth;
  }
  c.tight = p.mounting == Mounting::tight;
  c.shorten = p.shorten_tips;
  return c;
}

enum class Verdict { inside, outside, ask };

// Compares one candidate with all limits. If a value is NaN, the filter cannot decide, and the
// graph must decide.
Verdict judge(const SearchLimits& limits, const CandidateBatch& b, std::size_t i) {
  bool ask = false;
  bool out = false;
  const auto compare = [&](double margin, double doubt) {
    if (margin < -doubt) {
      out = true;
    } else if (!(margin > doubt)) {
      ask = true;
    }
  };
  const auto at_least = [&](CandidateBatch::Out column, double limit) {
    compare(b.out[column][i] - limit, kSieveDoubt);
  };
  // The residual of inv α_wt divided by tan² α_wt is the error of α_wt, because the derivative of
  // inv α is tan² α.
  const double tan_w = b.out[CandidateBatch::tan_working][i];
  if (!(b.out[CandidateBatch::residual][i] < 0.01 * kSieveDoubt * tan_w * tan_w)) ask = true;
  at_least(CandidateBatch::contact_ratio, limits.contact_ratio);
  at_least(CandidateBatch::contact_ratio_true, limits.contact_ratio);
  at_least(CandidateBatch::tip_1, limits.tip_thickness);
  at_least(CandidateBatch::tip_2, limits.tip_thickness);
  if (limits.tip_clearance) {
    at_least(CandidateBatch::clearance_1, *limits.tip_clearance);
    at_least(CandidateBatch::clearance_2, *limits.tip_clearance);
  }
  if (limits.avoid_interference) {
    at_least(CandidateBatch::interference_1, limits.form_clearance);
    at_least(CandidateBatch::interference_2, limits.form_clearance);
  }
  if (limits.sliding)
    compare(*limits.sliding - b.out[CandidateBatch::sliding][i],
            kSieveDoubt * (1.0 + *limits.sliding));
  // If one limit rejects a candidate, the candidate is outside, even if another limit is undecided.
  return out ? Verdict::outside : ask ? Verdict::ask : Verdict::inside;
}

ShiftPoint point_at(const ShiftGraph& graph, double x1, double x2) {
  const DesignRow row = row_at(graph, {x1, x2});
  return {graph.trial().index, row.shift,         row.center_distance,
          row.working_angle,   row.contact_ratio, row.contact_ratio_true,
          row.max_sliding(),   row.tip_thickness, row.tip_clearance,
          row.backlash_normal, row.interference};
}

}  // namespace

PointCounts feasible_points(const ShiftGraph& graph, const ShiftRegion& region, double step,
                            std::vector<ShiftPoint>& points) {
  GW_EXPECTS(step > 0.0 && !region.sums.empty());
  const SearchProblem& p = graph.problem();
  const std::array<TrialGear, 2>& g = graph.gears();
  const CandidateConstants constants = constants_of(graph);
  const double sum_lo = region.sums.front().lo;
  const double sum_hi = region.sums.back().hi;
  // Gears with shortened tips may have greater shifts than gears with full tips.
  const double k = p.shorten_tips ? std::min(graph.place(sum_lo).k, graph.place(sum_hi).k) : 0.0;
  const double x1_hi = max_shift(p, g[0], k);
  const double x2_hi = max_shift(p, g[1], k);
  const auto first = [&](double lo) { return std::ceil((lo - kTouching) / step); };
  const auto last = [&](double hi) { return std::floor((hi + kTouching) / step); };

  PointCounts counts;
  CandidateBatch batch;
  batch.resize(kBatch);
  std::size_t n = 0;
  const double sin_beta = std::sin(graph.trial().helix[0].rad());
  const auto flush = [&] {
    batch.resize(n);
    if (!p.crossed()) evaluate(constants, batch);
    for (std::size_t i = 0; i < n; ++i) {
      const double x1 = batch.in[CandidateBatch::x1][i];
      const double x2 = batch.in[CandidateBatch::x2][i];
      Verdict verdict = p.crossed() ? Verdict::ask : judge(p.limits, batch, i);
      // The region excludes tips inside their own reference circle (section 9.3). The batch does
      // not check this, so the graph decides about such points.
      const double low = std::min(g[0].addendum + x1, g[1].addendum + x2) + graph.place(x1 + x2).k;
      if (p.limits.avoid_interference && low < 0.0 && verdict == Verdict::inside)
        verdict = Verdict::ask;
      if (verdict == Verdict::ask) {
        ++counts.asked;
        verdict = graph.margin(x1, x2) >= -kTouching ? Verdict::inside : Verdict::outside;
      }
      if (verdict != Verdict::inside) continue;
      ++counts.feasible;
      points.push_back(point_at(graph, x1, x2));
    }
    counts.tested += static_cast<std::int64_t>(n);
    n = 0;
    batch.resize(kBatch);
  };
  for (double i = first(g[0].x_min); i <= last(x1_hi); ++i) {
    const double x1 = i * step;
    const double from = first(std::max(g[1].x_min, sum_lo - x1));
    const double to = last(std::min(x2_hi, sum_hi - x1));
    for (double j = from; j <= to; ++j) {
      const double values[CandidateBatch::kIn] = {static_cast<double>(graph.trial().z1),
                                                  static_cast<double>(graph.trial().z2), sin_beta,
                                                  x1, j * step};
      for (std::size_t c = 0; c < CandidateBatch::kIn; ++c) batch.in[c][n] = values[c];
      if (++n == kBatch) flush();
    }
  }
  flush();
  return counts;
}

}  // namespace gearwright
