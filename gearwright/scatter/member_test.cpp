// Laws: (1) without deviations, the numbers are those of analyse_contact()   (2) a member equals a
// pair with the same errors, modifications and thickness   (3) a double-helical pair without errors
// that tilt an axis has the numbers of a half. Golden: closed forms of spur gears (page 14).
#include "gearwright/scatter/member.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "gearwright/contact/contact.hpp"
#include "gearwright/contact/continuous.hpp"
#include "gearwright/contact/halves.hpp"
#include "gearwright/math/sobol.hpp"
#include "gearwright/scatter/testing/drawn_pair.hpp"

namespace gearwright {
namespace {

using Q = ScatterQuantity;

Deviation none(const ContactSetup& setup) { return deviation_at(setup, {}, {}); }

// The mean place of the contact along the face of a pair, relative to half of its width.
double along_face(const ContactResult& pair, double face_width) {
  double sum = 0.0;
  for (const ContactPoint& p : pair.positions)
    if (p.kind != TouchKind::line) sum += p.height[0] / (face_width / 2);
  return sum / static_cast<double>(pair.positions.size());
}

TEST(Member, WithoutDeviationsIsThePairAsDrawn) {
  for (auto drawn :
       {testing::crowned_helical_pair(), testing::plain_helical_pair(), testing::spur_pair(true)}) {
    drawn.errors = {.center_distance = 0.01, .crossing = Angle::degrees(0.02)};
    const ContactSetup setup = drawn.setup();
    for (const bool gear2_drives : {false, true}) {
      const MemberRequest request{32, gear2_drives, {}};
      const FamilyMember m = member_at(setup, none(setup), request);
      ContactRequest contact;
      contact.positions = 32;
      const auto driving = analyse_contact(setup.pair(gear2_drives), contact);
      const auto other = analyse_contact(setup.pair(!gear2_drives), contact);
      EXPECT_EQ(m[Q::harmonic1], driving.harmonics[0].rad());
      EXPECT_EQ(m[Q::harmonic2], driving.harmonics[1].rad());
      EXPECT_EQ(m[Q::harmonic3], driving.harmonics[2].rad());
      EXPECT_EQ(m[Q::least_play], least_play(driving, other, gear2_drives)->rad());
      double sum = 0.0;
      int edges = 0;
      for (const ContactPoint& p : driving.positions) {
        sum += p.te.rad();
        edges += is_edge(p.kind) ? 1 : 0;
      }
      EXPECT_EQ(m[Q::mean], sum / 32);
      EXPECT_EQ(m[Q::edge_share], edges / 32.0);
      EXPECT_NEAR(*m[Q::along_face], along_face(driving, drawn.gears[0].face_width), 1e-12);
      EXPECT_GE(m[Q::peak_to_peak], driving.peak_to_peak.rad());
      EXPECT_EQ(m[Q::peak_to_peak], continuous_peak_to_peak(setup, none(setup), request).value);
      EXPECT_FALSE(m.lost);
    }
  }
}

// Law (3).
TEST(Member, OfADoubleHelicalPairWithEqualHalvesIsAHalf) {
  auto drawn = testing::crowned_helical_pair();
  drawn.modifications.profile_crowning = 0.0;  // the contact remains in the middle of the face
  const std::vector<ScatterTolerance> thick{
      testing::tolerance("gear1.thickness_allowance_mm", 1.0, -0.02, 0.02, VaryingThickness{1})};
  for (const double lead_slope : {0.0, 0.004}) {
    drawn.modifications.lead_slope = lead_slope;
    drawn.errors = {.center_distance = 0.01};
    drawn.gap = {};
    const ContactSetup plain = drawn.setup();
    drawn.gap = 6.0;
    const ContactSetup halves = drawn.setup();
    for (const bool gear2_drives : {false, true}) {
      const MemberRequest of_half{32, gear2_drives, {}, {}};
      MemberRequest whole = of_half;
      whole.stagger = 0.0;
      for (const double allowance : {0.0, 0.01}) {
        const FamilyMember a =
            member_at(plain, deviation_at(plain, thick, std::vector{allowance}), of_half);
        const FamilyMember b =
            member_at(halves, deviation_at(halves, thick, std::vector{allowance}), whole);
        for (const Q q : {Q::harmonic1, Q::harmonic2, Q::mean, Q::peak_to_peak, Q::along_face,
                          Q::edge_share, Q::least_play})
          EXPECT_NEAR(*a[q], *b[q], 1e-12) << static_cast<int>(q);
        EXPECT_EQ(a.lost, b.lost);
        EXPECT_FALSE(b[Q::long_period]);
        EXPECT_EQ(b[Q::along_face] == 0.0, lead_slope == 0.0);
      }
      // Staggered halves also touch in the middle of the face, if the teeth have no slope.
      whole.stagger = 0.5;
      const FamilyMember staggered = member_at(halves, none(halves), whole);
      EXPECT_EQ(staggered[Q::along_face] == 0.0, lead_slope == 0.0);
    }
  }
}

// The errors tilt the axes, so the halves differ. Half of the cases have edges in contact.
TEST(Member, OfADoubleHelicalPairIsTheContactOfTheWholeGears) {
  auto drawn = testing::crowned_helical_pair();
  drawn.gap = 6.0;
  const ContactSetup setup = drawn.setup();
  const double face = drawn.gears[0].face_width;
  const std::vector<ScatterTolerance> tolerances{testing::crossing(0.2),
                                                 testing::intersecting(0.2)};
  const ContactRequest at{.positions = 32};
  int one_edge = 0, outward = 0, inward = 0;
  for (const double stagger : {0.0, 0.5, 0.3}) {
    for (const auto& [crossing, intersecting] :
         {std::pair{0.04, 0.0}, {0.06, 0.1}, {-0.06, 0.1}, {0.03, -0.15}, {-0.11, 0.02}}) {
      for (const bool gear2_drives : {false, true}) {
        const Deviation askew =
            deviation_at(setup, tolerances, std::vector{crossing, intersecting});
        const FamilyMember m = member_at(setup, askew, {32, gear2_drives, {}, stagger});
        const HalvesSetup halves(setup, stagger);
        const HalvesPair driving = halves.pair(askew.errors, gear2_drives);
        const HalvesContact found = analyse_contact(driving.mesh, at);
        const HalvesContact other =
            analyse_contact(halves.pair(askew.errors, !gear2_drives).mesh, at);
        double sum = 0.0;
        for (const ContactPoint& p : found.whole.positions) sum += p.te.rad();
        EXPECT_NEAR(*m[Q::mean], sum / 32, 1e-12);
        EXPECT_NEAR(*m[Q::harmonic1], found.whole.harmonics[0].rad(), 1e-12);
        EXPECT_NEAR(*m[Q::harmonic2], found.whole.harmonics[1].rad(), 1e-12);
        EXPECT_NEAR(*m[Q::harmonic3], found.whole.harmonics[2].rad(), 1e-12);
        EXPECT_NEAR(*m[Q::least_play], least_play(found.whole, other.whole, gear2_drives)->rad(),
                    1e-12);
        EXPECT_EQ(m[Q::peak_to_peak], continuous_span(driving.mesh, 32)->rad());
        EXPECT_EQ(m[Q::peak_to_peak],
                  continuous_peak_to_peak(setup, askew, {32, gear2_drives, {}, stagger}).value);
        std::array<int, 2> edges{};
        for (const std::size_t i : {0, 1})
          for (const ContactPoint& p : found.half[i].positions) edges[i] += is_edge(p.kind);
        EXPECT_EQ(m[Q::edge_share], (edges[0] + edges[1]) / 64.0);
        // Half A extends away from the apex towards +z, and half B towards −z.
        const double a = along_face(found.half[0], face), b = -along_face(found.half[1], face);
        EXPECT_GT(std::abs(std::abs(a) - std::abs(b)), 1e-4);
        EXPECT_NEAR(*m[Q::along_face], std::abs(a) > std::abs(b) ? a : b, 1e-9);
        one_edge += edges[0] != edges[1];
        ++(m[Q::along_face] > 0.0 ? outward : inward);
      }
    }
  }
  EXPECT_GT(one_edge, 0);
  EXPECT_GT(outward, 0);
  EXPECT_GT(inward, 0);
}

TEST(Member, IsThePairWithItsErrorsAndModifications) {
  auto drawn = testing::crowned_helical_pair();
  drawn.errors = {.center_distance = -0.004, .axial = 0.1};
  using P = Modification;
  const std::vector<ScatterTolerance> tolerances{
      testing::distance(0.02), testing::crossing(0.05),
      testing::tolerance("errors.helix_slope2_um", 1e-3, -9, 9, VaryingError::helix_slope2),
      testing::tolerance("gear1.modifications.lead_crowning_um", 1e-3, -3, 3,
                         VaryingModification{1, P::lead_crowning})};
  const ContactSetup setup = drawn.setup();
  const FamilyMember m = member_at(
      setup, deviation_at(setup, tolerances, std::vector{0.01, -0.03, 5.0, 2.0}), {16, false, {}});
  drawn.errors.center_distance += 0.01;
  drawn.errors.crossing = Angle::radians(-0.03 * kRadPerDeg);
  drawn.errors.helix_twist[1] = 0.005 / (setup.gear(2).reference_diameter / 2 * 25);
  drawn.modifications.lead_crowning += 0.002;
  const ContactSetup made = drawn.setup();
  const FamilyMember direct = member_at(made, none(made), {16, false, {}});
  for (std::size_t q = 0; q < kScatterQuantities; ++q) {
    ASSERT_EQ(m.value[q].has_value(), direct.value[q].has_value()) << q;
    if (!direct.value[q]) continue;
    EXPECT_NEAR(*m.value[q], *direct.value[q], 1e-13) << q;
  }
}

TEST(Member, ThicknessIsThatOfAPairMadeAnew) {
  for (auto drawn : {testing::spur_pair(false), testing::plain_helical_pair()}) {
    const std::vector<ScatterTolerance> tolerances{
        testing::tolerance("gear1.thickness_allowance_mm", 1.0, -0.02, 0.02, VaryingThickness{1}),
        testing::tolerance("gear2.thickness_allowance_mm", 1.0, -0.03, 0.03, VaryingThickness{2})};
    const ContactSetup setup = drawn.setup();
    for (const bool gear2_drives : {false, true}) {
      const MemberRequest request{8, gear2_drives, {}};
      const FamilyMember m =
          member_at(setup, deviation_at(setup, tolerances, std::vector{0.013, -0.027}), request);
      auto thicker = drawn;
      thicker.gears[0].thickness_allowance += 0.013;
      thicker.gears[1].thickness_allowance -= 0.027;
      const ContactSetup made = thicker.setup();
      const FamilyMember direct = member_at(made, none(made), request);
      EXPECT_NEAR(*m[Q::least_play], *direct[Q::least_play], 1e-12);
      EXPECT_NEAR(*m[Q::mean], *direct[Q::mean], 1e-12);
    }
  }
}

TEST(Member, SpurGearsHaveClosedForms) {
  const ContactSetup plain = testing::spur_pair(false).setup();
  const double r_b2 = plain.gear(2).base_radius();
  const double r_b1 = plain.gear(1).base_radius();
  const double b = 20.0;
  const FamilyMember nominal = member_at(plain, none(plain), {8, false, {}});
  for (const auto& [gamma, delta] :
       {std::pair{0.02, 0.0}, {0.0, 0.03}, {-0.015, 0.02}, {0.01, -0.03}}) {
    Deviation d = none(plain);
    d.errors.crossing = Angle::degrees(gamma);
    d.errors.intersecting = Angle::degrees(delta);
    const double alpha = std::acos((r_b1 + r_b2) / 60.4);
    const double x = gamma * kRadPerDeg * std::cos(alpha);
    const double y = delta * kRadPerDeg * std::sin(alpha);
    const FamilyMember m = member_at(plain, d, {8, false, {}});
    // The error is of second order in the angles, whose greatest value is 0.03°.
    const double second = 4 * 0.03 * 0.03 * kRadPerDeg * kRadPerDeg;
    const double one = b / (2 * r_b2) * std::abs(x + y);
    const double other = b / (2 * r_b2) * std::abs(x - y);
    const double te = *m[Q::mean] - *nominal[Q::mean];
    EXPECT_NEAR(std::min(std::abs(te - one), std::abs(te - other)), 0.0, second + 0.002 * te);
    const double play = *m[Q::least_play] - *nominal[Q::least_play];
    EXPECT_NEAR(play, -b / r_b2 * std::max(std::abs(x), std::abs(y)),
                2 * second + 0.002 * std::abs(play));
    EXPECT_GT(m[Q::edge_share], 0.99);
  }
  // A greater centre distance adds the backlash 2 sin α_wt ΔC/r_b2, with α_wt between the values at
  // both ends.
  Deviation farther = none(plain);
  farther.errors.center_distance = 0.01;
  const double gained =
      *member_at(plain, farther, {8, false, {}})[Q::least_play] - *nominal[Q::least_play];
  const double sine = std::sin(std::acos((r_b1 + r_b2) / 60.405));
  EXPECT_NEAR(gained, 2 * sine * 0.01 / r_b2, 1e-9);
  // A crowned tooth touches at an edge if Δγ is at least 4C/(b cos α_wt), here 0.098162°.
  const ContactSetup crowned = testing::spur_pair(true).setup();
  for (const double degrees : {0.09811, 0.09821}) {
    Deviation d = none(crowned);
    d.errors.crossing = Angle::degrees(degrees);
    EXPECT_EQ(member_at(crowned, d, {16, false, {}}).edge(), degrees > 0.098162) << degrees;
  }
}

// A normal backlash that is printed as 0.0000 mm is no jam.
TEST(Member, ARoundedPlayIsNoJam) {
  const ContactSetup setup = testing::spur_pair(false).setup();
  const Gear& g = setup.gear(2);
  const double per_mm = 2 / (g.reference_diameter * std::cos(g.spec.helix_angle.rad()));
  const double limit = no_backlash(g.spec.normal_module);
  EXPECT_FALSE(jams(Angle::radians(-0.99 * limit * per_mm), g));
  EXPECT_TRUE(jams(Angle::radians(-1.01 * limit * per_mm), g));
}

TEST(Member, LostContactIsNoNumber) {
  const ContactSetup setup = testing::spur_pair(false).setup();
  Deviation d = none(setup);
  d.errors.center_distance = 5.0;
  const FamilyMember m = member_at(setup, d, {8, false, {}});
  EXPECT_TRUE(m.lost);
  EXPECT_FALSE(m.jam);
  EXPECT_FALSE(m[Q::peak_to_peak]);
  EXPECT_FALSE(continuous_peak_to_peak(setup, d, {8, false, {}}).value);
}

TEST(Tolerance, BoresMoveAndTiltTheAxis) {
  const ContactSetup setup = testing::spur_pair(false).setup();
  constexpr double span = 100.0, radius = 0.02, offset = 15.0;
  const auto bore = [&](bool far_end) {
    return testing::tolerance(far_end ? "bearings.bore_b" : "bearings.bore_a", 1.0, -radius, radius,
                              VaryingBore{span, offset, far_end});
  };
  const std::vector<ScatterTolerance> tolerances{bore(false), bore(true)};
  EXPECT_EQ(coordinates_of(tolerances), 4);
  const auto at = [&](std::vector<double> x) { return deviation_at(setup, tolerances, x).errors; };
  // If both bores are displaced by x, the axis moves. If they are displaced in opposite directions,
  // the axis tilts and also moves at the gear.
  EXPECT_DOUBLE_EQ(at({0.01, 0.0, 0.01, 0.0}).center_distance, -0.01);
  EXPECT_DOUBLE_EQ(at({0.01, 0.0, 0.01, 0.0}).intersecting.rad(), 0.0);
  EXPECT_DOUBLE_EQ(at({-0.01, 0.0, 0.01, 0.0}).intersecting.rad(), 2e-4);
  EXPECT_DOUBLE_EQ(at({-0.01, 0.0, 0.01, 0.0}).center_distance, -15 * 2e-4);
  EXPECT_DOUBLE_EQ(at({0.0, -0.01, 0.0, 0.01}).crossing.rad(), 2e-4);
  // var ΔC is R²/8 for a gear in the middle.
  const SobolPoints points(4);
  double sum = 0.0;
  constexpr std::uint32_t n = 4096;
  for (std::uint32_t i = 0; i < n; ++i) {
    std::vector<double> x;
    for (int t = 0; t < 2; ++t) {
      const std::array u{unit_interval(points.bits(i, 2 * t)),
                         unit_interval(points.bits(i, 2 * t + 1))};
      const auto place = tolerances[static_cast<std::size_t>(t)].at(u);
      x.insert(x.end(), place.begin(), place.begin() + 2);
    }
    const ContactErrors e = at(x);
    const double distance = e.center_distance + offset * e.intersecting.rad();
    sum += distance * distance;
  }
  EXPECT_NEAR(sum / n, radius * radius / 8, 0.01 * radius * radius / 8);
}

TEST(Tolerance, EndsMustBeTeeth) {
  using P = Modification;
  auto drawn = testing::crowned_helical_pair();
  drawn.modifications.tip_relief = {0.005, 2 * 23.5, ReliefShape::linear};
  const ContactSetup setup = drawn.setup();
  const auto relief = [&](double um) {
    return testing::tolerance("gear1.modifications.tip_relief_um", 1e-3, -um, um,
                              VaryingModification{1, P::tip_relief});
  };
  EXPECT_FALSE(check_ends(setup, std::vector{relief(5.0)}));
  const auto error = check_ends(setup, std::vector{relief(6.0)});
  ASSERT_TRUE(error);
  EXPECT_EQ(error->field, "gear1.modifications.tip_relief_um");
  EXPECT_EQ(error->value, "-6");
}

// A flank has one wave in each direction. A varying wave would replace the wave of the drawing.
TEST(Tolerance, AWaveOfTheDrawingIsNotReplaced) {
  auto drawn = testing::crowned_helical_pair();
  drawn.modifications.helix_wave = {2, 0.0, 0.004};
  const ContactSetup setup = drawn.setup();
  const auto wave = [](bool along_face) {
    return std::vector{
        testing::tolerance("gear1.form", 1e-3, 0, 1, VaryingWave{1, along_face, {1, 4}, 0.004})};
  };
  EXPECT_FALSE(check_ends(setup, wave(false)));
  const auto error = check_ends(setup, wave(true));
  ASSERT_TRUE(error);
  EXPECT_EQ(error->field, "gear1.form");
}

}  // namespace
}  // namespace gearwright
