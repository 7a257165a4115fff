// Helpers that the tests of the search share: the reference computed with 40 digits, problems made
// from it, and random problems of every kind from a seeded generator.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <numbers>
#include <optional>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "gearwright/base/testing/source_file.hpp"
#include "gearwright/design/search.hpp"

namespace gearwright::testing::search {

inline const std::vector<double> kSeriesI{1, 1.25, 1.5, 2,  2.5, 3,  4,  5,  6,
                                          8, 10,   12,  16, 20,  25, 32, 40, 50};

/// Tolerance for modules and their squares. The reference prints 25 digits.
inline constexpr double kPrinted = 1e-12;

inline const nlohmann::json& reference() {
  static const nlohmann::json file =
      nlohmann::json::parse(std::ifstream(testing::source_file("tests/oracle/spur_searches.json")));
  return file;
}

inline double number(const nlohmann::json& value) {
  return value.is_string() ? std::stod(value.get<std::string>()) : value.get<double>();
}

/// α_n = 20°, extended centres, and the limits of a region or a search of the reference.
inline SearchProblem problem_of(const nlohmann::json& input) {
  SearchProblem p;
  const auto optional = [](const nlohmann::json& v) {
    return v.is_null() ? std::nullopt : std::optional(number(v));
  };
  p.limits.min_shift = optional(input.at("limits").at("floor"));
  p.limits.max_shift = optional(input.at("limits").at("ceil"));
  p.limits.tip_thickness = number(input.at("limits").at("sa_min"));
  p.limits.contact_ratio = number(input.at("eps_min"));
  return p;
}

/// The problem of one region, with one module and one pair.
inline SearchProblem problem_of_region(const nlohmann::json& input) {
  SearchProblem p = problem_of(input);
  p.center_distance = {{number(input.at("Cmin")), number(input.at("Cmax"))}};
  p.modules = {number(input.at("m"))};
  return p;
}

inline SearchProblem problem_of_search(const nlohmann::json& input) {
  SearchProblem p = problem_of(input);
  const auto& c = input.at("C");
  p.ratio = {number(input.at("ratio")[0]), number(input.at("ratio")[1])};
  p.center_distance = {{number(c[0]), number(c[1])}};
  p.modules = kSeriesI;
  p.pinion_teeth = {input.at("z1")[0], input.at("z1")[1]};
  p.coprime = input.at("coprime");
  p.target_ratio = number(input.at("target_ratio"));
  return p;
}

/// A search at tight centres with helix angles of both hands, several racks and several modules.
inline SearchProblem helical_search() {
  SearchProblem p;
  p.ratio = {1.8, 2.4};
  p.center_distance = {{60.0, 62.0}};
  p.modules = {1.5, 2.0, 2.5};
  p.pinion_teeth = {12, 24};
  p.helix = {Angle(), Angle::radians(0.2), Angle::radians(-0.3)};
  p.racks = {SearchRacks{}, SearchRacks{}};
  p.racks[1].rack[0].addendum = p.racks[1].rack[1].addendum = 1.1;
  p.mounting = Mounting::tight;
  p.limits.min_shift = -0.5;
  p.limits.sliding = 6.0;
  p.target_ratio = 2.0;
  return p;
}

/// One pair of a problem, with its first helix angle and rack; m in mm.
inline Trial trial(const SearchProblem& p, int z1, int z2, double m = 1.0) {
  const Angle beta = p.helix[0];
  const Angle mate = p.crossed() ? *p.shaft_angle - beta : z2 < 0 ? beta : -beta;
  return {0, m, z1, z2, {beta, mate}, 0};
}

/// The graph of a problem. The problem must outlive the graph.
inline ShiftGraph graph(const SearchProblem& p, const Trial& t) {
  return ShiftGraph(p, t, trial_gear(p, t.z1, t.helix[0], t.rack, 0),
                    trial_gear(p, t.z2, t.helix[1], t.rack, 1));
}

/// True if there is a working angle. Teeth have one if they can mesh without backlash (tight
/// centres), or if they can mesh at all (extended centres). Crossed axes always have one.
inline bool has_working_angle(const ShiftGraph& graph, double sum) {
  const SearchProblem& p = graph.problem();
  const Trial& t = graph.trial();
  if (p.crossed()) return true;
  const auto& [g_1, g_2] = graph.gears();
  if (p.mounting == Mounting::extended)
    return std::abs(g_1.r + g_2.r + sum) > (1.0 + 1e-12) * std::abs(g_1.r_b + g_2.r_b);
  const double alpha_t = std::asin(g_1.sin_transverse);
  return nominal_working_involute(t.z1, t.z2, p.normal_pressure_angle.rad(), alpha_t, sum) > 1e-12;
}

/// The smallest margin of a point to all limits, in the unit of the nearest limit. It is computed
/// from the results of mounting the pair (row_at) and from the undercut of each gear, not from the
/// margins of the graph. It is −1 if there is no working angle, if a tip lies inside its base
/// circle, if the overlap ratio is too small, if sliding is limited but has no value, or if
/// interference is forbidden but exists.
inline double margin_by_numbers(const ShiftGraph& graph, double x1, double x2) {
  const SearchProblem& p = graph.problem();
  const SearchLimits& limits = p.limits;
  const double m = graph.trial().module;
  if (!has_working_angle(graph, x1 + x2)) return -1.0;
  double least = std::numeric_limits<double>::infinity();
  const auto keep = [&](double margin) { least = std::min(least, margin); };
  const DesignRow row = row_at(graph, {x1, x2});
  for (const std::size_t i : {0, 1}) {
    const TrialGear& g = graph.gears()[i];
    const double x = row.shift[i];
    if (std::abs(g.r + g.addendum + x + row.tip_alteration / m) < std::abs(g.r_b)) return -1.0;
    if (g.teeth > 0) {
      keep(x - limits.undercut_margin -
           leaf::undercut_limit<double>(g.edge_depth, g.teeth, g.sin_transverse,
                                        std::cos(graph.trial().helix[i].rad())));
    }
    if (limits.min_shift) keep(x - *limits.min_shift);
    if (limits.max_shift) keep(*limits.max_shift - x);
    keep(row.tip_thickness[i] / m - limits.tip_thickness);
    if (limits.tip_clearance) keep(row.tip_clearance[i] / m - *limits.tip_clearance);
  }
  if (p.center_distance) {
    keep((row.center_distance - (*p.center_distance)[0]) / m);
    keep(((*p.center_distance)[1] - row.center_distance) / m);
  }
  keep(row.contact_ratio - limits.contact_ratio);
  keep(row.contact_ratio_true - limits.contact_ratio);
  if (limits.overlap_ratio && row.overlap_ratio < *limits.overlap_ratio) return -1.0;
  if (limits.sliding && !p.crossed()) {
    if (!row.max_sliding()) return -1.0;
    keep(*limits.sliding - *row.max_sliding());
  }
  if (limits.avoid_interference && row.interference) return -1.0;
  if (limits.avoid_interference && limits.form_clearance > 0.0) {
    for (const auto& clearance : row.form_clearance)
      if (clearance) keep(*clearance / m - limits.form_clearance);
  }
  return least;
}

/// Mountings that the formulas treat differently.
struct Kind {
  const char* name;
  bool ring, tight, shorten, helical, crossed;
};
inline constexpr std::array<Kind, 8> kKinds{{{"extended", false, false, false, false, false},
                                             {"tight", false, true, false, false, false},
                                             {"shortened", false, true, true, true, false},
                                             {"helical", false, false, false, true, false},
                                             {"ring", true, false, false, false, false},
                                             {"tight ring", true, true, false, true, false},
                                             {"shortened ring", true, true, true, false, false},
                                             {"crossed", false, false, false, true, true}}};

class Random {
 public:
  explicit Random(unsigned seed) : bits_(seed) {}
  double uniform(double lo, double hi) { return lo + (hi - lo) * (bits_() / 4294967296.0); }
  int whole(int lo, int hi) {
    return lo + static_cast<int>(bits_() % static_cast<unsigned>(hi - lo + 1));
  }
  bool chance(double p) { return uniform(0.0, 1.0) < p; }

 private:
  std::mt19937 bits_;
};

/// A problem and one of its pairs, m = 1. Limits of every kind occur in some of the problems. The
/// band of centre distances is close to the reference centre distance.
struct RandomTrial {
  SearchProblem problem;
  Trial trial;
};
inline RandomTrial random_trial(Random& random, const Kind& kind) {
  SearchProblem p;
  const int z1 = random.whole(8, 40);
  const int z2 = kind.ring ? -random.whole(z1 + 8, z1 + 80) : random.whole(z1, z1 + 60);
  p.ratio = {static_cast<double>(z2) / z1, static_cast<double>(z2) / z1};
  p.pinion_teeth = {z1, z1};
  p.modules = {1.0};
  p.normal_pressure_angle = Angle::radians(random.uniform(17.0, 25.0) * std::numbers::pi / 180.0);
  if (kind.helical)
    p.helix = {Angle::radians(random.uniform(5.0, 30.0) * std::numbers::pi / 180.0)};
  if (kind.crossed) p.shaft_angle = p.helix[0] + Angle::radians(random.uniform(0.2, 0.9));
  p.mounting = kind.tight ? Mounting::tight : Mounting::extended;
  p.shorten_tips = kind.shorten;
  SearchLimits& l = p.limits;
  if (kind.ring || random.chance(0.6)) l.min_shift = random.uniform(-0.7, 0.0);
  if (kind.ring || random.chance(0.6)) l.max_shift = random.uniform(0.3, 1.0);
  if (random.chance(0.3)) l.undercut_margin = random.uniform(-0.6, 0.2);
  l.tip_thickness = random.uniform(0.0, 0.4);
  l.contact_ratio = random.uniform(1.0, 1.7);
  if (!kind.crossed && random.chance(0.5)) l.sliding = random.uniform(0.5, 4.0);
  if (random.chance(0.4)) l.tip_clearance = random.uniform(0.15, 0.249);
  l.avoid_interference = random.chance(0.5);
  // Far below the reference circle, a tip no longer touches the mating gear's fillet. The graph
  // does not include this branch.
  if (l.avoid_interference && !l.min_shift) l.min_shift = random.uniform(-0.6, 0.0);
  const Trial t = trial(p, z1, z2);
  const double R =
      z1 / (2.0 * std::cos(t.helix[0].rad())) + z2 / (2.0 * std::cos(t.helix[1].rad()));
  const double least = std::abs(R) + random.uniform(-1.0, 1.0);
  p.center_distance = {{least, random.chance(0.3) ? least : least + random.uniform(0.0, 0.5)}};
  return {std::move(p), t};
}

}  // namespace gearwright::testing::search
