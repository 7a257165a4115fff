// Laws: (1) without errors, a half behaves as a separate helical pair under half of the torque (2)
// the deflections of the halves agree with the deflection of the whole face   (3) a stagger s
// multiplies harmonic k of the loaded TE by |cos πks|   (4) mirrored errors exchange the halves (5)
// under a vanishing torque, the teeth touch at the points where they touch without load.
#include "gearwright/arrange/loaded_pair.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "gearwright/base/units.hpp"
#include "gearwright/contact/halves.hpp"

namespace gearwright {
namespace {

struct Sample {
  Arranged half;
  std::array<std::optional<Halves>, 2> halves;
};

// A pair with z = 17 and 29, m_n = 3 mm, β = 25°, and b = 50 mm including a gap of 6 mm. The pinion
// may be crowned.
Sample sample(double stagger, std::array<double, 2> faces = {50.0, 50.0}, double crowning = 0.0) {
  GivenPair given;
  for (const int which : {1, 2}) {
    given.gears[which - 1].emplace();
    GearInput& g = given.gear(which);
    g.cylindrical.teeth = which == 1 ? 17 : 29;
    g.cylindrical.normal_module = 3.0;
    g.cylindrical.helix_angle = Angle::degrees(which == 1 ? 25 : -25);
    g.helix_given = true;
    g.cylindrical.face_width = faces[which - 1];
    g.face_width_given = true;
    g.cylindrical.rack = *iso53_rack("ISO53-A");
    g.bore = Bore{.diameter = 20.0};
    g.double_helical = DoubleHelical{.gap = 6.0, .stagger_pitches = stagger};
  }
  for (FlankModifications& flank : given.gear(1).modifications) flank.lead_crowning = crowning;
  EXPECT_FALSE(halve(given));
  Sample s{std::move(arrange(given)).take(), {}};
  for (const int which : {1, 2}) {
    const std::size_t i = which - 1;
    s.halves[i] =
        std::move(halves_of(s.half.gear(which), *given.gear(which).double_helical)).take();
  }
  return s;
}

LoadInput torque(double newton_metres) {
  LoadInput input;
  input.given = true;
  input.torques = {newton_metres};
  input.positions = 16;
  input.accuracy = ComplianceAccuracy::draft;
  return input;
}

LoadAnalysis analysed(const Sample& s, const ContactErrors& errors, const LoadInput& input) {
  std::vector<Warning> warnings;
  auto made = loaded_halves(s.half, s.halves, errors, input, warnings);
  EXPECT_TRUE(made) << made.error().message();
  return std::move(made).take();
}

TEST(LoadedHalves, AreHelicalPairsUnderHalfOfTheTorque) {
  const Sample s = sample(0.0);
  const LoadAnalysis whole = analysed(s, {}, torque(300));
  std::vector<Warning> warnings;
  const auto alone = loaded(s.half, {}, torque(150), warnings);
  ASSERT_TRUE(alone);
  const LoadedTorque& one = alone->contact->torques[0];
  const LoadedTorque& both = whole.contact->torques[0];
  EXPECT_EQ(newton_metres(both.torque), 300.0);
  for (std::size_t i = 0; i < one.positions.size(); ++i) {
    EXPECT_EQ(one.positions[i].te.rad(), whole.halves[0].contact->torques[0].positions[i].te.rad());
    EXPECT_NEAR(one.positions[i].te.rad(), both.positions[i].te.rad(), 1e-15);
  }
  EXPECT_EQ(one.max_pressure, both.max_pressure);
  EXPECT_NEAR(one.stiffness.mean, both.stiffness.mean, 1e-12 * both.stiffness.mean);
  EXPECT_NEAR(one.tangent.mean, both.tangent.mean, 1e-12 * both.tangent.mean);
}

TEST(LoadedHalves, RejectInputsWithoutTorque) {
  const Sample s = sample(0.0);
  const auto field = [&](const LoadInput& input) {
    std::vector<Warning> warnings;
    const auto found = loaded(s.half, {}, input, warnings);
    return found ? std::string() : found.error().field;
  };
  EXPECT_EQ(field({}), "load.torques");
  EXPECT_EQ(field(torque(0.0)), "load.torques");
  EXPECT_EQ(field(torque(-5.0)), "load.torques");
  LoadInput third = torque(5.0);
  third.driver = 3;
  EXPECT_EQ(field(third), "load.driver");
}

// If both halves are equal, only one half is computed. The result of the other half is its exact
// mirror image, bit by bit.
TEST(LoadedHalves, AreComputedOnceIfTheyAreEqual) {
  const Sample s = sample(0.0, {50.0, 50.0}, 0.01);
  LoadInput input = torque(300);
  input.deflection_bow = 4.0;
  EXPECT_TRUE(equal_halves(*s.halves[0], {.center_distance = 0.02}, input));
  EXPECT_FALSE(equal_halves(*s.halves[0], {.crossing = Angle::degrees(0.01)}, input));
  const LoadAnalysis whole = analysed(s, {}, input);
  std::vector<Warning> warnings;
  const auto image = loaded(s.half, {}, input_of_half(input, *s.halves[0], s.half.gear(1), true),
                            warnings, nullptr, HalfPlace{true, &*whole.compliance});
  ASSERT_TRUE(image);
  const LoadedTorque& found = whole.halves[1].contact->torques[0];
  const LoadedTorque& expected = image->contact->torques[0];
  for (std::size_t i = 0; i < expected.positions.size(); ++i)
    EXPECT_EQ(found.positions[i].te.rad(), expected.positions[i].te.rad());
  EXPECT_EQ(found.max_pressure, expected.max_pressure);
  EXPECT_EQ((found.face_load - expected.face_load.reverse()).norm(), 0.0);
  EXPECT_EQ((found.root_stress[1] - expected.root_stress[1].rowwise().reverse()).norm(), 0.0);
  input.deflection_slope = 3.0;
  EXPECT_FALSE(equal_halves(*s.halves[0], {}, input));
}

TEST(LoadedHalves, HaveTheDeflectionOfTheWholeFace) {
  const Sample s = sample(0.0);
  LoadInput input = torque(100);
  input.deflection_slope = 7.0;
  input.deflection_bow = 4.0;
  const Halves& h = *s.halves[0];
  const auto at = [](const LoadInput& i, double x) {
    return i.deflection_offset + i.deflection_slope * x + i.deflection_bow * (1 - 4 * x * x);
  };
  for (const bool below : {false, true}) {
    const LoadInput half = input_of_half(input, h, s.half.gear(1), below);
    for (const double z : {-0.5, -0.1, 0.3, 0.5}) {
      const double there = (h.face_width - h.half_face_width) / 2 + z * h.half_face_width;
      EXPECT_NEAR(at(half, z), at(input, (below ? -there : there) / h.face_width), 1e-13);
    }
    EXPECT_EQ(half.torques[0], 50.0);
  }
}

TEST(LoadedHalves, StaggeredHalvesCancelHarmonics) {
  const LoadAnalysis whole = analysed(sample(0.5), {}, torque(300));
  const auto& half = whole.halves[0].contact->torques[0].harmonics;
  const auto& both = whole.contact->torques[0].harmonics;
  ASSERT_GE(both.size(), 3u);
  EXPECT_LT(both[0].rad(), 1e-3 * half[0].rad());
  EXPECT_NEAR(both[1].rad(), half[1].rad(), 1e-3 * half[0].rad());
  EXPECT_NEAR(whole.halves[1].contact->torques[0].harmonics[0].rad(), half[0].rad(),
              1e-3 * half[0].rad());
}

TEST(LoadedHalves, AreExchangedByMirroredErrors) {
  const Sample s = sample(0.0);
  const ContactErrors errors{.crossing = Angle::degrees(0.01),
                             .intersecting = Angle::degrees(0.02)};
  const LoadAnalysis one = analysed(s, errors, torque(300));
  const LoadAnalysis two = analysed(s, mirrored(errors), torque(300));
  const auto load = [](const LoadAnalysis& a, std::size_t h) -> const LoadedTorque& {
    return a.halves[h].contact->torques[0];
  };
  EXPECT_NE(load(one, 0).max_pressure, load(one, 1).max_pressure);
  EXPECT_EQ(load(one, 0).max_pressure, load(two, 1).max_pressure);
  EXPECT_EQ(load(one, 1).peak_to_peak.rad(), load(two, 0).peak_to_peak.rad());
  const auto& along = load(one, 0).face_load;
  EXPECT_EQ((along - load(two, 1).face_load.reverse()).norm(), 0.0);
}

// Law (5). The faces are 50 and 34 mm wide, so the middles of their halves are at 14 and 10 mm. The
// errors move the contact by about 1 mm. If the contact lies inside the flanks, the middle of some
// slice lies within h/2 of the point of contact, where h is the width of a slice. With a crowning C
// over the face width b, the gap in this middle is less than C (h/b)². The force of a half is 0.002
// N, and a slice is stiffer than 1 N/µm.
TEST(LoadedHalves, TouchWhereTheyTouchWithoutLoad) {
  constexpr double kCrowning = 0.01, kYield = 2e-6;  // mm
  const ContactErrors errors{.crossing = Angle::degrees(0.01),
                             .intersecting = Angle::degrees(0.005)};
  for (const auto& [faces, driver] :
       {std::pair{std::array{50.0, 34.0}, 1}, {std::array{34.0, 50.0}, 2}}) {
    const Sample s = sample(0.0, faces, kCrowning);
    LoadInput input = torque(1e-4);
    input.driver = driver;
    input.positions = 4;
    input.slices = 10;
    const LoadAnalysis found = analysed(s, errors, input);
    const ContactSetup setup = std::move(setup_of(s.half, errors)).take();
    const HalvesPair pair = HalvesSetup(setup, 0.0).pair(errors, driver == 2);
    const Gear& driven = s.half.gear(2);
    for (const std::size_t i : {0, 1}) {
      const ContactResult contact = analyse_contact(*pair.half[i], {input.positions});
      const LoadedContact& load = *found.halves[i].contact;
      const double width = load.slices[0].width();
      const double sagging = kCrowning * std::pow(width / s.half.gear(1).spec.face_width, 2);
      const double turn = (sagging + kYield) /
                          (driven.base_radius() * std::cos(driven.reference().base_helix_angle));
      int inside = 0;
      for (std::size_t k = 0; k < contact.positions.size(); ++k) {
        const ContactPoint& p = contact.positions[k];
        const LoadedPosition& under = load.torques[0].positions[k];
        EXPECT_NEAR(under.unloaded_te.rad(), p.te.rad(), 1e-12);
        if (is_edge(p.kind)) continue;
        ++inside;
        EXPECT_NEAR(under.te.rad(), p.te.rad(), turn);
        const auto& bears = *std::max_element(
            under.pairs.begin(), under.pairs.end(),
            [](const LoadedPair& a, const LoadedPair& b) { return a.share < b.share; });
        Eigen::Index slice = 0;
        bears.line_load.maxCoeff(&slice);
        for (const std::size_t g : {0, 1})
          EXPECT_NEAR(load.slices[g].middle(static_cast<int>(slice)),
                      (i == 0 ? 1.0 : -1.0) * p.height[g], width);
      }
      EXPECT_GT(inside, 1);
    }
  }
}

}  // namespace
}  // namespace gearwright
