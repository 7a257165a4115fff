// Compares the engine's outlines with the swept rack for every kind of cutter. The shifts cover the
// whole range, from a cutter through the axis to a pointed tooth.
//
//   worst |clearance| of an outline point       at most 1e-9 mm
//   nudges of 1e-6 mm                           material inwards, none outwards
//   form radius, flags                          the values that the sweep finds by walking
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "gearwright/gear/gear.hpp"
#include "gearwright/gear/testing/made.hpp"
#include "gearwright/gear/testing/plain_spec.hpp"
#include "tests/oracle/engine_numbers.hpp"
#include "tests/oracle/outline_against_sweep.hpp"
#include "tests/oracle/swept_tooth.hpp"

namespace gearwright::oracle {
namespace {

using namespace literals;
using testing::made;

constexpr double kOnSurface = 1e-9;  // mm

struct Cutter {
  std::string name;
  StraightRack rack;
  Angle alpha = 20_deg;
  double allowance = 0.0;  // modules
};

std::vector<Cutter> cutters() {
  std::vector<Cutter> all;
  for (const char* name : {"ISO53-A", "ISO53-B", "ISO53-C", "ISO53-D"}) {
    all.push_back({name, *iso53_rack(name)});
  }
  const StraightRack plain;
  const auto add = [&](const char* name, auto change, Angle alpha = 20_deg,
                       double allowance = 0.0) {
    StraightRack rack = plain;
    change(rack);
    all.push_back({name, rack, alpha, allowance});
  };
  add("full radius", [](StraightRack& r) { r.root_fillet_radius = full_radius(r, 20_deg); });
  add("sharp corner", [](StraightRack& r) { r.root_fillet_radius = 0.0; });
  add("tip rounding", [](StraightRack& r) { r.tip_fillet_radius = 0.25; });
  add("semi-topping", [](StraightRack& r) {
    r.tool_addendum = 0.8;
    r.semi_topping_angle = 45_deg;
  });
  add("topping", [](StraightRack& r) { r.tool_addendum = 0.95; });
  add("protuberance", [](StraightRack& r) {
    r.dedendum = 1.4;
    r.root_fillet_radius = 0.35;
    r.protuberance = 0.03;
  });
  add("small protuberance", [](StraightRack& r) {
    r.dedendum = 1.4;
    r.root_fillet_radius = 0.35;
    r.protuberance = 0.002;
  });
  add(
      "14.5 degrees", [](StraightRack& r) { r.root_fillet_radius = 0.3; }, 14.5_deg);
  add(
      "25 degrees", [](StraightRack& r) { r.root_fillet_radius = 0.25; }, 25_deg);
  add(
      "30 degrees", [](StraightRack& r) { r.root_fillet_radius = 0.1; }, 30_deg);
  all.push_back({"30 degrees, named", *iso53_rack("ISO53-A"), 30_deg});
  all.push_back({"thinned", *iso53_rack("ISO53-A"), 20_deg, -0.08});
  all.push_back({"thickened", *iso53_rack("ISO53-C"), 20_deg, 0.05});
  return all;
}

CylindricalSpec spec_of(const Cutter& cutter, int teeth, double beta_deg, double x) {
  CylindricalSpec spec = testing::plain_spec(
      {.teeth = teeth, .module = 2.0, .beta_deg = beta_deg, .x = x, .face_width = 20.0});
  spec.normal_pressure_angle = cutter.alpha;
  spec.thickness_allowance = cutter.allowance * 2.0;
  spec.rack = cutter.rack;
  return spec;
}

// The shifts begin slightly below the one at which the cutter reaches the axis or severs the tooth,
// and end slightly above the one at which the tooth becomes pointed. Three modules below the
// undercut limit, no tooth remains.
std::vector<double> shifts(const Cutter& cutter, int teeth, double beta_deg, int n) {
  const Gear middle = made(spec_of(cutter, teeth, beta_deg, 0.0));
  const double r = middle.reference_diameter / 4;  // in modules
  const double axis = cutter.rack.dedendum - r - (middle.reference().generating_profile_shift);
  const double lo =
      std::max(axis - 0.05, std::min(*middle.involute()->undercut_free_profile_shift - 1.5, -0.5));
  double below = lo, above = lo + 8.0;
  const auto pointed = [&](double x) {
    const auto gear = make_gear(spec_of(cutter, teeth, beta_deg, x));
    return gear && gear->exists() && gear->tooth->pointed;
  };
  if (pointed(above)) {
    for (int i = 0; i < 12; ++i) {
      const double x = 0.5 * (below + above);
      (pointed(x) ? above : below) = x;
    }
  } else {
    above = lo + 4.0;  // topped or with many teeth, and therefore never pointed
  }
  std::vector<double> all;
  for (int i = 0; i < n; ++i) all.push_back(lo + (above + 0.1 - lo) * i / (n - 1));
  return all;
}

std::string name_of(const Cutter& cutter, const CylindricalSpec& spec) {
  return cutter.name + ", z = " + std::to_string(spec.teeth) +
         ", beta = " + std::to_string(spec.helix_angle.deg()) +
         ", x = " + std::to_string(spec.profile_shift);
}

struct OutlineTally {
  int gears = 0, teeth = 0, severed = 0, through_axis = 0, pointed = 0, undercut = 0;
  double worst = 0.0;
};

// Points of one tooth on the surface must have material on the inside only.
void check_outline(const Cutter& cutter, const CylindricalSpec& spec, int points,
                   OutlineTally& tally) {
  const auto gear = make_gear(spec);
  ASSERT_TRUE(gear) << name_of(cutter, spec) << ": " << gear.error().message();
  const GeneratedTooth& tooth = *gear->tooth;
  ++tally.gears;
  tally.through_axis += tooth.through_axis;
  tally.severed += tooth.severed;
  if (!gear->exists()) return;
  ++tally.teeth;
  tally.pointed += tooth.pointed;
  tally.undercut += gear->undercut;
  const SweptRack rack(numbers_of(*gear));
  // If the bottom of the cutter is as high as the blank, it cuts the tip of the tooth as well.
  const bool land =
      tooth.tip_cut_by_rack || std::abs(rack.clearance({tooth.tip_radius, 0.0})) <= kOnSurface;
  const OutlineAgainstSweep result = outline_against_sweep(edged_points(tooth, points, land), rack);
  EXPECT_LE(result.worst, kOnSurface) << name_of(cutter, spec) << ", point " << result.worst_index;
  EXPECT_GT(result.min_inward, 0.0)
      << name_of(cutter, spec) << ", point " << result.min_inward_index;
  EXPECT_LT(result.max_outward, 0.0)
      << name_of(cutter, spec) << ", point " << result.max_outward_index;
  tally.worst = std::max(tally.worst, result.worst);
}

OutlineTally check_grid(const std::vector<int>& teeth, const std::vector<double>& betas,
                        int n_shifts, int points) {
  OutlineTally tally;
  for (const Cutter& cutter : cutters()) {
    for (const int z : teeth) {
      for (const double beta : betas) {
        for (const double x : shifts(cutter, z, beta, n_shifts)) {
          check_outline(cutter, spec_of(cutter, z, beta, x), points, tally);
          if (::testing::Test::HasFatalFailure()) return tally;
        }
      }
    }
  }
  return tally;
}

TEST(EngineOutline, is_what_the_rack_leaves) {
  const OutlineTally tally =
      check_grid({3, 4, 5, 6, 7, 8, 9, 10, 12, 14, 17, 21, 25, 32, 40, 60, 80, 130, 200},
                 {0, 8, -15, 22, -30, 45}, 13, 8);
  // Checks that the grid contains all intended cases.
  EXPECT_GT(tally.teeth, 15000);
  EXPECT_GT(tally.pointed, 500);
  EXPECT_GT(tally.severed, 300);
  EXPECT_GT(tally.through_axis, 100);
  EXPECT_GT(tally.undercut, 1000);
  EXPECT_LE(tally.worst, 1e-11);  // rounding error of doubles at 250 mm, a hundredth of the
                                  // tolerance
}

TEST(LongEngineOutline, is_what_the_rack_leaves) {
  std::vector<int> teeth;
  for (int z = 1; z <= 24; ++z) teeth.push_back(z);
  for (const int z : {27, 31, 36, 43, 53, 70, 97, 131, 167, 200}) teeth.push_back(z);
  const OutlineTally tally = check_grid(teeth, {0, 8, -15, 22, -30, 38, -45, 60}, 17, 12);
  EXPECT_GT(tally.teeth, 40000);
  EXPECT_LE(tally.worst, 1e-11);
}

// With the opposite hand, the transverse outline is exactly the same.
TEST(EngineOutline, does_not_know_the_hand) {
  for (const Cutter& cutter : cutters()) {
    for (const double beta : {15.0, 45.0}) {
      const Gear right = made(spec_of(cutter, 14, beta, 0.3)),
                 left = made(spec_of(cutter, 14, -beta, 0.3));
      const auto a = cut_points(*right.tooth, 9), b = cut_points(*left.tooth, 9);
      EXPECT_EQ(a, b) << cutter.name;
    }
  }
}

// Flags: the oracle moves up the centre line. It finds the line either cut, or uncut up to the
// point.
TEST(EngineFlags, are_what_the_sweep_finds) {
  int severed_teeth = 0, pointed_teeth = 0, whole = 0;
  for (const Cutter& cutter : cutters()) {
    for (const int z : {3, 5, 8, 13, 30}) {
      for (const double beta : {0.0, -30.0}) {
        for (const double x : shifts(cutter, z, beta, 8)) {
          const CylindricalSpec spec = spec_of(cutter, z, beta, x);
          const Gear gear = made(spec);
          const GeneratedTooth& tooth = *gear.tooth;
          const SweptRack rack(numbers_of(gear));
          EXPECT_EQ(tooth.through_axis, rack.deepest_radius() <= 0.0) << name_of(cutter, spec);
          if (tooth.through_axis) continue;
          const auto cut = surface_radius(
              rack, 0.0, 0.0, tooth.severed ? tooth.tip_radius : tooth.tip_radius * (1 - 1e-9));
          if (tooth.severed) {
            ++severed_teeth;
            ASSERT_TRUE(cut) << name_of(cutter, spec);
            EXPECT_LE(*cut, *tooth.neck_radius * (1 + 1e-9)) << name_of(cutter, spec);
            continue;
          }
          EXPECT_FALSE(cut) << name_of(cutter, spec) << " cut at " << *cut;
          const auto point = pointed_radius(rack);
          if (!tooth.pointed) {
            ++whole;
            EXPECT_FALSE(point && *point < tooth.tip_radius * (1 - 1e-9)) << name_of(cutter, spec);
            continue;
          }
          ++pointed_teeth;
          ASSERT_TRUE(point) << name_of(cutter, spec);
          // The tolerance is the 1e-12 mm of the oracle, divided by the sine of half the angle of
          // the point, but at least 0.2.
          EXPECT_NEAR(*point, tooth.tip_radius, 1e-10) << name_of(cutter, spec);
        }
      }
    }
  }
  EXPECT_GT(severed_teeth, 50);
  EXPECT_GT(pointed_teeth, 50);
  EXPECT_GT(whole, 400);
}

// The start of the usable flank. From this radius to the end of the flank, the surface is the
// involute of the main flank. At a radius smaller by 1e-5 mm it is not. The search of the oracle
// does not know this start and must find it. Near the base circle, it extrapolates over a distance
// in which its accuracy is only 5e-5 mm.
TEST(EngineFormRadius, is_where_the_sweep_leaves_the_involute) {
  int compared = 0, left = 0;
  double worst_search = 0.0;
  for (const Cutter& cutter : cutters()) {
    for (const int z : {5, 9, 14, 22, 45}) {
      for (const double beta : {0.0, 25.0}) {
        for (const double x : {-0.5, 0.0, 0.45}) {
          const CylindricalSpec spec = spec_of(cutter, z, beta, x);
          const Gear gear = made(spec);
          if (!gear.exists() || !gear.tooth->form_radius) continue;
          ++compared;
          const SweptRack rack(numbers_of(gear));
          const double form = *gear.tooth->form_radius, end = *gear.tooth->tip_form_radius;
          const auto gap = [&](double rho) {
            const double theta = involute_half_angle(rack, rho);
            return rack.clearance({rho * std::cos(theta), rho * std::sin(theta)});
          };
          for (int i = 0; i <= 16; ++i) {
            EXPECT_LE(std::abs(gap(form + (end - form) * i / 16)), 1e-12) << name_of(cutter, spec);
          }
          if (form - 1e-5 > gear.base_radius()) {
            ++left;
            EXPECT_GT(std::abs(gap(form - 1e-5)), 1e-11) << name_of(cutter, spec);
          }
          // The oracle evaluates 400 radii. It may therefore miss a flank that is shorter than a
          // few of its steps.
          if (end - form < 0.02 * (gear.tooth->tip_radius - gear.base_radius())) continue;
          const auto found = form_radius(rack);
          ASSERT_TRUE(found) << name_of(cutter, spec);
          worst_search = std::max(worst_search, std::abs(*found - form));
        }
      }
    }
  }
  EXPECT_GT(compared, 350);
  EXPECT_GT(left, 350);
  EXPECT_LE(worst_search, 5e-5);
}

}  // namespace
}  // namespace gearwright::oracle
