// Tests gears with one to twelve teeth over the whole range of shifts, helix angles and circular
// fillets. A third of them cut another gear, which is tested too. Each case ends with an outline
// that obeys its laws, with a flag, or with an error and its key. A contract is never violated.
//
//   P, ρ, θ    the end point of the flank, in polar coordinates     C   centre of a circular fillet
//   t          direction from the axis to where the flank's normal at P touches the base circle
//
// The normal of an involute is tangent to the base circle. A fillet that is tangent to the flank
// has its centre on this normal: C = D e^{iγ} with D cos(γ − arg t) = r_b, where γ is the centre
// line.
//
// A sample of each kind is verified: rack-cut gears by the swept rack, pinion-cut gears by the
// swept pinion, and circular fillets by their own points.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>

#include "gearwright/base/numbers.hpp"
#include "gearwright/gear/pinion_cut.hpp"
#include "gearwright/gear/testing/plain_spec.hpp"
#include "tests/oracle/engine_numbers.hpp"
#include "tests/oracle/engine_pinion.hpp"
#include "tests/oracle/random_pinion_cut.hpp"
#include "tests/property/at_hand.hpp"
#include "tests/property/outline_laws.hpp"
#include "tests/property/random_spec.hpp"

namespace gearwright::property {
namespace {

constexpr int kEvery = 10;  // every tenth case is verified

CylindricalSpec random_few_teeth(Random& random) {
  CylindricalSpec spec;
  spec.teeth = random.integer(1, 12);
  spec.normal_module = random.uniform(1.0, 3.0);
  spec.normal_pressure_angle = Angle::degrees(random.pick({14.5, 20.0, 20.0, 25.0, 30.0}));
  if (random.chance(0.7)) spec.helix_angle = Angle::degrees(random.uniform(-75.0, 75.0));
  spec.profile_shift = random.uniform(-1.5, 2.5);
  spec.face_width = 10.0;
  spec.rack = random.chance(0.5) ? StraightRack{} : random_rack(random, spec.normal_pressure_angle);
  const double m = spec.normal_module;
  if (random.chance(0.15)) spec.thickness_allowance = m * random.uniform(-0.1, 0.05);
  if (random.chance(0.5)) {
    spec.root_fillet =
        RootFilletSpec{m * (random.chance(0.2) ? 0.0 : random.logarithmic(1e-4, 1.0))};
  }
  const double r = m * spec.teeth / (2 * std::cos(spec.helix_angle.rad()));
  switch (random.integer(0, 7)) {
    case 0:
    case 1: spec.tip_fillet = {TipFilletSpec::By::radius, m * random.logarithmic(1e-4, 1.0)}; break;
    case 2: spec.tip_fillet = {TipFilletSpec::By::l, m * random.uniform(0.5, 3.0)}; break;
    case 3: {
      const double x = spec.profile_shift;
      spec.tip_fillet = {TipFilletSpec::By::end_radius, r + m * (x + random.uniform(0.3, 1.5))};
      break;
    }
    default: break;
  }
  if (random.chance(0.2)) {
    spec.tip_diameter = 2 * (r + m * (spec.profile_shift + random.uniform(-0.5, 1.6)));
  }
  return spec;
}

std::string broken_message(const Error& error) {
  if (error.field.empty() || error.message().empty()) return "an error without field or message";
  if (error.message().find(error.field) == std::string::npos)
    return "the message does not name its field: " + error.message();
  return {};
}

// Points and centre are accurate to a few rounding errors of the size of the tooth. If the normal
// turns by 1 rad, C moves along the centre line by D. The normal is computed from ξ_P = √(ρ² −
// r_b²)/r_b with a rounded ρ. Its error is therefore ε/ξ, or √ε at the base circle itself.
std::string broken_circle(const Gear& gear, const Arc& arc, const Vec2& p, double gamma) {
  constexpr double kEps = std::numeric_limits<double>::epsilon();
  const double r_b = gear.base_radius(), rho = p.norm();
  const double xi = std::sqrt(std::max(0.0, (rho - r_b) * (rho + r_b))) / r_b;
  const double away = gamma - (std::atan2(p.y(), p.x()) - std::atan(xi));
  const double d = r_b / std::cos(away);
  if (!(d > 0.0)) return "the flank's normal does not meet the centre line";
  const Vec2 c(d * std::cos(gamma), d * std::sin(gamma));
  const double radius = (p - c).norm();
  const double normal = 4 * kEps / std::max(xi, std::sqrt(kEps));
  const double off_centre = d * (1 + std::abs(std::tan(away))) * normal;
  const double tolerance = off_centre + 16 * kEps * (rho + d + radius);
  for (const double u : {0.0, 0.2, 0.5, 0.8, 1.0}) {
    const double off = (arc.point(u) - c).norm() - radius;
    if (!(std::abs(off) <= tolerance)) {
      return fmt::format("a {} of radius {} about D = {}: point {} is {} mm off, {} allowed",
                         to_string(arc.name), radius, d, u, off, tolerance);
    }
  }
  return {};
}

// The circular fillets begin at the ends of the flank. They are circles about the point at which
// the normal of the flank meets the centre line.
std::string broken_fillets(const Gear& gear) {
  const Outline& outline = gear.tooth->outline;
  const Arc* flank = outline.find(ArcName::flank);
  if (!flank) return {};
  if (gear.spec.root_fillet) {
    const Arc& first = outline.arcs.front();
    if (first.name != ArcName::root_fillet) return "the root does not begin with its fillet";
    const auto broken = broken_circle(gear, first, flank->begin_point, kPi / gear.spec.teeth);
    if (!broken.empty()) return broken;
  }
  const Arc* tip = outline.find(ArcName::tip_fillet);
  if (!gear.spec.tip_fillet) return {};
  if (!tip) return outline.arcs.back().name == ArcName::tip_land ? "" : "the tip has no fillet";
  return broken_circle(gear, *tip, flank->end_point, 0.0);
}

std::string denied_by_rack(const Gear& gear, double scale) {
  try {
    const oracle::SweptRack rack(oracle::numbers_of(gear));
    for (const Vec2& p : oracle::cut_points(*gear.tooth, 4)) {
      const double off = rack.clearance({p.x(), p.y()});
      if (!(std::abs(off) <= tolerance(scale)))
        return fmt::format("the swept rack finds ({}, {}) off by {} mm", p.x(), p.y(), off);
    }
  } catch (const std::invalid_argument& refused) {
    // The swept rack does not support an acute sharp cutter.
    if (std::string(refused.what()) != "dedendum: a sharp cutter needs a tip land")
      return std::string("the swept rack refuses this cutter: ") + refused.what();
  }
  return {};
}

std::string broken_flags(const Gear& gear) {
  if (!gear.tooth->outline.arcs.empty()) return "a tooth that does not exist has arcs";
  if (gear.exists() || gear.warnings.empty()) return "nothing is said about it";
  return {};
}

struct Tally {
  int made = 0, errors = 0, flags = 0, teeth = 0, circles = 0, confirmed = 0;
  int cut = 0, cut_errors = 0, cut_flags = 0, wheels = 0, rings = 0, cut_confirmed = 0;
};

// The lengths that determine the rounding errors of a tooth's points: pitch radius and tip radius
// and, for a circular root fillet, D r/ρ, because the radius at one of its points is ρ² = D² + r² +
// 2 D r cos(t − γ).
double scale_of(const Gear& gear) {
  const GeneratedTooth& tooth = *gear.tooth;
  double scale = std::max({tooth.tip_radius, tooth.root_radius, gear.reference_diameter / 2});
  if (const auto& f = tooth.root_fillet) scale = std::max(scale, f->distance * f->radius / f->end);
  return scale;
}

std::string broken_gear(const CylindricalSpec& spec, std::optional<Gear>& cutter, Tally& tally) {
  ++tally.made;
  auto made = make_gear(spec);
  if (!made) {
    ++tally.errors;
    return broken_message(made.error());
  }
  const Gear gear = std::move(made).take();
  if (!gear.exists()) {
    ++tally.flags;
    return broken_flags(gear);
  }
  ++tally.teeth;
  const double scale = scale_of(gear);
  std::string broken = broken_law(*gear.tooth, 9, scale);
  if (!broken.empty()) return broken;
  if (spec.root_fillet || spec.tip_fillet) {
    ++tally.circles;
    broken = broken_fillets(gear);
  } else if (tally.teeth % kEvery == 0) {
    ++tally.confirmed;
    broken = denied_by_rack(gear, scale);
  }
  cutter = gear;
  return broken;
}

std::string broken_cut(const Gear& cutter, const PinionCutSpec& wanted, Tally& tally) {
  ++tally.cut;
  const auto made = make_pinion_cut_gear(cutter, wanted);
  if (!made) {
    ++tally.cut_errors;
    return broken_message(made.error());
  }
  if (!made->exists()) {
    ++tally.cut_flags;
    return broken_flags(*made);
  }
  ++(made->internal() ? tally.rings : tally.wheels);
  const double scale = std::max({scale_of(*made), scale_of(cutter), wanted.distance});
  const std::string broken = broken_law(*made->tooth, 9, scale);
  if (!broken.empty() || tally.cut % kEvery != 0 || !oracle::smooth_to_the_oracle(cutter))
    return broken;
  ++tally.cut_confirmed;
  return oracle::check_pinion_cut(cutter, wanted, {.on_surface = tolerance(scale)}).broken;
}

Tally check_few_teeth(std::uint64_t seed, int n) {
  const PrintsAtHand handler;
  Random random(seed);
  Tally tally;
  int failures = 0;
  const auto hold = [&](const std::string& broken) {
    if (broken.empty()) return;
    ++failures;
    ADD_FAILURE() << broken << "\n  of seed " << seed << ": " << at_hand;
  };
  while (tally.made < n && failures < 10) {
    const CylindricalSpec spec = random_few_teeth(random);
    at_hand = describe(spec);
    std::optional<Gear> cutter;
    hold(broken_gear(spec, cutter, tally));
    if (!cutter || tally.made % 3 != 0) continue;
    const auto wanted = oracle::random_cut(random, *cutter);
    if (!wanted) continue;
    at_hand += "; " + oracle::describe(*wanted);
    hold(broken_cut(*cutter, *wanted, tally));
  }
  return tally;
}

// The shares of the results, so that a change of the generator that removes one of them is
// detected.
void expect_all_endings(const Tally& tally) {
  EXPECT_GT(tally.teeth, 0.3 * tally.made);
  EXPECT_GT(tally.errors, 0.1 * tally.made);
  EXPECT_GT(tally.flags, 0.05 * tally.made);
  EXPECT_GT(tally.circles, 0.1 * tally.made);
  EXPECT_GT(tally.confirmed, 0.3 * (tally.teeth - tally.circles) / kEvery);
  EXPECT_GT(tally.wheels, 0.2 * tally.cut);
  EXPECT_GT(tally.rings, 0.2 * tally.cut);
  EXPECT_GT(tally.cut_confirmed, 0.8 * (tally.wheels + tally.rings) / kEvery);
}

TEST(FewTeeth, end_in_a_tooth_a_flag_or_an_error) {
  expect_all_endings(check_few_teeth(20240614, 5000));
}

// The ramp at the bottom of the cutter removes a part of the flank from below C on, or the whole
// flank, so the fillet cannot be tangent to it.
TEST(FewTeeth, root_fillet_beyond_the_ramp_is_refused) {
  CylindricalSpec part = testing::plain_spec({.teeth = 7,
                                              .module = 1.0895445729075677,
                                              .beta_deg = 16.456874707425868,
                                              .x = 1.9625377977206844,
                                              .face_width = 10.0});
  part.thickness_allowance = -0.07669646172892208;
  part.straight_rack().addendum = 0.2738539891673041;
  part.straight_rack().dedendum = 0.812527701416752;
  part.straight_rack().root_fillet_radius = 0.0;
  part.straight_rack().tool_addendum = -0.5954322473420045;
  part.straight_rack().semi_topping_angle = Angle::degrees(44.09902887457322);
  part.root_fillet = RootFilletSpec{0.0};
  CylindricalSpec whole = testing::plain_spec({.teeth = 6,
                                               .module = 2.2429889133680336,
                                               .beta_deg = 32.11665084634389,
                                               .x = 2.117156491969574,
                                               .face_width = 10.0});
  whole.normal_pressure_angle = Angle::degrees(14.5);
  whole.straight_rack().addendum = 0.03634705912197838;
  whole.straight_rack().root_fillet_radius = 0.0;
  whole.straight_rack().tool_addendum = -1.1624976067763098;
  whole.straight_rack().semi_topping_angle = Angle::degrees(65.87293356757992);
  whole.root_fillet = RootFilletSpec{0.012465500408081002};
  for (const CylindricalSpec& spec : {part, whole}) {
    const auto gear = make_gear(spec);
    ASSERT_FALSE(gear) << describe(spec);
    EXPECT_EQ(gear.error().field.rfind("root_fillet", 0), 0u) << gear.error().field;
    EXPECT_EQ(broken_message(gear.error()), "");
  }
}

TEST(LongFewTeeth, end_in_a_tooth_a_flag_or_an_error) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    expect_all_endings(check_few_teeth(seed, 20000));
  }
}

}  // namespace
}  // namespace gearwright::property
