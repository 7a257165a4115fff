// Objectives of designs. Laws: (1) the efficiency is that of the mounted pair; (2) the loss of a
// spur design agrees with a count of its tooth pairs in contact along the path; (3) the balance is
// 1 if the load reserves are equal, and the safety factors are divided by their limits; (4) the
// cost is the mass times a power of the relative width, and is the mass if the exponent is 0; (5)
// the noise is the spread of the deflection over the counted contact lines, and it is 0 if the
// overlap ratio is a whole number greater than 0; (6) designs rank by each objective, and the front
// of three objectives contains exactly the designs that no other design dominates.
#include "gearwright/design/design_objectives.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <utility>
#include <vector>

#include "gearwright/design/design_strength.hpp"
#include "gearwright/design/testing/found_designs.hpp"

namespace gearwright {
namespace {

constexpr double kMu = 0.06;

SearchProblem ranked_wish(std::vector<Objective> objectives) {
  SearchProblem p;
  p.ratio = {2.0, 3.0};
  p.modules = {2.0, 3.0};
  p.pinion_teeth = {17, 26};
  p.center_distance = {{80.0, 95.0}};
  p.helix = {Angle(), Angle::degrees(14)};
  p.limits.avoid_interference = p.limits.clear_fillets = true;
  p.limits.tip_clearance = kRunningTipClearance;
  p.limits.form_clearance = kRunningFormClearance;
  p.rating = testing::search::load(120.0);
  p.friction = kMu;
  p.objectives = std::move(objectives);
  return p;
}

std::optional<double> mounted_efficiency(const SearchProblem& p, const DesignRow& row) {
  std::vector<Gear> gears;
  for (const std::size_t i : {0, 1}) {
    CylindricalSpec spec;
    spec.teeth = i == 0 ? row.trial.z1 : row.trial.z2;
    spec.normal_module = row.trial.module;
    spec.normal_pressure_angle = p.normal_pressure_angle;
    spec.helix_angle = row.trial.helix[i];
    spec.profile_shift = row.shift[i];
    spec.face_width = p.crossed() ? 1000.0 : row.face_width;  // wide faces do not clip the path
    spec.rack = rack_of(p, row.trial, i);
    gears.push_back(make_gear(spec).value());
  }
  PairSpec spec{.center_distance = row.center_distance};
  spec.shaft_angle = p.shaft_angle;
  spec.friction = kMu;
  const auto pair = mount(std::move(gears[0]), std::move(gears[1]), spec);
  const auto& found = pair.value().involute()->efficiency;
  return found ? found->gear1_drives : std::nullopt;
}

TEST(DesignObjectives, EfficiencyIsThatOfTheMountedPair) {  // (1)
  SearchProblem rings = ranked_wish({Objective::efficiency});
  rings.rating.reset();
  rings.ratio = {-4.0, -3.0};
  rings.center_distance.reset();
  rings.modules = {2.0};
  SearchProblem screws = rings;
  screws.ratio = {1.0, 2.0};
  screws.shaft_angle = Angle::degrees(90);
  screws.helix = {Angle::degrees(45)};
  screws.pinion_teeth = {17, 18};
  for (const SearchProblem& p : {ranked_wish({Objective::efficiency}), rings, screws}) {
    const auto rows = testing::search::points_of(p);
    ASSERT_GT(rows.size(), 20u);
    for (std::size_t n = 0; n < rows.size(); n += rows.size() / 20) {
      ASSERT_TRUE(rows[n].efficiency);
      EXPECT_NEAR(*rows[n].efficiency, mounted_efficiency(p, rows[n]).value_or(0.0), 1e-12);
    }
  }
}

TEST(DesignObjectives, LossesAreThoseOfTheToothPairsInContact) {  // (2)
  SearchProblem p = ranked_wish({Objective::efficiency});
  p.helix = {Angle()};
  for (const DesignRow& row : testing::search::points_of(p)) {
    // Adds the input power and the output power at 20 000 positions of a pitch. All tooth pairs in
    // contact have equal forces.
    const double alpha = row.working_angle.rad();
    const double d_w1 = 2 * row.center_distance / (1 + row.ratio);
    const std::array r_b{d_w1 / 2 * std::cos(alpha), row.ratio * d_w1 / 2 * std::cos(alpha)};
    const double whole = row.center_distance * std::sin(alpha);
    const auto tip = [&](std::size_t i) {
      const double z = i == 0 ? row.trial.z1 : row.trial.z2;
      const double r = row.trial.module * (z / 2 + 1.0 + row.shift[i]);
      return std::sqrt(r * r - r_b[i] * r_b[i]);
    };
    const double begin = whole - tip(1), end = tip(0);
    const double pitch = 2 * std::numbers::pi * r_b[0] / row.trial.z1;
    double in = 0.0, out = 0.0;
    constexpr int kSteps = 20000;
    for (int n = 0; n < kSteps; ++n) {
      std::vector<double> touching;
      for (double rho = begin + (n + 0.5) / kSteps * pitch; rho < end; rho += pitch)
        touching.push_back(rho);
      for (const double rho : touching) {
        const double v_1 = rho, v_2 = (whole - rho) / row.ratio;  // at 1 rad/s
        const double side = v_1 > v_2 ? 1.0 : -1.0;
        const auto share = 1.0 / static_cast<double>(touching.size());
        in += share * (r_b[0] + kMu * side * v_1);
        out += share * (r_b[0] + kMu * side * v_2);
      }
    }
    EXPECT_NEAR(*row.efficiency, out / in, 2e-6) << row.trial.index;
  }
}

TEST(DesignObjectives, BalanceComparesLoads) {  // (3)
  SearchProblem p;
  DesignRow row;
  EXPECT_FALSE(load_balance(p, row));
  row.flank_safety = {1.2, 1.5};  // the flanks carry 1.44 of the load
  row.root_safety = {1.44, 1.44};
  EXPECT_NEAR(*load_balance(p, row), 1.0, 1e-15);
  row.root_safety = {1.44, 2.88};
  EXPECT_NEAR(*load_balance(p, row), 2.0, 1e-15);
  p.limits.safety_root = 1.44;
  p.limits.safety_flank = 1.2;
  EXPECT_NEAR(*load_balance(p, row), 2.0, 1e-15);
  p.limits.safety_flank = 0.6;  // the flanks could carry four times the load
  EXPECT_NEAR(*load_balance(p, row), 4.0, 1e-15);
  row.root_safety[1].reset();
  EXPECT_FALSE(load_balance(p, row));
}

TEST(DesignObjectives, CostIsMassTimesWidth) {  // (4)
  SearchProblem p = ranked_wish({Objective::cost});
  p.rating.reset();
  for (const DesignRow& row : testing::search::points_of(p)) {
    const double d_1 = row.trial.module * row.trial.z1 / std::cos(row.trial.helix[0].rad());
    EXPECT_DOUBLE_EQ(relative_cost(p, row), row.mass * std::sqrt(row.face_width / d_1));
    p.cost_exponent = 0.0;
    EXPECT_EQ(relative_cost(p, row), row.mass);
    p.cost_exponent = 0.5;
  }
}

TEST(DesignObjectives, NoiseIsTheSpreadOfTheDeflection) {  // (5)
  const SearchProblem p = ranked_wish({Objective::noise});
  const Search search(p);
  const auto rows = testing::search::points_of(p);
  ASSERT_GT(rows.size(), 40u);
  for (const DesignRow& row : rows) {
    const Rating r =
        rate(mounted_design(search.graph(row.trial), row).value(), p.rating->input).value();
    const double overlap = row.overlap_ratio, path = row.contact_ratio_true;
    double least = 1e300, most = 0.0;
    for (int n = 0; n < 4000; ++n) {
      double lines = 0.0;
      for (int k = -4; k <= 4; ++k) {
        const double from = (n + 0.5) / 4000 + k - overlap, to = from + overlap;
        if (overlap == 0.0 ? (to >= 0.0 && to < path) : true)
          lines += overlap == 0.0
                       ? 1.0
                       : std::max(0.0, std::min(to, path) - std::max(from, 0.0)) / overlap;
      }
      least = std::min(least, lines);
      most = std::max(most, lines);
    }
    const double alpha_t =
        std::atan(std::tan(p.normal_pressure_angle.rad()) / std::cos(row.trial.helix[0].rad()));
    const double d_b =
        row.trial.module * row.trial.z1 / std::cos(row.trial.helix[0].rad()) * std::cos(alpha_t);
    const double force = 2000 * 120.0 / d_b / row.face_width;
    const double spread = force * path / r.stiffness.c_gamma_alpha.value * (1 / least - 1 / most);
    EXPECT_NEAR(*row.noise, spread, 0.01 * force / r.stiffness.c_gamma_alpha.value);
    DesignRow whole = row;
    whole.overlap_ratio = 2.0;
    EXPECT_NEAR(*noise_of(whole, 3.0), 0.0, 1e-14);
  }
}

TEST(DesignObjectives, RankAndMakeAFront) {  // (6)
  using O = Objective;
  for (const auto& objectives : {std::vector{O::efficiency},
                                 {O::balance},
                                 {O::cost},
                                 {O::noise},
                                 {O::cost, O::noise},
                                 {O::noise, O::efficiency, O::cost},
                                 {O::balance, O::mass, O::noise}}) {
    const SearchProblem p = ranked_wish(objectives);
    const auto rows = testing::search::points_of(p);
    BestDesigns best(p, rows.size());
    for (const DesignRow& row : rows) best.add(row);
    const SearchAnswer answer = std::move(best).answer({});
    std::set<std::int64_t> front, wanted;
    for (const std::size_t i : answer.pareto) front.insert(answer.designs[i].trial.index);
    const auto numbers = [&](const DesignRow& row) {
      std::vector<double> list;
      for (const O o : objectives) list.push_back(*cost(p, row, o));
      return list;
    };
    for (const DesignRow& a : rows) {
      if (!a.balanced || objectives.size() < 2) continue;
      const bool beaten = std::any_of(rows.begin(), rows.end(), [&](const DesignRow& b) {
        if (!b.balanced) return false;
        const auto mine = numbers(a), its = numbers(b);
        bool better = false;
        for (std::size_t k = 0; k < mine.size(); ++k) {
          if (its[k] > mine[k] + 1e-10) return false;
          better = better || its[k] < mine[k] - 1e-10;
        }
        return better;
      });
      if (!beaten) wanted.insert(a.trial.index);
    }
    EXPECT_EQ(front, wanted);
    double last = -1e300;
    for (std::size_t i = answer.pareto.size(); i < answer.designs.size(); ++i) {
      if (!answer.designs[i].balanced) break;
      const double value = *cost(p, answer.designs[i], objectives.front());
      EXPECT_GE(value, last - 1e-10);
      last = value;
    }
  }
}

}  // namespace
}  // namespace gearwright
