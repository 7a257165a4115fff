// Laws: (1) equal planets at equal phases share equally, and the shares add up to 1; (2) a drive of
// one mesh has the loaded curve of its pair; (3) very stiff teeth have the curve of rigid teeth;
// (4) between the solved loads, the springs agree with direct solutions; (5) an error of a pin in
// the direction of the sun's push unloads its planet; (6) impossible loads are rejected with the
// name of the input; (7) stepped planets with equal gears include all states of plain planets.
#include "gearwright/drive/loaded_drive.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "gearwright/base/testing/taken.hpp"
#include "gearwright/drive/drive_phases.hpp"
#include "gearwright/drive/mesh_springs.hpp"
#include "gearwright/drive/short_forms.hpp"
#include "gearwright/load/loaded_contact.hpp"

namespace gearwright {
namespace {

using M = SetMember;

BothFlanks crowned(double profile, double lead = 0.0) {
  FlankModifications flank;
  flank.profile_crowning = profile;
  flank.lead_crowning = lead;
  return {flank, flank};
}

struct TestSet {
  std::array<int, 3> teeth{21, 24, 69};
  int planets = 3;
  double helix_deg = 0.0, crowning = 0.0, lead_crowning = 0.0;
  std::optional<int> planet2{};  // the gear of a stepped planet that meshes with the ring
};

Drive loaded_set(const TestSet& t) {
  PlanetarySpec set;
  set.z(M::sun) = t.teeth[0];
  set.z(M::planet) = t.teeth[1];
  set.z(t.planet2 ? M::ring2 : M::ring) = t.teeth[2];
  set.z(M::planet2) = t.planet2;
  set.planets = t.planets;
  set.normal_module = 2.0;
  set.face_width.all = 8.0;
  set.allowance.all = -0.04;
  set.helix_deg.all = t.helix_deg;
  set.efficiency.all = 1.0;
  auto graph = graph_of(set);
  EXPECT_TRUE(graph);
  DriveInput input{std::move(graph).take(), {}, 5};
  for (DriveGear& gear : input.graph.gears)
    if (t.crowning != 0.0 || t.lead_crowning != 0.0)
      gear.modifications = crowned(t.crowning, t.lead_crowning);
  return testing::taken(make_drive(input));
}

LoadRequest request_of(const Drive& drive, std::size_t mesh, double stiffer = 1.0) {
  LoadRequest request;
  const Pair& pair = *drive.geometry.pairs[mesh];
  request.accuracy = ComplianceAccuracy::draft;
  request.slices = fair_slices(pair.gear(1), pair.gear(2), LoadRegime::line);
  for (const std::size_t i : {0, 1}) {
    const Gear& gear = pair.gear(static_cast<int>(i) + 1);
    request.bodies[i].bore_diameter =
        gear.internal() ? gear.root_diameter + 20.0 : gear.root_diameter / 2;
    request.bodies[i].youngs_modulus *= stiffer;
  }
  return request;
}

DriveLoadCase load_of(const Drive& drive, double torque, int positions, double stiffer = 1.0) {
  DriveLoadCase load;
  load.torque = torque;
  load.positions = positions;
  for (std::size_t m = 0; m < drive.graph.meshes.size(); ++m)
    load.requests.push_back(request_of(drive, m, stiffer));
  return load;
}

LoadedDrive under(const Drive& drive, const DriveLoadCase& load) {
  return testing::taken(loaded_drive(drive, load));
}

double span(const std::vector<double>& values) {
  const auto [least, greatest] = std::minmax_element(values.begin(), values.end());
  return *greatest - *least;
}

TEST(LoadedDriveTest, EqualPlanetsInPhaseShareEqually) {
  const Drive drive = loaded_set({});  // 21/3 and 69/3 are whole, so all planets are in phase
  const LoadedDrive loaded = under(drive, load_of(drive, 30.0, 6));
  ASSERT_EQ(loaded.sets.size(), 1u);
  const PlanetShares& shares = loaded.sets[0];
  for (std::size_t j = 0; j < shares.share[0].size(); ++j) {
    double sum = 0.0;
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_NEAR(shares.share[i][j], 1.0 / 3, 1e-9);
      sum += shares.share[i][j];
    }
    EXPECT_NEAR(sum, 1.0, 1e-12);
  }
  EXPECT_NEAR(shares.mesh_load_factor().second, 1.0, 1e-8);
  EXPECT_GT(loaded.error.peak_to_peak, 0.0);
}

// The sun turns counter-clockwise in the carrier, and planet i is i/3 of a turn ahead of planet 0
// in this sense. Its share equals the share that planet 0 had γ_i = 20 i/3 pitches earlier.
TEST(LoadedDriveTest, PlanetsInSequenceHaveTheSharesOfEachOtherLater) {
  constexpr int kPositions = 6;
  const Drive drive = loaded_set({{20, 25, 70}});
  const PlanetShares shares = under(drive, load_of(drive, 30.0, kPositions)).sets[0];
  ASSERT_GT(span(shares.share[0]), 1e-3);
  for (std::size_t i = 1; i < 3; ++i)
    for (int j = 0; j < kPositions; ++j) {
      const int later = static_cast<int>(20 * i * kPositions / 3) % kPositions;
      const auto k = static_cast<std::size_t>((j - later + kPositions) % kPositions);
      EXPECT_NEAR(shares.share[i][static_cast<std::size_t>(j)], shares.share[0][k], 1e-8) << i << j;
    }
}

TEST(LoadedDriveTest, AnErrorOfAPinUnloadsThePlanetAhead) {
  const Drive drive = loaded_set({{20, 25, 70}});
  DriveLoadCase load = load_of(drive, 30.0, 6);
  load.pin_errors = {0.002, 0.0, 0.0};
  const PlanetShares centred = under(drive, load).sets[0];
  EXPECT_LT(centred.greatest[0], 0.32);
  EXPECT_GT(centred.mean(1), 0.333);
  EXPECT_GT(centred.mesh_load_factor().second, 1.02);
  load.floating = *find_body(drive.graph, "sun", "");
  const PlanetShares floating = under(drive, load).sets[0];
  EXPECT_NEAR(floating.mesh_load_factor().second, 1.0, 1e-8);
  EXPECT_NEAR(floating.mean(0) + floating.mean(1) + floating.mean(2), 1.0, 1e-12);
  EXPECT_GT(*floating.greatest_displacement, 1e-3);
}

// The meshes of a planet with two gears of 24 and 18 teeth are in phase at all planets, so all
// planets share equally in all combinations of their positions. With equal shares, the rotation of
// the output is a sum of functions of one position each.
TEST(LoadedDriveTest, SteppedPlanetsInPhaseShareEqually) {
  const Drive drive = loaded_set({.teeth = {21, 24, 63}, .planet2 = 18});
  const LoadedDrive loaded = under(drive, load_of(drive, 30.0, 9));
  ASSERT_EQ(loaded.sets.size(), 1u);
  EXPECT_NEAR(loaded.sets[0].mesh_load_factor().second, 1.0, 1e-8);
  ASSERT_EQ(loaded.sets[0].share.size(), 3u);
  EXPECT_EQ(loaded.sets[0].share[0].size(), 9u);
  ASSERT_EQ(loaded.curves.size(), 2u);
  EXPECT_NEAR(loaded.curves[0].frequency_ratio / loaded.curves[1].frequency_ratio, 24.0 / 18,
              1e-12);
  const double sum = span(loaded.curves[0].loaded) + span(loaded.curves[1].loaded);
  EXPECT_GT(std::min(span(loaded.curves[0].loaded), span(loaded.curves[1].loaded)), 0.0);
  EXPECT_NEAR(loaded.error.peak_to_peak, sum, 1e-9 * sum);
}

// Law (7). The meshes of a plain planet have one frequency, so they meet in one of the combinations
// that a stepped planet with two equal gears has. The positions of the meshes with the ring differ
// by a part of a step.
TEST(LoadedDriveTest, SteppedPlanetsIncludeTheStatesOfPlainPlanets) {
  TestSet set{.teeth = {20, 25, 70}};
  const Drive plain = loaded_set(set);
  set.planet2 = 25;
  const Drive stepped = loaded_set(set);
  ASSERT_EQ(plain.motion.ratio, stepped.motion.ratio);
  const LoadedDrive one = under(plain, load_of(plain, 30.0, 24));
  const LoadedDrive all = under(stepped, load_of(stepped, 30.0, 24));
  constexpr double kStep = 0.01;  // effect of the part of a step
  EXPECT_GT(all.sets[0].mesh_load_factor().second, one.sets[0].mesh_load_factor().second - kStep);
  EXPECT_GT(all.error.peak_to_peak, (1 - kStep) * one.error.peak_to_peak);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(all.sets[0].mean(i), 1.0 / 3, 1e-3);
    EXPECT_LE(all.sets[0].least[i], one.sets[0].least[i] + kStep);
    EXPECT_GE(all.sets[0].greatest[i], one.sets[0].greatest[i] - kStep);
  }
}

TEST(LoadedDriveTest, StiffSteppedPlanetsHaveTheCurvesOfRigidOnes) {
  const Drive drive = loaded_set({.teeth = {20, 25, 66}, .crowning = 0.008, .planet2 = 21});
  DriveLoadCase load = load_of(drive, 30.0, 24, 1e6);
  load.floating = *find_body(drive.graph, "sun", "");
  const LoadedDrive loaded = under(drive, load);
  ASSERT_EQ(loaded.curves.size(), 2u);
  for (const auto& [ratio, soft, rigid] : loaded.curves)
    for (std::size_t j = 0; j < soft.size(); ++j)
      EXPECT_NEAR(soft[j], rigid[j], 1e-3 * span(rigid));
  ASSERT_TRUE(drive.error);
  EXPECT_GT(drive.error->peak_to_peak, 0.0);
  EXPECT_NEAR(loaded.error.peak_to_peak, drive.error->peak_to_peak,
              0.04 * drive.error->peak_to_peak);
}

// The input torque of the second set of a train is the output torque of the first. The curve of a
// set is divided by the ratios of the sets after it, and the peaks of both frequencies add up.
TEST(LoadedDriveTest, SetsOfATrainAreThoseOfTheirStages) {
  std::vector<StageSpec> stages(2);
  const std::array<std::array<int, 3>, 2> teeth{{{20, 25, 70}, {19, 26, 71}}};
  for (std::size_t s = 0; s < 2; ++s) {
    PlanetarySpec set;
    set.z(M::sun) = teeth[s][0];
    set.z(M::planet) = teeth[s][1];
    set.z(M::ring) = teeth[s][2];
    set.planets = 3 + static_cast<int>(s);
    set.normal_module = 2.0;
    set.face_width.all = 8.0;
    set.efficiency.all = 1.0;
    stages[s].planetary = set;
  }
  auto input = train_of(stages);
  ASSERT_TRUE(input);
  const auto drive = make_drive(*input);
  ASSERT_TRUE(drive);
  ASSERT_EQ(drive->stages.size(), 2u);
  constexpr int kPositions = 12;
  double torque = 20.0;
  const LoadedDrive whole = under(*drive, load_of(*drive, torque, kPositions));
  ASSERT_EQ(whole.sets.size(), 2u);
  ASSERT_EQ(whole.curves.size(), 2u);
  const double behind = std::abs(drive->stages[1].motion.ratio->value());
  double peaks = 0.0;
  for (std::size_t s = 0; s < 2; ++s) {
    const Drive& stage = drive->stages[s];
    const LoadedDrive one = under(stage, load_of(stage, torque, kPositions));
    EXPECT_NEAR(whole.sets[s].mesh_load_factor().second, one.sets[0].mesh_load_factor().second,
                1e-9);
    for (std::size_t i = 0; i < one.sets[0].share.size(); ++i)
      for (std::size_t j = 0; j < one.sets[0].share[i].size(); ++j)
        EXPECT_NEAR(whole.sets[s].share[i][j], one.sets[0].share[i][j], 1e-9) << s << i << j;
    const double scale = s == 0 ? behind : 1.0;
    ASSERT_EQ(one.curves[0].loaded.size(), whole.curves[s].loaded.size());
    for (std::size_t j = 0; j < one.curves[0].loaded.size(); ++j)
      EXPECT_NEAR(whole.curves[s].loaded[j], one.curves[0].loaded[j] / scale,
                  1e-9 * one.error.peak_to_peak);
    peaks += one.error.peak_to_peak / scale;
    torque *= std::abs(stage.motion.ratio->value());
  }
  EXPECT_NEAR(whole.error.peak_to_peak, peaks, 1e-9 * peaks);
}

TEST(LoadedDriveTest, OneMeshHasTheLoadedCurveOfItsPair) {
  StageSpec stage;
  stage.pair.teeth = {19, 58};
  for (const std::size_t i : {0, 1}) {
    CylindricalSpec spec;
    spec.normal_module = 2.0;
    spec.face_width = 8.0;
    stage.pair.specs[i] = spec;
    stage.pair.shifts[i] = 0.0;
  }
  stage.pair.efficiency = 1.0;
  for (const bool gear2_drives : {false, true}) {
    auto made = train_of({stage});
    ASSERT_TRUE(made);
    DriveInput input = std::move(made).take();
    if (gear2_drives) std::swap(input.graph.inputs.front(), input.graph.output);
    const auto drive = make_drive(input);
    ASSERT_TRUE(drive);
    const double torque = 20.0;
    const DriveLoadCase load = load_of(*drive, torque, 32);
    const LoadedDrive loaded = under(*drive, load);
    LoadRequest request = load.requests[0];
    request.root_stress = false;
    request.torques = {torque * 1000 * (gear2_drives ? 19.0 / 58 : 1.0)};
    request.positions = 160;
    const auto setup = ContactSetup::of(*drive->geometry.pairs[0], {});
    ASSERT_TRUE(setup);
    const auto compliance = pair_compliance(setup->gear(1), setup->gear(2), request);
    ASSERT_TRUE(compliance);
    const LoadedContact contact = loaded_contact(setup->pair(gear2_drives), setup->gear(1),
                                                 setup->gear(2), *compliance, request);
    const double at_output = gear2_drives ? 58.0 / 19 : 1.0;
    // The drive is computed at fewer positions, which differ from the positions of the pair.
    const double whole = contact.torques[0].peak_to_peak.rad() * at_output;
    EXPECT_LE(loaded.error.peak_to_peak, whole * (1 + 1e-6));
    EXPECT_NEAR(loaded.error.peak_to_peak, whole, 0.05 * whole);
    EXPECT_NEAR(loaded.error.lines[0].amplitude, contact.torques[0].harmonics[0].rad() * at_output,
                0.03 * whole);
  }
}

TEST(LoadedDriveTest, StiffTeethHaveTheCurveOfRigidOnes) {
  const Drive drive = loaded_set({{20, 25, 70}, 3, 0.0, 0.008});
  DriveLoadCase load = load_of(drive, 30.0, 33, 1e6);
  load.floating = *find_body(drive.graph, "sun", "");
  const LoadedDrive loaded = under(drive, load);
  ASSERT_EQ(loaded.curves.size(), 1u);
  const auto& [ratio, soft, rigid] = loaded.curves[0];
  for (std::size_t j = 0; j < soft.size(); ++j) EXPECT_NEAR(soft[j], rigid[j], 2e-4 * span(rigid));
  ASSERT_TRUE(drive.error);
  EXPECT_NEAR(span(rigid), drive.error->peak_to_peak, 0.03 * drive.error->peak_to_peak);
  EXPECT_GT(drive.error->peak_to_peak, 0.0);
}

TEST(LoadedDriveTest, SpringsAgreeWithDirectSolutions) {
  double worst = 0.0;
  for (const TestSet& t :
       {TestSet{.helix_deg = 20.0}, TestSet{.crowning = 0.008, .lead_crowning = 0.006}}) {
    const Drive drive = loaded_set(t);
    for (const std::size_t mesh : {0, 1}) {
      // The compliance tables of this mesh take longest.
      if (mesh == 1 && t.helix_deg != 0.0) continue;
      const auto setup = detail::mesh_contact(drive, mesh, {}, true);
      ASSERT_TRUE(setup);
      const LoadRequest request = request_of(drive, mesh);
      const double nominal = 500.0;
      std::vector<double> rotations;
      for (int j = 0; j < 5; ++j)
        rotations.push_back(setup->pair(false).pitch() * (j / 5.0 - 0.46));
      const auto springs =
          detail::mesh_springs(*setup, false, request, detail::load_levels(3), nominal, rotations);
      const std::vector<double> tried{0.2, 0.45, 0.8, 1.3, 2.3};
      const auto direct = detail::mesh_springs(*setup, false, request, tried, nominal, rotations);
      ASSERT_TRUE(springs && direct);
      for (std::size_t j = 0; j < rotations.size(); ++j) {
        EXPECT_EQ(springs->leads[j], direct->leads[j]);
        for (const double level : tried) {
          const double force = level * nominal;
          const double at = springs->springs[j].at(direct->springs[j].approach(force)).force;
          worst = std::max(worst, std::abs(at - force) / nominal);
        }
      }
    }
  }
  // The measured error is 0.0004 without crowning and 0.004 with crowning.
  EXPECT_LT(worst, 0.006);
}

std::string refused_field(const Drive& drive, const DriveLoadCase& load) {
  const auto found = loaded_drive(drive, load);
  return found ? "" : found.error().field;
}

TEST(LoadedDriveTest, OtherKindsAreRejected) {
  const Drive drive = loaded_set({});
  DriveLoadCase load = load_of(drive, 30.0, 6);
  load.pin_errors = {0.01, 0.0};
  EXPECT_EQ(refused_field(drive, load), "load.pin_errors");
  load.pin_errors.clear();
  load.floating = *find_body(drive.graph, "planet", "");
  EXPECT_EQ(refused_field(drive, load), "load.floating");
  load.floating.reset();
  load.torque = 0.0;
  EXPECT_EQ(refused_field(drive, load), "load.torques");
  const Drive stepped = loaded_set({.teeth = {21, 24, 63}, .planet2 = 18});
  EXPECT_EQ(refused_field(stepped, load_of(stepped, 30.0, 400)), "load.positions");
  const Drive single = loaded_set({{21, 24, 69}, 1});
  DriveLoadCase one = load_of(single, 10.0, 6);
  one.floating = *find_body(single.graph, "sun", "");
  EXPECT_EQ(refused_field(single, one), "load.floating");
}

}  // namespace
}  // namespace gearwright
