// Laws of planets between springs: (1) equal springs share equally; (2) with a floating sun, three
// planets share equally at any errors of their pins, and stiff springs leave the mean of the rigid
// curves; (3) with a centred sun, linear springs have the closed form of the share; (4) losses scale
// the forces of the ring's mesh as [T13.6] does; (5) twenty random sets agree with a minimisation of
// the energy by other code, tests/oracle/planets.
#include "gearwright/drive/planet_equilibrium.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numeric>
#include <random>

#include "gearwright/base/testing/source_file.hpp"
#include "gearwright/drive/drive_places.hpp"
#include "gearwright/drive/short_forms.hpp"

namespace gearwright::detail {
namespace {

using M = SetMember;

Drive set_of_springs(const std::array<int, 3>& teeth, int planets, double module, double distance,
                     double efficiency = 1.0, bool carrier_drives = false) {
  PlanetarySpec set;
  set.z(M::sun) = teeth[0];
  set.z(M::planet) = teeth[1];
  set.z(M::ring) = teeth[2];
  set.planets = planets;
  set.normal_module = module;
  set.center_distance.all = distance;
  set.efficiency.all = efficiency;
  if (carrier_drives) {
    set.inputs = {"carrier"};
    set.output = "sun";
  }
  auto graph = graph_of(set);
  EXPECT_TRUE(graph);
  auto drive = make_drive({std::move(graph).take(), {}, 3});
  EXPECT_TRUE(drive) << drive.error().message();
  return std::move(drive).take();
}

// Springs and leads of every mesh and planet, and the forces of an equal share.
struct Springs {
  std::vector<std::vector<LoadSpring>> springs;
  std::vector<std::vector<double>> leads;

  std::vector<std::vector<MeshState>> states() const {
    std::vector<std::vector<MeshState>> list(springs.size());
    for (std::size_t k = 0; k < springs.size(); ++k)
      for (std::size_t i = 0; i < springs[k].size(); ++i)
        list[k].push_back({&springs[k][i], leads[k][i]});
    return list;
  }
};

Springs linear_springs(std::size_t planets, double stiffness, double leads, unsigned seed,
                       double spread = 0.0) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  Springs made{{{}, {}}, {{}, {}}};
  for (std::size_t k = 0; k < 2; ++k)
    for (std::size_t i = 0; i < planets; ++i) {
      made.springs[k].push_back(LoadSpring::linear(stiffness * (1 + spread * unit(random))));
      made.leads[k].push_back(leads * unit(random));
    }
  return made;
}

// The forces of an equal share of a torque on the input, N mm.
std::vector<double> nominal_forces(const Drive& drive, double torque) {
  std::vector<double> forces;
  for (std::size_t m = 0; m < drive.graph.meshes.size(); ++m)
    forces.push_back(std::abs(drive.flow->load[m]) * torque * kTurn /
                     drive.geometry.pairs[m]->gear(1).reference().base_pitch_transverse /
                     drive.sets[0].group.count);
  return forces;
}

PlanetState solved(const Drive& drive, const Springs& springs, double torque,
                   const PlanetErrors& errors = {}) {
  const auto phases = phases_of(drive);
  EXPECT_TRUE(phases);
  const PlanetEquilibrium equilibrium(drive, drive.sets[0], *phases, nominal_forces(drive, torque),
                                      errors);
  const PlanetState state = equilibrium.solve(springs.states());
  EXPECT_TRUE(state.found);
  return state;
}

std::size_t body(const Drive& drive, const std::string& name) {
  return *find_body(drive.graph, name, "");
}

TEST(PlanetEquilibriumTest, EqualSpringsShareEqually) {
  for (const int planets : {1, 2, 3, 5}) {
    const Drive drive = set_of_springs({20, 25, 70}, planets, 2.0, 45.5);
    const auto nominal = nominal_forces(drive, 4e4);
    for (const bool floats : {false, true}) {
      if (floats && planets < 2) continue;
      PlanetErrors errors;
      if (floats) errors.floating = body(drive, "sun");
      const auto springs = linear_springs(static_cast<std::size_t>(planets), 1e5, 0.0, 1);
      const PlanetState state = solved(drive, springs, 4e4, errors);
      for (std::size_t k = 0; k < 2; ++k)
        for (const double force : state.forces[k])
          EXPECT_NEAR(force, nominal[k], 1e-9 * nominal[k]) << planets;
      // Two planets do not resist a displacement across their forces, which then stays near 0.
      EXPECT_LT(state.displacement.norm(), planets == 2 ? 1e-6 : 1e-9);
    }
  }
}

TEST(PlanetEquilibriumTest, ThreePlanetsShareEquallyAroundAFloatingSun) {
  std::mt19937 random(7);
  std::normal_distribution<double> normal(0.0, 0.02);
  for (const bool carrier_drives : {false, true}) {
    const Drive drive = set_of_springs({20, 25, 70}, 3, 2.0, 45.5, 1.0, carrier_drives);
    for (const char* floating : {"sun", "ring", "carrier"}) {
      PlanetErrors errors{body(drive, floating), {normal(random), normal(random), normal(random)}};
      for (const double stiffness : {1e5, 1e11}) {
        const auto springs = linear_springs(3, stiffness, 0.01, 5, 0.3);
        const PlanetState state = solved(drive, springs, 4e4, errors);
        const auto nominal = nominal_forces(drive, 4e4);
        for (std::size_t k = 0; k < 2; ++k)
          for (const double force : state.forces[k])
            EXPECT_NEAR(force, nominal[k], 1e-6 * nominal[k]) << floating;
        if (stiffness < 1e10) continue;
        // Without compliance, the output has the mean of the rigid curves and of the pins [T13.22].
        double mean = 0.0;
        const auto phases = phases_of(drive);
        for (std::size_t k = 0; k < 2; ++k) {
          const Pair& pair = *drive.geometry.pairs[k];
          const double sum =
              pair.gear(2).base_radius() + (k == 0 ? 1 : -1) * pair.gear(1).base_radius();
          for (std::size_t i = 0; i < 3; ++i)
            mean += (*phases)[k].weight / 3 *
                    (springs.leads[k][i] - (carrier_drives ? -1 : 1) * errors.pins[i] * sum /
                                               *drive.geometry.distance[k]);
        }
        EXPECT_NEAR(state.output, mean, 1e-6 * std::abs(mean)) << floating;
      }
    }
  }
}

TEST(PlanetEquilibriumTest, ACentredSunHasTheClosedFormOfTheShare) {
  const Drive drive = set_of_springs({20, 25, 70}, 3, 2.0, 45.5);
  const std::vector<double> pins{0.004, -0.002, 0.001};
  const auto springs = linear_springs(3, 1e5, 0.0, 9, 0.4);
  const PlanetState state = solved(drive, springs, 4e4, {std::nullopt, pins});
  const double r_s = drive.geometry.pairs[0]->gear(1).base_radius();
  const double r_p = drive.geometry.pairs[0]->gear(2).base_radius();
  const double r_r = drive.geometry.pairs[1]->gear(2).base_radius();
  const double cosines = (r_s + r_p + r_r - r_p) / *drive.geometry.distance[0];
  // Planet i: F_i = k_i (x − ε_i (cos α_w,sp + cos α_w,pr)), k_i of both meshes in series.
  std::vector<double> k;
  double stiffness = 0.0, moved = 0.0;
  for (std::size_t i = 0; i < 3; ++i) {
    const double a = springs.springs[0][i].at(1.0).slope, b = springs.springs[1][i].at(1.0).slope;
    k.push_back(a * b / (a + b));
    stiffness += k.back();
    moved += k.back() * pins[i] * cosines;
  }
  const double x = (4e4 / r_s + moved) / stiffness;
  for (std::size_t i = 0; i < 3; ++i) {
    const double force = k[i] * (x - pins[i] * cosines);
    EXPECT_NEAR(state.forces[0][i], force, 1e-8 * force);
    EXPECT_NEAR(state.forces[1][i], force, 1e-8 * force);
  }
  EXPECT_NEAR(state.output, -x / r_s * (20.0 / 90.0), 1e-12);  // i = 4.5
}

TEST(PlanetEquilibriumTest, LossesActAlongTheChain) {
  for (const bool carrier_drives : {false, true}) {
    const Drive drive = set_of_springs({20, 25, 70}, 4, 2.0, 45.5, 0.9, carrier_drives);
    const auto springs = linear_springs(4, 1e5, 0.0003, 3, 0.2);
    const PlanetState state = solved(drive, springs, 4e4);
    const auto nominal = nominal_forces(drive, 4e4);
    for (std::size_t k = 0; k < 2; ++k)
      EXPECT_NEAR(std::accumulate(state.forces[k].begin(), state.forces[k].end(), 0.0),
                  4 * nominal[k], 1e-9 * nominal[k]);
    for (std::size_t i = 0; i < 4; ++i)
      EXPECT_NEAR(state.forces[1][i] / state.forces[0][i], nominal[1] / nominal[0], 1e-9);
  }
}

TEST(PlanetEquilibriumTest, AgreesWithAMinimisationOfTheEnergy) {
  const auto cases = nlohmann::json::parse(
      std::ifstream(testing::source_file("tests/oracle/planets/planet_springs.json")));
  ASSERT_EQ(cases.size(), 20u);
  for (const auto& c : cases) {
    const std::array<int, 3> teeth = c["teeth"];
    const auto planets = c["angles"].size();
    const Drive drive =
        set_of_springs(teeth, static_cast<int>(planets), c["module"], c["distance"]);
    for (std::size_t i = 0; i < planets; ++i)
      ASSERT_NEAR(drive.sets[0].assembly.turns[i].value() * kTurn, c["angles"][i].get<double>(),
                  1e-12);
    Springs springs{{{}, {}}, {{}, {}}};
    for (std::size_t k = 0; k < 2; ++k)
      for (std::size_t i = 0; i < planets; ++i) {
        const double stiffness = c["stiffness"][i][k], bend = c["bend"][i][k];
        // A parabola through 0 has one node, which lies above all forces.
        constexpr double kFar = 1.0;
        springs.springs[k].emplace_back(std::vector<SpringNode>{
            {kFar, stiffness * kFar + bend * kFar * kFar, stiffness + 2 * bend * kFar}});
        springs.leads[k].push_back(c["lead"][i][k]);
      }
    PlanetErrors errors{std::nullopt, c["pins"].get<std::vector<double>>()};
    if (c["floating"]) errors.floating = body(drive, "sun");
    const double torque = c["torque"];
    const PlanetState state = solved(drive, springs, torque, errors);
    const double share = torque / c["base_sun"].get<double>() / static_cast<double>(planets);
    for (std::size_t i = 0; i < planets; ++i)
      for (std::size_t k = 0; k < 2; ++k)
        EXPECT_NEAR(state.forces[k][i], c["forces"][i][k].get<double>(), 3e-6 * share);
    EXPECT_NEAR(state.displacement.x(), c["displacement"][0].get<double>(), 1e-7);
    EXPECT_NEAR(state.displacement.y(), c["displacement"][1].get<double>(), 1e-7);
  }
}

}  // namespace
}  // namespace gearwright::detail
