// Tests that every spec ends with a tooth that obeys its laws and agrees with the swept rack, with
// flags, or with an error and its key. A contract is never violated.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>

#include "gearwright/gear/gear.hpp"
#include "tests/oracle/engine_numbers.hpp"
#include "tests/oracle/swept_tooth.hpp"
#include "tests/property/at_hand.hpp"
#include "tests/property/outline_laws.hpp"
#include "tests/property/random_spec.hpp"

namespace gearwright::property {
namespace {

using oracle::SweptRack;

// The members of a gear's spec. An error that names anything else is useless.
bool known_field(const std::string& field) {
  static const std::array<const char*, 16> fields = {"teeth",
                                                     "normal_module",
                                                     "normal_pressure_angle",
                                                     "helix_angle",
                                                     "profile_shift",
                                                     "thickness_allowance",
                                                     "face_width",
                                                     "tip_diameter",
                                                     "rack.addendum",
                                                     "rack.dedendum",
                                                     "rack.root_fillet_radius",
                                                     "rack.tip_fillet_radius",
                                                     "rack.tool_addendum",
                                                     "rack.semi_topping_angle",
                                                     "rack.protuberance",
                                                     "rack.protuberance_angle"};
  return std::find(fields.begin(), fields.end(), field) != fields.end();
}

std::string broken_error(const Error& e) {
  if (!known_field(e.field)) return "error names no member of the spec: '" + e.field + "'";
  if (e.value.empty() || e.message().find(e.field) == std::string::npos) {
    return "the message does not name member and value: " + e.message();
  }
  return {};
}

// Returns the rack of the oracle, or nothing if the oracle does not support it, which is so for a
// cutter with a sharp acute tip. If the oracle rejects another rack, `broken` is the reason.
std::optional<SweptRack> swept_rack_of(const Gear& gear, std::string& broken) {
  try {
    return SweptRack(oracle::numbers_of(gear));
  } catch (const std::invalid_argument& refused) {
    if (std::string(refused.what()) != "dedendum: a sharp cutter needs a tip land") {
      broken = std::string("the oracle refuses this cutter: ") + refused.what();
    }
    return std::nullopt;
  }
}

enum class Ending { error, through_axis, severed, tooth };

struct Outcome {
  Ending ending;
  std::string broken;  // the fault; empty if there is none
};

Outcome outcome_of(const CylindricalSpec& spec, bool walk_centre_line) {
  const auto made = make_gear(spec);
  if (!made) return {Ending::error, broken_error(made.error())};
  const Gear& gear = *made;
  if (gear.internal()) return {Ending::tooth, gear.tooth ? "a ring has a rack-cut tooth" : ""};
  const GeneratedTooth& tooth = *gear.tooth;
  const double scale = std::max(tooth.tip_radius, gear.reference_diameter / 2);
  std::string broken;
  const std::optional<SweptRack> rack = swept_rack_of(gear, broken);
  if (!broken.empty()) return {Ending::tooth, broken};

  if (tooth.through_axis || tooth.severed) {
    const Ending ending = tooth.through_axis ? Ending::through_axis : Ending::severed;
    if (!tooth.outline.arcs.empty()) return {ending, "a tooth that does not exist has arcs"};
    if (gear.exists() || gear.warnings.empty()) return {ending, "nothing is said about it"};
    if (!rack) return {ending, {}};
    if (tooth.through_axis && rack->deepest_radius() > tolerance(scale)) {
      return {ending, "the oracle's cutter does not reach the axis"};
    }
    // The centre line is cut if and only if the half angle of the fillets passes 0 at or below the
    // neck.
    if (tooth.severed && walk_centre_line &&
        !oracle::surface_radius(*rack, 0.0, 0.0, *tooth.neck_radius * (1 + 1e-9))) {
      return {ending, "the oracle finds that the neck is not cut"};
    }
    return {ending, {}};
  }

  broken = broken_law(tooth, 9, scale);
  if (!broken.empty() || !rack) return {Ending::tooth, broken};
  if (tooth.form_radius.has_value() != tooth.tip_form_radius.has_value() ||
      tooth.form_radius.has_value() != (tooth.outline.find(ArcName::flank) != nullptr)) {
    return {Ending::tooth, "form radii without a flank"};
  }
  for (const Vec2& p : oracle::cut_points(tooth, 4)) {
    const double off = rack->clearance({p.x(), p.y()});
    if (!(std::abs(off) <= tolerance(scale))) {
      return {Ending::tooth,
              fmt::format("the oracle finds ({}, {}) off by {} mm", p.x(), p.y(), off)};
    }
  }
  // There is material below the tip: the middle of the neck (or of the root) has not been cut.
  const double middle = tooth.neck_radius ? *tooth.neck_radius : tooth.root_radius;
  if (!(rack->clearance({middle, 0.0}) > -tolerance(scale))) {
    return {Ending::tooth, "the oracle finds the tooth severed"};
  }
  return {Ending::tooth, {}};
}

std::map<Ending, int> check_specs(std::uint64_t seed, int n) {
  const PrintsAtHand handler;
  Random random(seed);
  std::map<Ending, int> count;
  int failures = 0;
  for (int i = 0; i < n && failures < 10; ++i) {
    const CylindricalSpec spec = random_spec(random);
    at_hand = describe(spec);
    const Outcome outcome = outcome_of(spec, i % 16 == 0);
    ++count[outcome.ending];
    if (!outcome.broken.empty()) {
      ++failures;
      ADD_FAILURE() << outcome.broken << "\n  spec " << i << " of seed " << seed << ": " << at_hand;
    }
  }
  return count;
}

// Checks the shares of the four results, so that a change of the generator that removes one of them
// is detected.
void expect_all_endings(const std::map<Ending, int>& count, int n) {
  EXPECT_GT(count.at(Ending::tooth), 0.45 * n);
  EXPECT_GT(count.at(Ending::error), 0.1 * n);
  EXPECT_GT(count.at(Ending::severed), 0.05 * n);
  EXPECT_GT(count.at(Ending::through_axis), 0.05 * n);
}

TEST(Specs, end_in_a_tooth_a_flag_or_an_error) {
  constexpr int n = 30000;
  expect_all_endings(check_specs(20240607, n), n);
}

TEST(LongSpecs, end_in_a_tooth_a_flag_or_an_error) {
  constexpr int n = 100000;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) expect_all_endings(check_specs(seed, n), n);
}

// Values that no drawing contains. Each is set in turn in a valid spec.
TEST(Specs, wild_numbers_are_refused_or_survived) {
  const PrintsAtHand handler;
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const double wild[] = {std::numeric_limits<double>::quiet_NaN(),
                         kInfinity,
                         -kInfinity,
                         0.0,
                         -0.0,
                         -1.0,
                         1e300,
                         -1e300,
                         1e-300,
                         std::numeric_limits<double>::denorm_min(),
                         1e16,
                         1e-16};
  Random random(7);
  for (int i = 0; i < 200; ++i) {
    const CylindricalSpec base = random_spec(random);
    for (const double v : wild) {
      for (int field = 0; field < 14; ++field) {
        CylindricalSpec s = base;
        switch (field) {
          case 0: s.normal_module = v; break;
          case 1: s.normal_pressure_angle = Angle::degrees(v); break;
          case 2: s.helix_angle = Angle::degrees(v); break;
          case 3: s.profile_shift = v; break;
          case 4: s.thickness_allowance = v; break;
          case 5: s.face_width = v; break;
          case 6: s.tip_diameter = v; break;
          case 7: s.straight_rack().addendum = v; break;
          case 8: s.straight_rack().dedendum = v; break;
          case 9: s.straight_rack().root_fillet_radius = v; break;
          case 10: s.straight_rack().tip_fillet_radius = v; break;
          case 11: s.straight_rack().tool_addendum = v; break;
          case 12: s.straight_rack().protuberance = v; break;
          default: s.straight_rack().semi_topping_angle = Angle::degrees(v); break;
        }
        at_hand = describe(s);
        const auto gear = make_gear(s);
        if (!gear) {
          EXPECT_EQ(broken_error(gear.error()), "") << at_hand;
          continue;
        }
        for (const Arc& arc : gear->tooth->outline.arcs) {
          EXPECT_TRUE(arc.begin_point.allFinite() && arc.end_point.allFinite()) << at_hand;
        }
      }
    }
  }
}

// A rack cannot cut an internal gear. The contract is not violated in this case either.
TEST(Specs, rings) {
  const PrintsAtHand handler;
  Random random(11);
  for (int i = 0; i < 20000; ++i) {
    CylindricalSpec spec = random_spec(random);
    spec.teeth = -spec.teeth;
    at_hand = describe(spec);
    const Outcome outcome = outcome_of(spec, false);
    EXPECT_EQ(outcome.broken, "") << at_hand;
  }
}

}  // namespace
}  // namespace gearwright::property
