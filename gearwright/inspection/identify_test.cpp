// Tests the identification of gears: the example of the documents, and synthetic gears whose
// readings scatter as in a workshop.
#include <gtest/gtest.h>

#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>

#include "gearwright/base/testing/draw.hpp"
#include "gearwright/base/testing/taken.hpp"
#include "gearwright/base/units.hpp"
#include "gearwright/gear/testing/plain_spec.hpp"
#include "gearwright/inspection/balls.hpp"
#include "gearwright/inspection/identify.hpp"
#include "gearwright/inspection/span.hpp"

namespace gearwright {
namespace {

IdentifyProblem broken_gear() {
  IdentifyProblem p;
  p.teeth = 23;
  p.spans = {{3, 19.751}, {4, 27.131}};
  p.balls = {{5, 69.426}};
  p.tip.value = 66.71;
  p.lead.value = 585;
  return p;
}

TEST(Identify, tells_the_broken_gear) {
  const auto found = testing::taken(identify(broken_gear()));
  ASSERT_FALSE(found.candidates.empty());
  const IdentifiedGear& gear = found.candidates.front();
  EXPECT_EQ(gear.normal_module, 2.5);
  EXPECT_EQ(gear.series, ModuleSeries::iso54_1);
  EXPECT_DOUBLE_EQ(gear.normal_pressure_angle.deg(), 20.0);
  EXPECT_NEAR(gear.helix_angle.deg(), 18.0, 1e-9);
  EXPECT_NEAR(gear.generating_shift, 0.2170, gear.shift_uncertainty);
  EXPECT_NEAR(gear.generating_shift, 0.2170, 0.0005);
  EXPECT_GT(gear.shift_uncertainty, 0.0);
  EXPECT_DOUBLE_EQ(gear.tip_diameter, 66.71);
  EXPECT_GT(gear.likelihood, 0.5);
  EXPECT_FALSE(found.contradiction);
  auto left = broken_gear();
  left.lead.value = -585;
  EXPECT_LT(testing::taken(identify(left)).candidates.front().helix_angle.deg(), 0.0);
}

TEST(Identify, names_the_reading_that_disagrees) {
  auto p = broken_gear();
  p.spans.push_back({5, 34.511});
  p.spans[1].value += 0.3;
  const auto found = testing::taken(identify(p));
  ASSERT_TRUE(found.contradiction);
  EXPECT_EQ(found.contradiction->reading, Reading::span);
  EXPECT_EQ(found.contradiction->tool, 4);
  EXPECT_NEAR(found.contradiction->expected.value(), 27.131, 0.01);
  EXPECT_EQ(found.candidates.front().normal_module, 2.5);
}

// A centre distance and a tip diameter do not determine a helix angle. They do not even narrow the
// range of a free helix angle, so the evidence for a free angle must not exceed the evidence for a
// spur gear.
TEST(Identify, undetermined_helix_angle_does_not_win) {
  for (const int z : {17, 21, 34}) {
    IdentifyProblem p;
    p.teeth = z;
    p.tip.value = 2.0 * (z + 2);
    p.mating_teeth = 43;
    p.distance.value = z + 43.0;
    const auto found = testing::taken(identify(p));
    const IdentifiedGear& first = found.candidates.front();
    EXPECT_EQ(first.normal_module, 2.0) << z;
    EXPECT_EQ(first.helix_angle.rad(), 0.0) << z;
    for (const IdentifiedGear& gear : found.candidates)
      EXPECT_LE(gear.helix_uncertainty.deg(), 45.0) << z;
  }
}

TEST(Identify, says_what_would_decide) {
  auto p = broken_gear();
  p.lead.value.reset();
  p.balls.clear();
  const auto found = testing::taken(identify(p));
  ASSERT_GE(found.candidates.size(), 2u);
  ASSERT_TRUE(found.next);
  EXPECT_GE(found.next->rival, 1);
}

TEST(Identify, refuses_what_says_nothing) {
  IdentifyProblem p;
  p.teeth = 23;
  EXPECT_FALSE(identify(p));
  p.lead.value = 585;
  EXPECT_FALSE(identify(p));
  p = broken_gear();
  p.teeth = 0;
  EXPECT_EQ(identify(p).error().field, "teeth");
}

TEST(Identify, refuses_readings_that_no_gear_has) {
  const auto field = [](const IdentifyProblem& p) {
    const auto found = identify(p);
    return found ? std::string() : found.error().field;
  };
  for (const bool measured : {false, true}) {
    const auto with = [&](double lead, double beta) {
      IdentifyProblem p = broken_gear();
      p.lead.value = lead;
      (measured ? p.helix.value : p.helix_angle) = Angle::degrees(beta);
      return field(p);
    };
    EXPECT_EQ(with(585, 18), "");
    EXPECT_EQ(with(-585, -18), "");
    EXPECT_EQ(with(-585, 18), "measured.lead");
    EXPECT_EQ(with(585, -18), "measured.lead");
    EXPECT_EQ(with(585, 0), "measured.lead");
  }
  IdentifyProblem p = broken_gear();
  for (const double root : {70.0, 66.71}) {
    p.root.value = root;
    EXPECT_EQ(field(p), "measured.root_diameter") << root;
  }
  p.root.value = 55.5;
  EXPECT_EQ(field(p), "");
}

struct Workshop : testing::Draw {
  using Draw::Draw;
  double normal() {  // by Box and Muller, to get the same numbers on every machine
    return std::sqrt(-2 * std::log(uniform(1e-300, 1))) *
           std::cos(2 * 3.141592653589793 * uniform(0, 1));
  }
  template <std::size_t n>
  double of(const std::array<double, n>& list) {
    return list[static_cast<std::size_t>(whole(0, static_cast<int>(n) - 1))];
  }
};

CylindricalSpec random_standard(Workshop& random) {
  constexpr std::array kMain{0.5, 0.8, 1.0, 1.25, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 8.0, 10.0};
  constexpr std::array kSecond{0.7, 1.125, 1.75, 2.25, 2.75, 3.5, 4.5, 7.0};
  constexpr std::array kPitches{3.0, 4.0, 5.0, 6.0, 8.0, 10.0, 12.0, 16.0, 20.0, 24.0};
  CylindricalSpec s;
  const double kind = random.uniform(0, 1);
  s.normal_module = kind < 0.7    ? random.of(kMain)
                    : kind < 0.85 ? random.of(kSecond)
                                  : kMmPerInch / random.of(kPitches);
  const double angle = random.uniform(0, 1);
  s.normal_pressure_angle = Angle::degrees(angle < 0.92 ? 20 : angle < 0.96 ? 14.5 : 25);
  s.helix_angle = Angle::degrees(random.uniform(0, 1) < 0.5 ? 0 : random.whole(5, 35));
  s.teeth = random.whole(14, 120);
  s.profile_shift = random.uniform(-0.1, 0.6);
  s.thickness_allowance = -random.uniform(0, 0.03) * s.normal_module;
  s.face_width = 40 * s.normal_module;
  s.straight_rack().root_fillet_radius = 0.2;  // fits at any of these pressure angles
  return s;
}

struct Counted {
  int gears = 0, decidable = 0, first = 0, covered = 0, known = 0;
  double slowest_ms = 0.0, total_ms = 0.0;
};

// Returns true if a candidate cannot be distinguished from the gear, i.e. if every exact reading of
// the candidate agrees with the gear within the uncertainty of this reading.
bool has_the_readings(const IdentifiedGear& c, const IdentifyProblem& exact, double lead) {
  CylindricalSpec s = testing::plain_spec({.teeth = c.teeth,
                                           .module = c.normal_module,
                                           .x = c.generating_shift,
                                           .face_width = 40 * c.normal_module});
  s.normal_pressure_angle = c.normal_pressure_angle;
  s.helix_angle = c.helix_angle;
  s.straight_rack().root_fillet_radius = 0.2;
  const auto gear = make_gear(s);
  if (!gear) return false;
  for (const SpanReading& w : exact.spans)
    if (std::abs(span_length(*gear, w.teeth) - w.value) > exact.span_uncertainty) return false;
  for (const DiameterReading& b : exact.balls) {
    const auto seat = ball_in_space(*gear, b.tool);
    if (!seat || std::abs(over_two_balls(*gear, *seat) - b.value) > exact.balls_uncertainty)
      return false;
  }
  return lead == 0.0 ? std::abs(c.helix_angle.deg()) < 0.5
                     : std::abs(gear->lead - lead) < 0.02 * std::abs(lead);
}

Counted identified(int wanted, unsigned seed) {
  constexpr double kU = 0.02, kSigmas = 1.96;
  Workshop random(seed);
  Counted n;
  while (n.gears < wanted) {
    const CylindricalSpec truth = random_standard(random);
    const auto made = make_gear(truth);
    if (!made) continue;
    const Gear& gear = *made;
    const auto spans = usable_spans(gear, 2);
    const auto sizes = ball_sizes(gear);
    if (spans.size() < 2 || !sizes) continue;
    const auto seat = ball_in_space(gear, sizes->metric);
    if (!seat || !seat->usable()) continue;
    IdentifyProblem exact;
    exact.teeth = truth.teeth;
    for (const Span& s : spans) exact.spans.push_back({s.teeth, s.length});
    exact.balls.push_back({sizes->metric, over_two_balls(gear, *seat)});
    IdentifyProblem read = exact;
    const auto noise = [&] { return kU / kSigmas * random.normal(); };
    for (SpanReading& s : read.spans) s.value += noise();
    for (DiameterReading& b : read.balls) b.value += noise();
    const double wear = random.uniform(0, 0.05) * truth.normal_module;
    read.tip.value = gear.tip_diameter - 2 * wear + noise();
    if (gear.lead != 0.0) {
      read.lead.value = gear.lead * (1 + 0.02 / kSigmas * random.normal());
    } else {
      read.helix.value = Angle::degrees(0.5 / kSigmas * random.normal());
    }
    const auto start = std::chrono::steady_clock::now();
    const auto found = testing::taken(identify(read));
    const double ms =
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    n.slowest_ms = std::max(n.slowest_ms, ms);
    n.total_ms += ms;
    ++n.gears;
    if (found.candidates.empty()) {
      ++n.decidable;
      continue;
    }
    const IdentifiedGear& first = found.candidates.front();
    const bool right =
        std::abs(first.normal_module - truth.normal_module) < 1e-9 &&
        std::abs(first.normal_pressure_angle.deg() - truth.normal_pressure_angle.deg()) < 1e-9 &&
        std::abs(std::abs(first.helix_angle.deg()) - truth.helix_angle.deg()) <
            std::max(1e-9, first.helix_uncertainty.deg());
    if (right || !has_the_readings(first, exact, gear.lead)) {
      ++n.decidable;
      n.first += right;
    }
    if (!right || first.helix_uncertainty.rad() > 0.0) continue;
    ++n.known;
    n.covered += std::abs(first.generating_shift - gear.reference().generating_profile_shift) <=
                 first.shift_uncertainty;
  }
  std::printf(
      "identify: the first candidate is right for %d of %d distinguishable gears (%.2f %%); %d "
      "gears "
      "are not distinguishable; the ± ranges contain %.2f %% of %d values; %.2f ms on average, "
      "%.1f ms at most\n",
      n.first, n.decidable, 100.0 * n.first / n.decidable, n.gears - n.decidable,
      100.0 * n.covered / n.known, n.known, n.total_ms / n.gears, n.slowest_ms);
  return n;
}

TEST(Identify, synthetic_gears) {
  const Counted n = identified(300, 1);
  EXPECT_GE(n.first, 0.985 * n.decidable);
  EXPECT_NEAR(n.covered, 0.95 * n.known, 0.035 * n.known);  // 2.8 standard deviations for 300 gears
}

// This test runs only in `make test-long`. It prints the rate of right answers.
TEST(LongIdentify, ten_thousand_synthetic_gears) {
  const Counted n = identified(10000, 2);
  EXPECT_GE(n.first, 0.99 * n.decidable);
  EXPECT_NEAR(n.covered, 0.95 * n.known, 0.01 * n.known);
  EXPECT_LT(n.total_ms / n.gears, 50.0);
}

// The gear has the module 3.5, 20°, β = 16° and x_E = 0.15. The spans are over 4 and 5 teeth, but
// they are given as spans over 3 and 4 teeth.
TEST(Identify, finds_miscounted_teeth_in_the_spans) {
  IdentifyProblem p;
  p.teeth = 29;
  p.spans = {{3, 38.13}, {4, 48.46}};
  p.balls = {{6, 114.62}};
  p.tip.value = 113.80;
  const auto found = testing::taken(identify(p));
  ASSERT_TRUE(found.alternative);
  EXPECT_EQ(found.alternative->mistake, Reading::span_teeth);
  EXPECT_EQ(found.alternative->step, 1);
  EXPECT_EQ(found.alternative->gear.teeth, 29);
  EXPECT_EQ(found.alternative->gear.normal_module, 3.5);
  EXPECT_NEAR(found.alternative->gear.helix_angle.deg(), 16.0, 0.5);
  EXPECT_NEAR(found.alternative->gear.generating_shift, 0.15, 0.02);
}

// Plane anvils do not fit into the spaces of an internal helical gear.
TEST(Identify, internal_gears_with_spans_are_spur_gears) {
  IdentifyProblem p;
  p.teeth = -64;
  p.spans = {{7, 49.91}, {8, 57.29}};
  p.balls = {{4.5, 151.95}};
  p.tip.value = 154.03;
  const auto found = testing::taken(identify(p));
  ASSERT_FALSE(found.candidates.empty());
  for (const IdentifiedGear& gear : found.candidates) EXPECT_EQ(gear.helix_angle.rad(), 0.0);
  EXPECT_EQ(found.candidates.front().normal_module, 2.5);
}

// Spans of a gear of the module 2, with a measured helix angle between two whole degrees. A fitted
// helix angle replaced both whole degrees at 17.45°, so their likelihood jumped from 100 % to 0.
TEST(Identify, a_free_helix_angle_does_not_replace_whole_degrees) {
  const auto likelihoods = [](double measured) {
    IdentifyProblem p;
    p.teeth = 23;
    p.spans = {{2, 9.55}, {3, 15.43}};
    p.tip.value = 52.1;
    p.helix.value = Angle::degrees(measured);
    std::array<double, 3> sum{};  // 17°, 18°, any other angle
    for (const IdentifiedGear& g : testing::taken(identify(p)).candidates) {
      const double beta = g.helix_angle.deg();
      const bool whole = g.helix_uncertainty.rad() == 0.0;
      sum[whole && std::abs(beta - 17) < 1e-6   ? 0
          : whole && std::abs(beta - 18) < 1e-6 ? 1
                                                : 2] += g.likelihood;
    }
    return sum;
  };
  auto last = likelihoods(17.40);
  for (const double measured : {17.42, 17.44, 17.46, 17.48, 17.50, 17.52, 17.54, 17.56, 17.58}) {
    const auto next = likelihoods(measured);
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(next[i], last[i], 0.06) << measured;
    EXPECT_LT(next[0], last[0]) << measured;
    EXPECT_GT(next[1], last[1]) << measured;
    last = next;
  }
  // At the middle, both whole degrees are 0.5/0.255 standard deviations off. The prior has 0.45/63
  // for each of them, and 0.1 √(2π) 0.255/45 for any angle near them.
  const auto middle = likelihoods(17.5);
  const double off = 0.5 / (0.5 / 1.96);
  const double whole = 0.45 / 63 * std::exp(-off * off / 2);
  const double any = 0.1 / 45 * std::sqrt(2 * 3.141592653589793) * (0.5 / 1.96);
  EXPECT_NEAR(middle[2], any / (any + 2 * whole), 0.03);
}

// Readings of a spur gear leave only a range of about 2° for a free helix angle, because they depend
// on its square. Its evidence is far less than its prior probability.
TEST(Identify, a_free_helix_angle_of_a_spur_gear_is_unlikely) {
  IdentifyProblem p;
  p.teeth = 23;
  p.spans = {{3, 19.4272}, {4, 26.8075}};
  p.balls = {{4.5, 64.3665}};
  p.tip.value = 63;
  const auto found = testing::taken(identify(p));
  EXPECT_EQ(found.candidates.front().helix_angle.rad(), 0.0);
  EXPECT_GT(found.candidates.front().likelihood, 0.9);
  for (const IdentifiedGear& g : found.candidates) EXPECT_LT(g.helix_uncertainty.deg(), 5.0);
}

// The tip is too short by 0.149 m_n at β = 20° and by 0.022 m_n at 18°. As stub teeth are rare, it
// does not agree with a stub tooth at 20°. Multiples of five degrees are three times as likely.
TEST(Identify, stub_teeth_need_a_better_agreement) {
  IdentifyProblem p;
  p.teeth = 23;
  p.spans = {{2, 9.55}, {3, 15.43}};
  p.tip.value = 52.1;
  double of_18 = 0.0, of_20 = 0.0;
  for (const IdentifiedGear& g : testing::taken(identify(p)).candidates) {
    if (g.helix_uncertainty.rad() > 0.0) continue;
    if (std::abs(g.helix_angle.deg() - 18) < 1e-6) of_18 = g.likelihood;
    if (std::abs(g.helix_angle.deg() - 20) < 1e-6) of_20 = g.likelihood;
  }
  ASSERT_GT(of_18, 0.0);
  constexpr double kScatter = 0.15;
  const double short_18 = 0.022 / kScatter, short_20 = 0.149 / kScatter;
  EXPECT_NEAR(of_20 / of_18, 3 * std::exp((short_18 * short_18 - short_20 * short_20) / 2), 0.15);
}

TEST(Identify, the_next_measurement_separates_most_of_the_probability) {
  IdentifyProblem p;
  p.teeth = 23;
  p.spans = {{2, 9.55}, {3, 15.43}};
  p.tip.value = 52.1;
  p.distance.value = 88.5;
  p.mating_teeth = 61;
  const auto found = testing::taken(identify(p));
  ASSERT_TRUE(found.next);
  // Dimensions over balls of two adjacent whole degrees differ by 0.25 mm and are predicted to
  // ±0.04 mm; helix angles differ by 1° and are measured to ±0.5°.
  EXPECT_EQ(found.next->reading, Reading::over_balls);
  EXPECT_EQ(found.next->separates.size(), found.candidates.size() - 1);
  for (const double spread : found.next->spread) EXPECT_GT(spread, p.balls_uncertainty);
}

}  // namespace
}  // namespace gearwright
