// Laws: (1) a drive with one mesh has the curve of its pair, whichever gear drives; (2) conjugate
// flanks have no transmission error; (3) if three planets mesh in sequence, only every third
// harmonic remains; (4) with one planet, the error is the sum of both curves at the actual
// positions of the planet, which the test computes itself; (5) the same holds for a pinion between
// a wheel and a rack; (6) meshes that do not move the output change nothing; (7) known contacts are
// used.
#include "gearwright/drive/drive_error.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "gearwright/base/testing/taken.hpp"
#include "gearwright/contact/contact.hpp"
#include "gearwright/contact/contact_setup.hpp"
#include "gearwright/contact/rack_contact.hpp"
#include "gearwright/drive/drive_places.hpp"
#include "gearwright/drive/short_forms.hpp"

namespace gearwright {
namespace {

using M = SetMember;

BothFlanks relieved(double tip, double crowning) {
  FlankModifications flank;
  flank.profile_crowning = crowning;
  flank.profile_slope = tip;
  return {flank, flank};
}

Drive train(bool gear2_input) {
  StageSpec stage;
  stage.pair.teeth = {19, 58};
  for (const std::size_t i : {0, 1}) {
    CylindricalSpec spec;
    spec.normal_module = 2.0;
    spec.face_width = 20.0;
    spec.thickness_allowance = -0.04;
    stage.pair.specs[i] = spec;
    stage.pair.shifts[i] = 0.0;
    stage.pair.modifications[i] = relieved(0.004, 0.006);
  }
  stage.pair.center_distance = 77.0;
  auto made = train_of({stage});
  EXPECT_TRUE(made);
  DriveInput input = std::move(made).take();
  if (gear2_input) std::swap(input.graph.inputs.front(), input.graph.output);
  input.harmonics = 5;
  return testing::taken(make_drive(input));
}

TEST(DriveErrorTest, OneMeshHasTheCurveOfItsPair) {
  for (const bool gear2_drives : {false, true}) {
    const Drive drive = train(gear2_drives);
    ASSERT_TRUE(drive.error);
    const auto setup = ContactSetup::of(*drive.geometry.pairs[0], {},
                                        {relieved(0.004, 0.006), relieved(0.004, 0.006)});
    ASSERT_TRUE(setup);
    const auto contact = analyse_contact(setup->pair(gear2_drives), {kErrorPositions});
    const double at_output = gear2_drives ? 58.0 / 19.0 : 1.0;
    EXPECT_GT(contact.peak_to_peak.arcsec(), 1.0);
    EXPECT_NEAR(drive.error->peak_to_peak, contact.peak_to_peak.rad() * at_output, 1e-13);
    ASSERT_EQ(drive.error->lines.size(), 5u);
    for (std::size_t k = 0; k < 5; ++k) {
      EXPECT_NEAR(drive.error->lines[k].amplitude, contact.harmonics[k].rad() * at_output, 1e-13);
      EXPECT_NEAR(drive.error->lines[k].frequency_ratio,
                  static_cast<double>(k + 1) * (gear2_drives ? 58 : 19), 1e-12);
    }
  }
}

Drive planetary(int sun, int planet, int ring, int planets, double tip, double crowning,
                int harmonics = 6) {
  PlanetarySpec set;
  set.z(M::sun) = sun;
  set.z(M::planet) = planet;
  set.z(M::ring) = ring;
  set.planets = planets;
  set.normal_module = 2.0;
  set.face_width.all = 20.0;
  set.allowance.all = -0.04;
  set.tip_diameter.each[static_cast<std::size_t>(M::ring)] = 2.0 * (ring - 1.5);
  auto made = graph_of(set);
  EXPECT_TRUE(made);
  DriveGraph graph = std::move(made).take();
  if (tip != 0.0 || crowning != 0.0)
    for (DriveGear& gear : graph.gears) gear.modifications = relieved(tip, crowning);
  return testing::taken(make_drive({graph, {}, harmonics}));
}

TEST(DriveErrorTest, ConjugateFlanksHaveNone) {
  const Drive drive = planetary(20, 25, 70, 3, 0.0, 0.0);
  ASSERT_TRUE(drive.error);
  EXPECT_EQ(drive.error->peak_to_peak, 0.0);
  for (const auto& line : drive.error->lines) EXPECT_EQ(line.amplitude, 0.0);
}

TEST(DriveErrorTest, PlanetsInSequenceLeaveEveryThirdHarmonic) {
  const Drive one = planetary(20, 25, 70, 1, 0.004, 0.006);
  const Drive three = planetary(20, 25, 70, 3, 0.004, 0.006);
  ASSERT_TRUE(one.error && three.error);
  for (std::size_t k = 0; k < 6; ++k) {
    const double expected = (k + 1) % 3 == 0 ? one.error->lines[k].amplitude : 0.0;
    EXPECT_NEAR(three.error->lines[k].amplitude, expected, 1e-15);
  }
  EXPECT_GT(one.error->lines[0].amplitude, 1e-6);
  EXPECT_LT(three.error->peak_to_peak, one.error->peak_to_peak);
  // Curves in phase do not cancel.
  const Drive single = planetary(24, 18, 60, 1, 0.004, 0.006);
  const Drive in_phase = planetary(24, 18, 60, 3, 0.004, 0.006);
  EXPECT_NEAR(in_phase.error->peak_to_peak, single.error->peak_to_peak, 1e-15);
}

// The sun turns by θ, and the planet follows with the transmission error of their mesh. The mesh
// with the ring is evaluated at the resulting position of the planet.
std::vector<double> turned_by_hand(const Drive& drive) {
  const auto flanks = relieved(0.004, 0.006);
  const Pair& sp = *drive.geometry.pairs[0];
  const Pair& pr = *drive.geometry.pairs[1];
  const auto one = ContactSetup::of(sp, {}, {flanks, flanks});
  const auto two = ContactSetup::of(pr, {}, {flanks, flanks});
  EXPECT_TRUE(one && two);
  const ContactPair sun = one->pair(false), ring = two->pair(false);
  Transmission of_sun(sun), of_ring(ring);
  const int z_p = drive.graph.gears[1].teeth;
  const double pitch_p = 2 * std::acos(-1.0) / z_p;
  std::vector<double> output;
  for (int i = 0; i < kErrorPositions; ++i) {
    const double theta = sun.pitch() * i / kErrorPositions;
    const double te_sun = of_sun.at(theta).te();
    const double planet = theta * sun.ratio() + te_sun;
    // The planet has a space towards the sun. With an even number of teeth it also has a space
    // towards the ring.
    const double at_ring = planet + (z_p % 2 == 0 ? pitch_p / 2 : 0.0);
    const double te_ring = of_ring.at(at_ring).te();
    const double e = sp.gear(2).base_radius() * te_sun + pr.gear(2).base_radius() * te_ring;
    output.push_back(e / (sp.gear(1).base_radius() + pr.gear(2).base_radius()));
  }
  return output;
}

TEST(DriveErrorTest, OnePlanetAddsBothCurvesWhereItStands) {
  for (const auto& [s, p, r] : {std::array{20, 25, 70}, {24, 18, 60}, {19, 17, 53}}) {
    const Drive drive = planetary(s, p, r, 1, 0.004, 0.006);
    ASSERT_TRUE(drive.error);
    const std::vector<double> expected = turned_by_hand(drive);
    const auto waves = harmonics(expected);
    EXPECT_NEAR(drive.error->peak_to_peak, peak_to_peak(expected), 0.02 * peak_to_peak(expected));
    for (std::size_t k = 0; k < 3; ++k)
      EXPECT_NEAR(drive.error->lines[k].amplitude, waves[k].rad(), 0.01 * waves[0].rad())
          << s << " " << p << " " << k;
  }
}

// Shaft 1 drives shaft 2 by 19 : 58 teeth, and a pinion of 20 teeth on shaft 2 meshes with a rack.
// Without `pair`, the pinion is on shaft 1.
DriveGraph steering(bool pair, bool rack_drives) {
  CylindricalSpec spec;
  spec.normal_module = 2.0;
  spec.face_width = 20.0;
  spec.thickness_allowance = -0.04;
  const auto gear = [&](const char* name, std::size_t body, int teeth) {
    DriveGear g;
    g.name = name;
    g.body = body;
    g.teeth = teeth;
    g.spec = spec;
    g.shift = 0.0;
    g.modifications = relieved(0.004, 0.006);
    return g;
  };
  DriveGear bar;
  bar.name = "bar";
  bar.rack = RackBar{};
  DriveGraph graph;
  const std::size_t shaft = pair ? 1 : 0;
  for (const char* name : {"shaft1", "shaft2", "rack"})
    if (pair || name != std::string("shaft2")) graph.bodies.push_back({name, std::nullopt, 1, {}});
  bar.body = shaft + 1;
  if (pair) graph.gears = {gear("one", 0, 19), gear("two", 1, 58)};
  graph.gears.push_back(gear("pinion", shaft, 20));
  graph.gears.push_back(bar);
  const std::size_t at = graph.gears.size() - 2;
  if (pair) graph.meshes.push_back({"pair", {0, 1}, std::nullopt, 77.0});
  graph.meshes.push_back({"bar", {at, at + 1}, std::nullopt, std::nullopt});
  graph.inputs = {0};
  graph.output = bar.body;
  if (rack_drives) std::swap(graph.inputs.front(), graph.output);
  return graph;
}

// The travel of the rack has the error of the contact of the pinion with its rack. If the rack
// drives, the pinion has the same error divided by its reference radius.
TEST(DriveErrorTest, ARackHasTheErrorOfItsContact) {
  for (const bool rack_drives : {false, true}) {
    const auto drive = make_drive({steering(false, rack_drives), {}, 5});
    ASSERT_TRUE(drive);
    ASSERT_TRUE(drive->error);
    const RackPair& pair = *drive->geometry.racks[0];
    ContactOptions options;
    options.modifications[0] = relieved(0.004, 0.006);
    options.gear2_drives = rack_drives;
    options.request.positions = kErrorPositions;
    const auto touching = contact(pair, {}, options);
    ASSERT_TRUE(touching);
    const double travel = touching->rack.of(touching->peak_to_peak);
    EXPECT_GT(travel, 1e-4);
    EXPECT_EQ(drive->error->lever.has_value(), !rack_drives);
    const double radius = pair.pinion.reference_diameter / 2;
    EXPECT_NEAR(drive->error->lever.value_or(radius) * drive->error->peak_to_peak, travel, 1e-12);
    EXPECT_NEAR(drive->error->lever.value_or(radius) * drive->error->lines[0].amplitude,
                touching->rack.of(touching->harmonics[0]), 1e-12);
  }
}

// Two meshes of different frequencies add their peaks. The error of shaft 2 moves the rack by its
// reference radius.
TEST(DriveErrorTest, APairBeforeTheRackAddsItsError) {
  const auto both = make_drive({steering(true, false), {}, 5});
  const auto alone = make_drive({steering(false, false), {}, 5});
  ASSERT_TRUE(both && alone);
  ASSERT_TRUE(both->error && alone->error);
  const double of_pair = train(false).error->peak_to_peak;
  EXPECT_NEAR(*both->error->lever * both->error->peak_to_peak,
              *alone->error->lever * alone->error->peak_to_peak + 20.0 * of_pair, 1e-12);
}

// Without modifications and errors, the travel of a rack is exact. If a rack transmits the motion
// of one pinion to another one, their phase is unknown, so there is no result.
TEST(DriveErrorTest, AConjugateRackHasNoneAndTwoPinionsAreUnknown) {
  DriveGraph graph = steering(false, false);
  graph.gears[0].modifications = {};
  const auto exact = make_drive({graph, {}, 3});
  ASSERT_TRUE(exact && exact->error);
  EXPECT_EQ(exact->error->peak_to_peak, 0.0);
  graph.bodies.push_back({"idler", std::nullopt, 1, {}});
  graph.gears.push_back(graph.gears[0]);
  graph.gears.back().name = "second";
  graph.gears.back().body = 2;
  graph.meshes.push_back({"second", {2, 1}, std::nullopt, std::nullopt});
  graph.output = 2;
  const auto two = make_drive({graph, {}, 3});
  ASSERT_TRUE(two) << two.error().message();
  EXPECT_FALSE(two->error);
}

// A pinion of 21 teeth meshes with a wheel of 58 teeth and with a rack, in the directions
// `to_wheel` and `to_rack` from its axis, in turns. Rack and pinion are gear 2 and gear 1 of their
// mesh.
DriveGraph pinion_between(double to_wheel, double to_rack, bool rack_drives) {
  DriveGraph graph = steering(false, rack_drives);
  DriveGear wheel = graph.gears[0];
  graph.gears[0].shift = 0.5;
  graph.gears[0].teeth = 21;
  wheel.name = "wheel";
  wheel.teeth = 58;
  wheel.body = graph.bodies.size();
  graph.bodies.push_back({"wheel", std::nullopt, 1, {}});
  graph.gears.push_back(wheel);
  // The equation of a mesh has the direction from its first gear to its second gear.
  graph.meshes.push_back({"wheel", {2, 0}, std::nullopt, 80.0});
  graph.meshes.back().direction = Angle::radians((to_wheel + 0.5) * kTurn);
  graph.meshes.front().direction = Angle::radians(to_rack * kTurn);
  (rack_drives ? graph.output : graph.inputs.front()) = wheel.body;
  return graph;
}

double te_at(Transmission& transmission, double rotation1) {
  const ContactPair& pair = transmission.pair();
  return pair.turned() * transmission.at(pair.to_world(rotation1)).te();
}

// The error of the output of pinion_between() while the wheel turns by one pitch, as the travel of
// the rack in mm or the rotation of the wheel in rad. The pinion turns by x_w from the position in
// which a tooth points to the wheel, and by x_r from the position in which a tooth points to the
// rack.
std::vector<double> pinion_turned_by_hand(const Drive& drive, double to_wheel, double to_rack,
                                          bool rack_drives) {
  const auto flanks = relieved(0.004, 0.006);
  const auto setup = ContactSetup::of(*drive.geometry.pairs[1], {}, {flanks, flanks});
  ContactOptions options;
  options.modifications[0] = flanks;
  options.gear2_drives = rack_drives;
  const RackPair& rack = *drive.geometry.racks[0];
  const auto bar = contact_pair(rack, {}, options);
  EXPECT_TRUE(setup && bar);
  const ContactPair pair = setup->pair(rack_drives);
  Transmission of_wheel(pair), of_rack(**bar);
  const double pitch = kTurn / 21, r = rack.pinion.reference_diameter / 2;
  // The sense of rotation in which the directions are measured.
  const double sense = drive.motion.speeds[0][0].value() < 0.0 ? -1.0 : 1.0;
  std::vector<double> output;
  for (int i = 0; i < kErrorPositions; ++i) {
    // The wheel is gear 1 of its pair. It has a tooth towards the pinion where the pinion has a
    // space.
    const double turned = pitch * (i - 0.5 * kErrorPositions) / kErrorPositions;
    const double te_w = te_at(of_wheel, turned * 21 / 58);
    const double x_w = turned + te_w + pitch / 2;
    const double x_r = x_w - sense * (to_rack - to_wheel) * kTurn;
    const double te_r = te_at(of_rack, pitch * std::remainder(x_r / pitch, 1.0));
    // If the rack drives, te_w is the lead of the pinion at a given rotation of the wheel.
    output.push_back(rack_drives ? -(te_w + te_r) * 21 / 58 : r * (te_w + te_r));
  }
  return output;
}

// (5) The shift 0.5 makes the teeth of the pinion thicker than half a pitch, which delays one mesh.
// The series of 64 positions is interpolated between its positions, so its harmonics have a small
// error.
TEST(DriveErrorTest, APinionBetweenAWheelAndARackAddsBothCurves) {
  for (const bool rack_drives : {false, true})
    for (const auto& [to_wheel, to_rack] :
         {std::array{0.5, 0.0}, {0.5, 0.25}, {0.1, 0.43}, {0.37, 0.0}}) {
      const auto drive = make_drive({pinion_between(to_wheel, to_rack, rack_drives), {}, 5});
      ASSERT_TRUE(drive) << drive.error().message();
      ASSERT_TRUE(drive->error);
      ASSERT_EQ(drive->error->lines.size(), 5u);
      const auto expected = pinion_turned_by_hand(*drive, to_wheel, to_rack, rack_drives);
      const auto waves = harmonics(expected);
      const double lever = drive->error->lever.value_or(1.0);
      EXPECT_NEAR(lever * drive->error->peak_to_peak, peak_to_peak(expected),
                  0.02 * peak_to_peak(expected));
      for (std::size_t k = 0; k < 3; ++k)
        EXPECT_NEAR(lever * drive->error->lines[k].amplitude, waves[k].rad(), 0.01 * waves[0].rad())
            << rack_drives << " " << to_wheel << " " << to_rack << " " << k;
    }
}

// (6) The output is shaft 2, so the rack and a second pinion on it carry no load. An error of the
// teeth of the rack, an unknown phase of the second pinion or unknown teeth do not change the
// error.
TEST(DriveErrorTest, IdleMeshesDoNotCount) {
  const MeshErrors errors = [](std::size_t) {
    ContactErrors e;
    e.helix_twist[1] = 5e-6;
    return e;
  };
  DriveGraph graph = steering(true, false);
  graph.output = 1;
  const Drive alone = train(false);
  const auto expect_same = [&](const MeshErrors& errors) {
    const auto drive = make_drive({graph, {}, 5});
    ASSERT_TRUE(drive) << drive.error().message();
    const auto found = transmission_error(*drive, 5, errors);
    const auto expected = transmission_error(alone, 5, errors);
    ASSERT_TRUE(found && expected);
    EXPECT_EQ(found->peak_to_peak, expected->peak_to_peak);
    ASSERT_EQ(found->lines.size(), expected->lines.size());
    for (std::size_t k = 0; k < 5; ++k)
      EXPECT_EQ(found->lines[k].amplitude, expected->lines[k].amplitude);
  };
  expect_same(errors);
  graph.bodies.push_back({"idler", std::nullopt, 1, {}});
  graph.gears.push_back(graph.gears[2]);
  graph.gears.back().name = "second";
  graph.gears.back().body = 3;
  graph.meshes.push_back({"second", {4, 3}, std::nullopt, std::nullopt});
  expect_same(errors);
  graph.gears[2].spec = graph.gears[4].spec = std::nullopt;
  expect_same({});
}

// (7) The curves of the contacts of a drive give the same error, bit by bit. Curves of twice the
// height give twice the error.
TEST(DriveErrorTest, ContactsAreNotComputedAgain) {
  const MeshErrors errors = [](std::size_t) {
    ContactErrors e;
    e.helix_twist[0] = 5e-6;
    return e;
  };
  const auto rack = make_drive({steering(true, false), {}, 5});
  ASSERT_TRUE(rack);
  for (Drive drive : {train(false), train(true), *rack}) {
    const auto alone = transmission_error(drive, 5, errors);
    drive.contacts = mesh_contacts(drive, errors);
    const auto found = transmission_error(drive, 5, errors);
    bool all = true;
    for (auto& mesh : drive.contacts) {
      all = all && mesh;
      if (!mesh) continue;
      for (ContactPoint& p : mesh->driving.positions) p.te = 2.0 * p.te;
    }
    const auto twice = transmission_error(drive, 5, errors);
    ASSERT_TRUE(alone && found && twice);
    EXPECT_EQ(found->peak_to_peak, alone->peak_to_peak);
    if (all) {
      EXPECT_EQ(twice->peak_to_peak, 2 * alone->peak_to_peak);
    }
    EXPECT_GT(twice->peak_to_peak, 1.1 * alone->peak_to_peak);
  }
}

}  // namespace
}  // namespace gearwright
