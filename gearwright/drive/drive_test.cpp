// Laws: (1) closed forms of a simple set's ratios and efficiencies, [T13.10]; (2) closed forms of
// sets with two rings, [T13.11]; (3) losses are Σ P_m (1 − η_m) and torques add up to 0; (4) an
// enumeration shows that the computed flow has the only consistent pattern of signs with η > 0; (5)
// the powers of bodies and meshes add up.
#include "gearwright/drive/drive.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "gearwright/base/testing/taken.hpp"
#include "gearwright/drive/drive_places.hpp"
#include "gearwright/drive/short_forms.hpp"
#include "gearwright/drive/testing/simple_set.hpp"
#include "gearwright/math/decompositions.hpp"

namespace gearwright {
namespace {

using M = SetMember;
using testing::error_field;
using testing::made;
using testing::simple_set;

TEST(Drive, SimpleSetHasTheClosedForms) {
  const double eta_sp = 0.985, eta_pr = 0.993, eta0 = eta_sp * eta_pr;
  for (const auto& [s, p, r] : {std::array{20, 25, 70}, {21, 15, 51}, {40, 9, 59}, {12, 50, 111}}) {
    const double i0 = static_cast<double>(r) / s;
    struct Row {
      const char *held, *in, *out;
      double ratio, eta;
    };
    for (const Row& row :
         {Row{"ring", "sun", "carrier", 1 + i0, (1 + i0 * eta0) / (1 + i0)},
          Row{"ring", "carrier", "sun", 1 / (1 + i0), (1 + i0) / (1 + i0 / eta0)},
          Row{"sun", "ring", "carrier", 1 + 1 / i0, (eta0 + i0) / (1 + i0)},
          Row{"sun", "carrier", "ring", i0 / (1 + i0), (1 + i0) / (1 / eta0 + i0)},
          Row{"carrier", "sun", "ring", -i0, eta0}, Row{"carrier", "ring", "sun", -1 / i0, eta0}}) {
      PlanetarySpec set = simple_set(s, p, r, eta_sp, eta_pr);
      set.fixed = {{row.held}};
      set.inputs = {row.in};
      set.output = row.out;
      const Drive drive = made(set);
      EXPECT_NEAR(drive.motion.ratio->value(), row.ratio, 1e-14 * std::abs(row.ratio));
      EXPECT_NEAR(drive.flow->efficiency, row.eta, 1e-13);
      double torque = 0.0, loss = 0.0, power = 0.0;
      for (const double t : drive.flow->torque) torque += t;
      for (std::size_t b = 0; b < drive.graph.bodies.size(); ++b)
        power += drive.flow->torque[b] * drive.motion.speeds[b][0].value();
      for (std::size_t m = 0; m < 2; ++m)
        loss += drive.flow->mesh_power[m] * (1 - *drive.graph.meshes[m].efficiency);
      EXPECT_NEAR(torque, 0.0, 1e-12);
      EXPECT_NEAR(power, loss, 1e-12);
      EXPECT_FALSE(drive.flow->circulating);
    }
  }
}

TEST(Drive, AListOfBodiesContainsNoBodyTwice) {
  PlanetarySpec set = simple_set(20, 25, 70, 0.99, 0.99);
  set.fixed = std::vector<std::string>{"ring", "ring"};
  EXPECT_EQ(error_field(set), "drive.fixed");
  set.fixed = std::vector<std::string>();
  set.inputs = {"sun", "sun"};
  EXPECT_EQ(error_field(set), "drive.input");
}

TEST(Drive, TwoRingsHaveTheClosedForms) {
  const double eta = 0.99, eta0 = eta * eta;
  for (const auto& [p1, p2, r1, r2] : {std::array{21, 21, 57, 60},
                                       {20, 20, 66, 63},
                                       {21, 16, 66, 61},
                                       {19, 19, 59, 60},
                                       {30, 29, 90, 89}}) {
    PlanetarySpec set;
    set.z(M::planet) = p1;
    if (p1 != p2) set.z(M::planet2) = p2;
    set.z(M::ring) = r1;
    set.z(M::ring2) = -r2;
    set.efficiency.all = eta;
    set.fixed = {{"ring"}};
    set.inputs = {"carrier"};
    set.output = "ring2";
    const double r = static_cast<double>(r1) * p2 / (static_cast<double>(p1) * r2);
    const double forward = r < 1 ? (1 - r) / (1 - r * eta0) : (r - 1) / (r / eta0 - 1);
    const double backward = r < 1 ? (1 - r / eta0) / (1 - r) : (r * eta0 - 1) / (r - 1);
    const Drive drive = made(set);
    EXPECT_NEAR(drive.motion.ratio->value() * (1 - r), 1.0, 1e-12);
    EXPECT_NEAR(drive.flow->efficiency, forward, 1e-10);
    EXPECT_NEAR(drive.backward->efficiency, std::max(backward, 0.0), 1e-10);
    EXPECT_EQ(drive.backward->self_locking(), backward <= 0.0);
  }
}

// Oracle: solves the equations of all bodies for every pattern of signs.
std::vector<double> efficiencies_by_enumeration(const Drive& drive) {
  const DriveGraph& g = drive.graph;
  const auto n = static_cast<Eigen::Index>(g.bodies.size());
  const auto meshes = static_cast<Eigen::Index>(g.meshes.size());
  const auto w = [&](std::size_t b) { return drive.motion.speeds[b][0].value(); };
  std::vector<double> found;
  for (int pattern = 0; pattern < 1 << meshes; ++pattern) {
    Eigen::MatrixXd a = Eigen::MatrixXd::Zero(n, n);
    Eigen::VectorXd rhs = Eigen::VectorXd::Zero(n);
    for (Eigen::Index m = 0; m < meshes; ++m) {
      const DriveMesh& mesh = g.meshes[static_cast<std::size_t>(m)];
      const double eta = std::pow(*mesh.efficiency, pattern >> m & 1 ? 1 : -1);
      const double t_a = g.gear(mesh, 0).teeth, t_b = g.gear(mesh, 1).teeth * eta;
      a(static_cast<Eigen::Index>(g.gear(mesh, 0).body), m) += t_a;
      a(static_cast<Eigen::Index>(g.gear(mesh, 1).body), m) += t_b;
      if (const auto c = g.frame(mesh)) a(static_cast<Eigen::Index>(*c), m) -= t_a + t_b;
    }
    a(static_cast<Eigen::Index>(g.fixed[0]), meshes) = 1;
    a(static_cast<Eigen::Index>(g.output), meshes + 1) = 1;
    rhs(static_cast<Eigen::Index>(g.inputs[0])) = -1;
    const Eigen::VectorXd x = solve_linear(a, rhs);
    bool consistent = true;
    for (Eigen::Index m = 0; m < meshes; ++m) {
      const DriveMesh& mesh = g.meshes[static_cast<std::size_t>(m)];
      const auto c = g.frame(mesh);
      const double given =
          -g.gear(mesh, 0).teeth * x(m) * (w(g.gear(mesh, 0).body) - (c ? w(*c) : 0.0));
      consistent =
          consistent && (std::abs(given) < 1e-9 || (given > 0) == ((pattern >> m & 1) == 1));
    }
    const double eta = -x(meshes + 1) * w(g.output);
    if (consistent && eta > 0.0) found.push_back(eta);
  }
  return found;
}

TEST(Drive, TheFlowIsTheOneConsistentPattern) {
  std::mt19937 random(7);
  const auto pick = [&](int lo, int hi) { return std::uniform_int_distribution(lo, hi)(random); };
  int locked = 0;
  for (int k = 0; k < 200; ++k) {
    PlanetarySpec set;
    set.z(M::planet) = pick(18, 30);
    if (k % 2 == 0) set.z(M::planet2) = pick(17, 30);
    set.z(M::ring) = pick(55, 80);
    set.z(M::ring2) = pick(55, 80);
    if (k % 3 == 0) set.z(M::sun) = pick(12, 40);
    set.efficiency.all = std::uniform_real_distribution(0.97, 0.995)(random);
    set.fixed = {{"ring"}};
    set.inputs = {k % 3 == 0 ? "sun" : "carrier"};
    set.output = "ring2";
    if (k % 5 == 0) std::swap(set.inputs.front(), set.output);
    if (!error_field(set).empty()) continue;
    const Drive drive = made(set);
    const auto all = efficiencies_by_enumeration(drive);
    if (all.empty()) {
      ++locked;
      EXPECT_TRUE(drive.flow->self_locking());
      continue;
    }
    for (const double eta : all) EXPECT_NEAR(drive.flow->efficiency, eta, 1e-9);
  }
  EXPECT_GT(locked, 0);
}

TEST(Drive, BadSetsNameWhatIsWrong) {
  PlanetarySpec set = simple_set(20, 25, 70, 0.98, 0.99);
  set.fixed = {{"ring", "sun"}};
  set.inputs = {"carrier"};
  set.output = "planet";
  EXPECT_EQ(error_field(set), "drive.fixed");
  set = simple_set(20, 25, 70, 0.98, 0.99);
  set.fixed = std::vector<std::string>{};
  EXPECT_EQ(error_field(set), "drive.fixed");
  set.fixed = {{"rign"}};
  EXPECT_EQ(error_field(set), "drive.fixed");
  set.fixed = {{"ring"}};
  set.output = "ring";
  EXPECT_EQ(error_field(set), "drive.output");
  set = simple_set(20, 25, 70, 0.98, 0.99);
  set.z(M::ring2) = 70;
  set.output = "ring2";
  EXPECT_EQ(error_field(set), "drive.output");
  set = simple_set(19, 17, 53, 0.98, 0.99);
  set.planets = 5;
  set.spacing = Spacing::equal;
  EXPECT_EQ(error_field(set), "drive.spacing");
  // 90 positions permit 3 and 5 planets, but 5 planets with 25 teeth overlap.
  set = simple_set(20, 25, 70, 0.98, 0.99);
  set.normal_module = 2.0;
  set.planets = 4;
  set.spacing = Spacing::equal;
  const auto four = make_drive({testing::taken(graph_of(set)), {}});
  ASSERT_FALSE(four);
  EXPECT_NE(four.error().rule.find("; 3 planets; "), std::string::npos) << four.error().rule;
}

TEST(Drive, TrainMultipliesItsStages) {
  StageSpec first;
  first.planetary = simple_set(20, 25, 70, 0.985, 0.993);
  StageSpec second;
  second.pair.teeth = {17, 54};
  second.pair.efficiency = 0.985;
  const auto input = train_of({first, second});
  ASSERT_TRUE(input);
  const auto drive = make_drive(*input);
  ASSERT_TRUE(drive) << drive.error().message();
  EXPECT_EQ(*drive->motion.ratio->numerator(), -243);
  EXPECT_EQ(*drive->motion.ratio->denominator(), 17);
  EXPECT_NEAR(drive->flow->efficiency,
              drive->stages[0].flow->efficiency * drive->stages[1].flow->efficiency, 1e-14);
  EXPECT_EQ(drive->graph.bodies[drive->graph.output].name, "s2_gear2");
}

// The mesh frequency is the number of teeth that pass a point fixed in the frame per turn of the
// sun.
TEST(Drive, TeethPassAsTheFrameCounts) {
  const Drive drive = made(simple_set(20, 25, 70, 0.985, 0.993));
  const double sun = 1.0, carrier = 20.0 / 90.0;
  EXPECT_NEAR(*drive.frequency_ratio(0), 20 * (sun - carrier), 1e-13);
  EXPECT_NEAR(*drive.frequency_ratio(1), 70 * carrier, 1e-13);
}

// (5) a body transmits the power from its meshes to the outside; the total power from a mesh is
// minus its loss.
TEST(Drive, PowersOfMeshesAddUp) {
  PlanetarySpec set = simple_set(12, 24, 60, 0.985, 0.993);
  set.z(M::planet2) = 21;
  set.z(M::ring2) = 57;
  set.output = "ring2";
  set.efficiency.each.emplace_back("planet_ring2", 0.992);
  const Drive drive = made(set);
  ASSERT_TRUE(drive.flow);
  std::vector<double> body(drive.graph.bodies.size()), mesh(drive.graph.meshes.size());
  for (const PowerPath& path : drive.flow->paths) {
    body[path.body] += path.power;
    mesh[path.mesh] += path.power;
  }
  for (std::size_t b = 0; b < body.size(); ++b)
    EXPECT_NEAR(body[b], -drive.flow->torque[b] * *drive.speed_ratio(b), 1e-12) << b;
  for (std::size_t m = 0; m < mesh.size(); ++m) {
    const double eta = drive.efficiencies[m]->first_drives;
    EXPECT_NEAR(mesh[m], -drive.flow->mesh_power[m] * (1 - eta), 1e-12) << m;
  }
}

TEST(Drive, GeometryOfASet) {
  PlanetarySpec set = simple_set(21, 24, 69, 0.985, 0.993);
  set.planets = 3;
  set.normal_module = 2.0;
  set.profile_shift.each[0] = 0.2;
  set.profile_shift.each[3] = 0.3;
  set.allowance.all = -0.05;
  const Drive drive = made(set);
  const double a = *drive.geometry.distance[0];
  EXPECT_EQ(a, *drive.geometry.distance[1]);
  // With |z_r| = z_s + 2 z_p, both pairs have the same working pressure angle, so x_r = −2 x_p −
  // x_s at every a.
  EXPECT_NEAR(*drive.geometry.shift[2], -0.8, 1e-12);
  const PlanetSet& planets = drive.sets.front();
  const double d_a = drive.geometry.gears[1]->tip_diameter;
  EXPECT_NEAR(planets.neighbours->clearance, a * std::sqrt(3.0) - d_a, 1e-12);
  EXPECT_EQ(planets.neighbours->most,
            static_cast<int>(std::floor(std::acos(-1.0) / std::asin(d_a / (2 * a)))));
  // γ_rs follows from the tooth thickness of the planet on its two working pitch circles. Both
  // circles have the radius a z_p/(z_s + z_p), so the two thicknesses are equal.
  const auto& pair = *drive.geometry.pairs[0]->involute();
  const double share = thickness_share(pair, 2);
  const double phase = 12.0 - share;
  EXPECT_NEAR(*planets.sun_ring_phase, phase - std::floor(phase), 1e-9);
  // If sun and ring are held, the carrier can turn by (j_sp + j_pr)/(r_bs + r_br).
  const auto& ring = *drive.geometry.pairs[1]->involute();
  const double j = pair.mesh.backlash.normal_base + ring.mesh.backlash.normal_base;
  const double r_b =
      drive.geometry.gears[0]->base_radius() + drive.geometry.gears[2]->base_radius();
  EXPECT_NEAR(drive.backlash->output, j / r_b, 1e-12);
  EXPECT_NEAR(drive.backlash->input, j / drive.geometry.gears[0]->base_radius(), 1e-12);
}

// The play of every body is the range of its rotation over all positions of the teeth in their
// gaps. The extreme rotations occur if each mesh touches one of its two flanks. For each
// combination of flanks, the kinematic equations z_a ω_a + z_b ω_b = (z_a + z_b) ω_c of the meshes
// are solved with the motion of the teeth on the right.
TEST(Drive, PlayOfEveryBodyIsTheRangeOverAllFlanks) {
  PlanetarySpec set;
  set.z(M::sun) = 20;
  set.z(M::planet) = 25;
  set.z(M::planet2) = 22;
  set.z(M::ring2) = 67;
  set.planets = 3;
  set.normal_module = 2.0;
  set.allowance.all = -0.04;
  const Drive drive = made(set);
  // The order of the bodies is sun, ring2, carrier, planet.
  const std::array<std::array<double, 4>, 2> mesh{{{20, 0, -45, 25}, {0, -67, 45, 22}}};
  std::array<double, 2> gap{};
  for (const std::size_t m : {0, 1}) {
    const auto& pair = *drive.geometry.pairs[m]->parallel();
    gap[m] = 2 * std::numbers::pi * pair.mesh.backlash.normal_base /
             std::cos(pair.gears[0].reference().base_helix_angle) /
             pair.gears[0].reference().base_pitch_transverse;
  }
  ASSERT_EQ(drive.graph.bodies[2].name, "carrier");
  ASSERT_EQ(drive.graph.bodies[3].name, "planet");
  for (const std::size_t held : {0, 2}) {
    std::array<double, 4> least{}, greatest{};
    for (const double u : {0.0, gap[0]}) {
      for (const double v : {0.0, gap[1]}) {
        // The ring and `held` do not move. The first unknown is the carrier or the sun, and the
        // second unknown is the planet.
        const std::size_t free = held == 0 ? 2 : 0;
        const double a = mesh[0][free], b = mesh[0][3], c = mesh[1][free], d = mesh[1][3];
        const double determinant = a * d - b * c;
        std::array<double, 4> turned{};
        turned[free] = (u * d - b * v) / determinant;
        turned[3] = (a * v - c * u) / determinant;
        for (std::size_t body = 0; body < 4; ++body) {
          least[body] = std::min(least[body], turned[body]);
          greatest[body] = std::max(greatest[body], turned[body]);
        }
      }
    }
    for (std::size_t body = 0; body < 4; ++body) {
      const auto play = drive.play(body, held);
      ASSERT_TRUE(play);
      EXPECT_NEAR(*play, greatest[body] - least[body], 1e-14) << held << " " << body;
    }
  }
  EXPECT_EQ(*drive.play(2, 0), drive.backlash->output);
  EXPECT_EQ(*drive.play(0, 2), drive.backlash->input);
}

// If the planet has one gear, this gear meshes with both rings, and both meshes have the same
// frequency. The phases of each mesh follow from the number of teeth of its ring.
TEST(Drive, EveryCentralGearHasItsPhases) {
  PlanetarySpec set;
  set.z(M::planet) = 21;
  set.z(M::ring) = 57;
  set.z(M::ring2) = 60;
  set.planets = 3;
  set.fixed = {"ring"};
  set.inputs = {"carrier"};
  set.output = "ring2";
  const Drive drive = made(set);
  const auto& turns = drive.sets.front().assembly.turns;
  for (const std::size_t m : {0, 1}) {
    const double z = m == 0 ? -57 : -60;
    const auto phases = drive.phases(m);
    ASSERT_EQ(phases.size(), 3u);
    for (std::size_t i = 0; i < 3; ++i) {
      const double events = z * turns[i].value();
      EXPECT_NEAR(phases[i].value(), events - std::floor(events), 1e-12);
    }
  }
}

TEST(Drive, AWrongGraphHasTheKeyAndTheReason) {
  DriveGraph graph;
  graph.bodies = {{"a", {}, 1, {}}, {"b", {}, 1, {}}};
  graph.gears = {{"ring", 0, -60, {}, {}, {}}, {"rack", 1, 0, RackBar{}, {}, {}}};
  for (const std::array<std::size_t, 2> order : {std::array<std::size_t, 2>{0, 1}, {1, 0}}) {
    graph.meshes = {{"mesh", order, {}, {}}};
    const auto error = check_graph(graph);
    ASSERT_TRUE(error);
    EXPECT_NE(error->rule.find("neither gear is external"), std::string::npos);
  }
  graph.gears[0].teeth = 17;  // the rack is still the first gear of the mesh
  EXPECT_NE(check_graph(graph).value().rule.find("the pinion must come first"), std::string::npos);
  graph.bodies[1].count = 3;
  const auto error = check_graph(graph);
  ASSERT_TRUE(error);
  EXPECT_EQ(error->field, "drive.body[2].count");
  EXPECT_EQ(error->value, "3");
}

}  // namespace
}  // namespace gearwright
