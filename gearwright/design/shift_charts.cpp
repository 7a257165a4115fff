#include "gearwright/design/shift_charts.hpp"

#include <cmath>

#include "gearwright/base/contract.hpp"
#include "gearwright/design/design_row.hpp"
#include "gearwright/design/shift_graph.hpp"
#include "gearwright/design/trial_gear.hpp"

namespace gearwright {

namespace {

// Returns the problem with the tip thickness as the only limit of the shifts.
SearchProblem with_tip(const SearchProblem& problem, double thickness) {
  SearchProblem asked = problem;
  asked.limits.min_shift.reset();
  asked.limits.max_shift.reset();
  asked.limits.tip_thickness = thickness;
  return asked;
}

}  // namespace

std::vector<ShiftLimits> shift_limit_chart(const SearchProblem& problem, int rack, Angle helix,
                                           int which, int from, int to) {
  GW_EXPECTS(1 <= from && from <= to);
  std::array<SearchProblem, kChartTips.size()> asked;
  for (std::size_t i = 0; i < kChartTips.size(); ++i) asked[i] = with_tip(problem, kChartTips[i]);
  std::vector<ShiftLimits> chart;
  for (int z = from; z <= to; ++z) {
    const TrialGear gear = trial_gear(problem, z, helix, rack, which);
    ShiftLimits row;
    row.teeth = z;
    row.undercut = leaf::undercut_limit<double>(gear.edge_depth, z, gear.sin_transverse,
                                                std::cos(helix.rad()));
    for (std::size_t i = 0; i < kChartTips.size(); ++i)
      row.tip[i] = trial_gear(asked[i], z, helix, rack, which).x_max;
    row.min = gear.x_min;
    row.max = gear.x_max;
    chart.push_back(row);
  }
  return chart;
}

std::optional<LimitsMeet> where_limits_meet(const std::vector<ShiftLimits>& chart,
                                            std::size_t tip) {
  for (std::size_t i = 1; i < chart.size(); ++i) {
    const ShiftLimits& a = chart[i - 1];
    const ShiftLimits& b = chart[i];
    const double room_a = a.tip[tip] - a.undercut;
    const double room_b = b.tip[tip] - b.undercut;
    if (!(room_a < 0.0 && room_b >= 0.0)) continue;
    const double share = room_a / (room_a - room_b);
    return LimitsMeet{a.teeth + share * (b.teeth - a.teeth),
                      a.undercut + share * (b.undercut - a.undercut), b.teeth};
  }
  return std::nullopt;
}

std::vector<IdenticalGears> identical_gears_chart(const SearchProblem& problem, int rack,
                                                  Angle helix, int from, int to) {
  SearchProblem free = problem;  // the problem without a centre distance, with one rack for both
                                 // gears
  free.center_distance.reset();
  free.shaft_angle.reset();
  free.ratio = {1.0, 1.0};
  free.racks = {problem.racks[static_cast<std::size_t>(rack)]};
  free.racks[0].rack[1] = free.racks[0].rack[0];
  free.racks[0].undercut_depth[1] = free.racks[0].undercut_depth[0];
  free.racks[0].flank_depth[1] = free.racks[0].flank_depth[0];
  free.limits.contact_ratio = 0.0;  // the only remaining condition is that a working pressure angle
                                    // exists

  std::vector<IdenticalGears> chart;
  for (const ShiftLimits& limits : shift_limit_chart(free, 0, helix, 0, from, to)) {
    IdenticalGears row;
    row.limits = limits;
    if (limits.min <= limits.max) {
      const Trial trial{0, 1.0, limits.teeth, limits.teeth, {helix, -helix}, 0};
      const TrialGear gear = trial_gear(free, limits.teeth, helix, 0, 0);
      const ShiftGraph graph(free, trial, gear, gear);
      const double min_sum = graph.sums(static_cast<int>(Limit::contact_ratio) + 1).lo;
      for (std::size_t k = 0; k < row.contact_ratio.size(); ++k) {
        const double share = static_cast<double>(k) / 4.0;
        const double x = limits.min + share * (limits.max - limits.min);
        if (2.0 * x < min_sum) continue;
        // With large negative shifts, shortened tips may end inside their base circles.
        if (gear.r + gear.addendum + x + graph.place(2.0 * x).k < gear.r_b) continue;
        row.contact_ratio[k] = row_at(graph, {x, x}).contact_ratio;
      }
    }
    chart.push_back(row);
  }
  return chart;
}

}  // namespace gearwright
