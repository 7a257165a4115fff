// Mounted pairs for the tests of this room.
#pragma once

#include <gtest/gtest.h>

#include "gearwright/base/units.hpp"
#include "gearwright/contact/contact_setup.hpp"
#include "gearwright/gear/pinion_cut.hpp"
#include "gearwright/scatter/scatter.hpp"
#include "gearwright/scatter/tolerance.hpp"

namespace gearwright::testing {

struct DrawnPair {
  std::array<CylindricalSpec, 2> gears;
  double center_distance;
  FlankModifications modifications{};  ///< of gear 1, both flanks
  ContactErrors errors{};
  std::optional<double> gap{};  ///< between the halves of double-helical gears  mm

  ContactSetup setup() const {
    auto g1 = make_gear(gears[0]);
    auto g2 = make_gear_with_default_cutter(gears[1]);
    EXPECT_TRUE(g1 && g2);
    Gear one = *g1, two = *g2;
    one.gap = two.gap = gap;
    const auto pair = mount(one, two, {.center_distance = center_distance});
    EXPECT_TRUE(pair) << pair.error().message();
    PairModifications all{};
    all[0] = {modifications, modifications};
    auto made = ContactSetup::of(*pair, errors, all);
    EXPECT_TRUE(made) << made.error().message();
    return std::move(made).take();
  }
};

inline CylindricalSpec drawn_gear(int teeth, double module, double helix_deg, double shift,
                                  double allowance, double face) {
  CylindricalSpec s;
  s.teeth = teeth;
  s.normal_module = module;
  s.helix_angle = Angle::degrees(helix_deg);
  s.profile_shift = shift;
  s.thickness_allowance = allowance;
  s.face_width = face;
  return s;
}

/// The spur pair with 20:40 teeth of cases/scatter.json, with or without crowning.
inline DrawnPair spur_pair(bool crowned) {
  DrawnPair p{{drawn_gear(20, 2, 0, 0.2, -0.06, 20), drawn_gear(40, 2, 0, 0, -0.06, 20)}, 60.4};
  if (crowned) p.modifications.lead_crowning = 0.008;
  if (crowned) p.modifications.profile_crowning = 0.004;
  return p;
}

inline DrawnPair crowned_helical_pair() {
  DrawnPair p{{drawn_gear(17, 2.5, 15, 0.3, -0.05, 25), drawn_gear(43, 2.5, -15, 0.1, -0.07, 25)},
              78.6056};
  p.modifications.lead_crowning = 0.010;
  p.modifications.profile_crowning = 0.005;
  return p;
}

inline DrawnPair plain_helical_pair() {
  return {{drawn_gear(23, 2, -20, 0.15, -0.05, 20), drawn_gear(61, 2, 20, 0, -0.05, 20)}, 89.8};
}

inline DrawnPair ring_pair() {
  return {{drawn_gear(20, 2, 15, 0.2, -0.06, 20), drawn_gear(-61, 2, 15, -0.2, -0.06, 20)}, 42.44};
}

template <class Of>
ScatterTolerance tolerance(std::string name, double unit, double least, double greatest, Of of) {
  auto d = Distribution::of({{least, greatest}});
  EXPECT_TRUE(d);
  return {std::move(name), unit, std::move(d).take(), of};
}

inline ScatterTolerance distance(double mm) {
  return tolerance("errors.center_distance_mm", 1.0, -mm, mm, VaryingError::center_distance);
}
inline ScatterTolerance crossing(double deg) {
  return tolerance("errors.crossing_deg", kRadPerDeg, -deg, deg, VaryingError::crossing);
}
inline ScatterTolerance intersecting(double deg) {
  return tolerance("errors.intersecting_deg", kRadPerDeg, -deg, deg, VaryingError::intersecting);
}

/// Returns a task in which each tolerance is a group of its own.
inline ScatterTask task_of(std::vector<ScatterTolerance> tolerances, int positions, int samples,
                           int replicates = 8) {
  ScatterTask task;
  for (std::size_t i = 0; i < tolerances.size(); ++i)
    task.groups.push_back({tolerances[i].name, {i}});
  task.tolerances = std::move(tolerances);
  task.member.positions = positions;
  task.samples = samples;
  task.replicates = replicates;
  return task;
}

}  // namespace gearwright::testing
