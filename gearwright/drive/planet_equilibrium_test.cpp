// Laws of planets between springs: (1) equal springs share equally; (2) with a floating sun, ring
// or carrier, three planets share equally for any errors of their pins, and with stiff springs only
// the mean of the rigid curves remains; (3) with a centred sun, linear springs have the closed form
// of the share; (4) losses scale the forces in the mesh with the ring by the efficiencies, as in
// [T13.6]; (5) random sets, with one planet, two meshed planets or a stepped planet on each arm and
// a floating sun, ring or carrier, agree with the minimisation of the energy in
// tests/oracle/planets; (6) the work of the teeth of several sets equals the work of the output.
#include "gearwright/drive/planet_equilibrium.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numeric>
#include <random>

#include "gearwright/base/testing/source_file.hpp"
#include "gearwright/base/testing/taken.hpp"
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
  return testing::taken(make_drive({testing::taken(graph_of(set)), {}, 3}));
}

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
      // Two planets do not resist a displacement perpendicular to their forces, which then stays
      // near 0.
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
        // If the teeth are rigid, the output has the mean of the rigid curves and of the pin errors
        // [T13.22].
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

// Two sets with a common sun, connected as in a Simpson gearset: ring 1 drives, carrier 2 is held,
// and carrier 1 with ring 2 is the output.
Drive two_sets() {
  DriveGraph graph;
  const auto add = [&](const char* name, std::optional<std::size_t> carrier = {}) {
    graph.bodies.push_back({name, carrier, carrier ? 3 : 1, {}});
    return graph.bodies.size() - 1;
  };
  const std::size_t sun = add("sun"), ring = add("ring"), out = add("out"), held = add("held");
  const std::size_t one = add("planet1", out), two = add("planet2", held);
  for (const auto& [body, teeth] : std::initializer_list<std::pair<std::size_t, int>>{
           {sun, 30}, {one, 21}, {ring, -72}, {sun, 20}, {two, 25}, {out, -70}}) {
    CylindricalSpec spec;
    spec.teeth = teeth;
    spec.normal_module = 2.0;
    graph.gears.push_back({fmt::format("g{}", graph.gears.size()), body, teeth, {}, spec, 0.0});
  }
  for (const std::array<std::size_t, 2>& gears :
       {std::array<std::size_t, 2>{0, 1}, {1, 2}, {3, 4}, {4, 5}})
    graph.meshes.push_back({fmt::format("m{}", graph.meshes.size()), gears, 1.0, {}});
  graph.fixed = {held};
  graph.inputs = {ring};
  graph.output = out;
  return testing::taken(make_drive({graph, {}, 3}));
}

// The work of the torque on the output equals the work of the teeth of both sets, T_o δφ_o = −Σ F
// δ, for any springs that touch in the ideal position.
TEST(PlanetEquilibriumTest, BothSetsOfADriveDoTheWorkOfItsOutput) {
  const Drive drive = two_sets();
  ASSERT_EQ(drive.sets.size(), 2u);
  constexpr double kTorque = 5e4;
  const auto nominal = nominal_forces(drive, kTorque);
  const auto phases = phases_of(drive);
  ASSERT_TRUE(phases);
  double output = 0.0, work = 0.0;
  for (std::size_t s = 0; s < 2; ++s) {
    const PlanetEquilibrium equilibrium(drive, drive.sets[s], *phases, nominal, {});
    const auto springs = linear_springs(3, 1e5, 0.0, static_cast<unsigned>(s), 0.5);
    const PlanetState state = equilibrium.solve(springs.states());
    ASSERT_TRUE(state.found);
    output += state.output;
    for (std::size_t k = 0; k < 2; ++k) {
      const double sum = std::accumulate(state.forces[k].begin(), state.forces[k].end(), 0.0);
      EXPECT_NEAR(sum, 3 * nominal[equilibrium.meshes()[k]], 1e-9 * sum);
      for (std::size_t i = 0; i < 3; ++i)
        work += state.forces[k][i] * springs.springs[k][i].approach(state.forces[k][i]);
    }
  }
  EXPECT_GT(work, 0.0);
  const double torque = kTorque * std::abs(drive.flow->torque[drive.graph.output]);
  EXPECT_NEAR(torque * output, -work, 1e-9 * work);
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

// Makes the drive of a case in tests/oracle/planets. In the oracle, the pins of an idler precede
// the pins of the planet. In a set, the planet is the first rider.
Drive drive_of(const nlohmann::json& c) {
  const std::vector<int> teeth = c["teeth"];
  const bool idler = teeth.size() == 4;
  PlanetarySpec set;
  set.z(M::sun) = teeth.front();
  if (idler) set.z(M::idler) = teeth[1];
  set.z(M::planet) = teeth[teeth.size() - 2];
  set.z(M::ring) = teeth.back();
  set.planets = static_cast<int>(c["angles"].size());
  set.normal_module = c["module"];
  const std::vector<double> distances = c["distances"];
  set.center_distance.each =
      idler ? std::vector<std::pair<std::string, double>>{{"sun_idler", distances[0]},
                                                          {"idler_planet", distances[1]},
                                                          {"planet_ring", distances[2]}}
            : std::vector<std::pair<std::string, double>>{{"sun_planet", distances[0]}};
  set.efficiency.all = 1.0;
  set.fixed = std::vector<std::string>{c["fixed"].get<std::string>()};
  set.inputs = {c["input"]};
  set.output = c["output"];
  return testing::taken(make_drive({testing::taken(graph_of(set)), {}, 3}));
}

// Compares the forces of all meshes of a case with those of the engine. `order` is the number of
// each mesh of the drive in the case.
void expect_forces(const nlohmann::json& c, const Drive& drive, const PlanetErrors& errors,
                   const std::vector<std::size_t>& order, const std::vector<double>& nominal) {
  const PlanetSet& set = drive.sets[0];
  const std::size_t planets = c["angles"].size();
  for (std::size_t i = 0; i < planets; ++i)
    ASSERT_NEAR(set.assembly.turns[i].value() * kTurn, c["angles"][i].get<double>(), 1e-12);
  Springs springs;
  for (const std::size_t k : order) {
    springs.springs.emplace_back();
    springs.leads.emplace_back();
    for (std::size_t i = 0; i < planets; ++i) {
      const double stiffness = c["stiffness"][i][k], bend = c["bend"][i][k];
      // A parabola through 0 needs only one node, which is placed above all forces.
      constexpr double kFar = 1.0;
      springs.springs.back().emplace_back(std::vector<SpringNode>{
          {kFar, stiffness * kFar + bend * kFar * kFar, stiffness + 2 * bend * kFar}});
      springs.leads.back().push_back(c["lead"][i][k]);
    }
  }
  const auto phases = phases_of(drive);
  ASSERT_TRUE(phases);
  const PlanetEquilibrium equilibrium(drive, set, *phases, nominal, errors);
  const PlanetState state = equilibrium.solve(springs.states());
  EXPECT_TRUE(state.found);
  for (std::size_t i = 0; i < planets; ++i)
    for (std::size_t m = 0; m < order.size(); ++m)
      EXPECT_NEAR(state.forces[m][i], c["forces"][i][order[m]].get<double>(), 3e-6 * nominal[m]);
  // Two opposite forces do not resist a displacement perpendicular to them. The displacement is
  // then not unique.
  for (const auto& carried : state.forces)
    if (std::count_if(carried.begin(), carried.end(), [](double f) { return f > 0.0; }) < 3) return;
  EXPECT_NEAR(state.displacement.x(), c["displacement"][0].get<double>(), 1e-7);
  EXPECT_NEAR(state.displacement.y(), c["displacement"][1].get<double>(), 1e-7);
}

TEST(PlanetEquilibriumTest, AgreesWithAMinimisationOfTheEnergy) {
  const auto cases = nlohmann::json::parse(
      std::ifstream(testing::source_file("tests/oracle/planets/planet_springs.json")));
  ASSERT_EQ(cases.size(), 48u);
  for (std::size_t number = 0; number < cases.size(); ++number) {
    SCOPED_TRACE(number);
    const auto& c = cases[number];
    const Drive drive = drive_of(c);
    const std::size_t meshes = drive.graph.meshes.size();
    PlanetErrors errors;
    for (std::size_t r = c["pins"].size(); r-- > 0;)
      for (const double pin : c["pins"][r]) errors.pins.push_back(pin);
    const PlanetSet& set = drive.sets[0];
    ASSERT_EQ(drive.graph.bodies[set.group.riders[0]].name, "planet");
    ASSERT_EQ(set.group.riders.size(), meshes - 1);
    if (!c["floating"].is_null()) errors.floating = body(drive, c["floating"]);
    const double share = c["torque"].get<double>() / c["bases"][0].get<double>() /
                         static_cast<double>(c["angles"].size());
    std::vector<std::size_t> order(meshes);
    std::iota(order.begin(), order.end(), 0u);
    expect_forces(c, drive, errors, order, std::vector<double>(meshes, share));
  }
}

TEST(PlanetEquilibriumTest, SteppedPlanetsAgreeWithAMinimisationOfTheEnergy) {
  const auto cases = nlohmann::json::parse(
      std::ifstream(testing::source_file("tests/oracle/planets/stepped_springs.json")));
  ASSERT_EQ(cases.size(), 30u);
  for (std::size_t number = 0; number < cases.size(); ++number) {
    SCOPED_TRACE(number);
    const auto& c = cases[number];
    PlanetarySpec set;
    for (std::size_t i = 0; i < kSetMembers; ++i)
      if (const auto z = c["teeth"].find(to_string(static_cast<M>(i))); z != c["teeth"].end())
        set.teeth[i] = z->get<int>();
    set.planets = static_cast<int>(c["angles"].size());
    set.normal_module = c["module"];
    set.center_distance.all = c["distance"];
    set.efficiency.all = 1.0;
    set.fixed = std::vector<std::string>{c["fixed"].get<std::string>()};
    set.inputs = {c["input"]};
    set.output = c["output"];
    const Drive drive = testing::taken(make_drive({testing::taken(graph_of(set)), {}, 3}));
    std::vector<std::size_t> order;
    const std::vector<std::string> names = c["meshes"];
    for (const DriveMesh& mesh : drive.graph.meshes) {
      const std::string name =
          drive.graph.gear(mesh, 0).name + "_" + drive.graph.gear(mesh, 1).name;
      const auto at = std::find(names.begin(), names.end(), name);
      ASSERT_NE(at, names.end()) << name;
      order.push_back(static_cast<std::size_t>(at - names.begin()));
    }
    const auto nominal = nominal_forces(drive, c["torque"]);
    for (std::size_t m = 0; m < order.size(); ++m) {
      const double expected = c["nominal"][order[m]];
      EXPECT_NEAR(nominal[m], expected, 1e-9 * expected);
    }
    PlanetErrors errors{{}, c["pins"]};
    if (!c["floating"].is_null()) errors.floating = body(drive, c["floating"]);
    expect_forces(c, drive, errors, order, nominal);
  }
}

}  // namespace
}  // namespace gearwright::detail
