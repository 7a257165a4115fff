// Compares the engine's pinion-cut gears with the swept pinion: cutters with 1 to 40 teeth, sound
// and undercut, sharp and rounded at both ends, with circular fillets; external gears, and internal
// gears with at least three teeth more than the cutter.
//
//   |clearance| of an outline point      at most 1e-9 mm
//   nudges of 1e-6 mm                    material inwards, none outwards
//   neighbouring points                  at most half a module apart, ends of arcs shared
//
// If a contract is violated, the current gear is printed before the program ends, as a reproducer.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "tests/oracle/engine_pinion.hpp"
#include "tests/oracle/random_pinion_cut.hpp"
#include "tests/property/at_hand.hpp"
#include "tests/property/outline_laws.hpp"

namespace gearwright::oracle {
namespace {

using property::at_hand;
using property::PrintsAtHand;

struct PinionCutTally {
  int gears = 0, external = 0, rings = 0, severed = 0, pointed = 0, undercut = 0;
  int rounded_tip = 0, land_cut = 0, caught_tip = 0, close = 0, few_teeth = 0, fillets = 0;
  std::map<std::string, int> errors;
  double worst = 0.0;
};

void count(const Gear& cutter, const PinionCutSpec& cut, const PinionCutOutcome& outcome,
           PinionCutTally& tally) {
  ++tally.gears;
  if (outcome.ending == Ending::error) ++tally.errors[outcome.key];
  tally.severed += outcome.ending == Ending::severed;
  if (outcome.ending != Ending::tooth) return;
  const bool ring = cut.teeth < 0;
  ++(ring ? tally.rings : tally.external);
  tally.pointed += outcome.pointed;
  tally.undercut += outcome.undercut;
  tally.rounded_tip += outcome.rounded_tip;
  tally.land_cut += outcome.land_cut;
  tally.caught_tip += outcome.caught_tip;
  tally.close += ring && -cut.teeth <= cutter.spec.teeth + 8;
  tally.few_teeth += cutter.spec.teeth <= 8;
  tally.fillets += cutter.spec.root_fillet || cutter.spec.tip_fillet;
  tally.worst = std::max(tally.worst, outcome.worst);
}

PinionCutTally check_gears(std::uint64_t seed, int n) {
  const PrintsAtHand handler;
  Random random(seed);
  PinionCutTally tally;
  int failures = 0;
  while (tally.gears < n && failures < 10) {
    const CylindricalSpec spec = random_cutter(random);
    at_hand = property::describe(spec);
    const auto cutter = make_gear(spec);
    if (!cutter || !cutter->exists() || !smooth_to_the_oracle(*cutter)) continue;
    const auto cut = random_cut(random, *cutter);
    if (!cut) continue;
    at_hand += "; " + describe(*cut);
    const PinionCutOutcome outcome = check_pinion_cut(*cutter, *cut);
    count(*cutter, *cut, outcome, tally);
    if (outcome.broken.empty()) continue;
    ++failures;
    ADD_FAILURE() << outcome.broken << "\n  of seed " << seed << ": " << at_hand;
  }
  return tally;
}

TEST(PinionCutEngine, is_what_the_pinion_leaves) {
  const PinionCutTally tally = check_gears(20240613, 600);
  // The generator covers the intended cases.
  EXPECT_GT(tally.external, 200);
  EXPECT_GT(tally.rings, 150);
  EXPECT_GT(tally.close, 25);
  EXPECT_GT(tally.few_teeth, 150);
  EXPECT_GT(tally.fillets, 150);
  EXPECT_GT(tally.land_cut, 100);
  EXPECT_GT(tally.rounded_tip, 80);
  EXPECT_LE(tally.worst, 1e-11);  // rounding of doubles, a hundredth of the requirement
}

struct Found {
  const char* name;
  CylindricalSpec cutter;
  PinionCutSpec cut;
};

// Gears that used to be wrong, rejected or endless. The loops are those of the edge between flank
// and root of an undercut cutter, if it lies outside the centrode. In the case `caught`, the
// leaving cutter cuts the tip of an internal gear with its own tip.
std::vector<Found> found_before() {
  std::vector<Found> all;
  const auto add = [&](const char* name, int z_0, double m, double alpha_deg, double beta_deg,
                       double x, const StraightRack& rack, const PinionCutSpec& cut) {
    CylindricalSpec spec;
    spec.teeth = z_0;
    spec.normal_module = m;
    spec.normal_pressure_angle = Angle::degrees(alpha_deg);
    spec.helix_angle = Angle::degrees(beta_deg);
    spec.profile_shift = x;
    spec.face_width = 10.0;
    spec.rack = rack;
    all.push_back({name, spec, cut});
    return &all.back().cutter;
  };
  const auto rack = [](double dedendum, double root, double tip = 0.0) {
    StraightRack r;
    r.dedendum = dedendum;
    r.root_fillet_radius = root;
    r.tip_fillet_radius = tip;
    return r;
  };
  const StraightRack iso = *iso53_rack("ISO53-A");
  add("the edge's loop", 4, 2.369723247500228, 20, 0, -0.006800495363552428, iso,
      {51, 65.04831223005293, 10.0, 123.91968372562765})
      ->tip_diameter = 15.723989889208607;
  add("a loop whose return lies below it", 2, 1.804669328519131, 20, 22.385487415461043, 0.0,
      rack(1.0, 0.24299264725311828, 0.0899514589969901),
      {85, 86.02147186507038, 10.0, 173.20128639061582})
      ->tip_diameter = 5.1729260680397635;
  add("a loop that the flank closes", 4, 1.1868225150630836, 14.5, 0, 0.0,
      rack(1.4, 0.546742849965393), {-87, 48.72041193191518, 10.0, {}});
  add("a loop joined on its path", 6, 2.455190252437194, 14.5, 23.654954469831097,
      -0.22135096535213572, *iso53_rack("ISO53-C"),
      {81, 112.986669062639, 10.0, 217.31038562096222})
      ->tip_diameter = 19.290647953713126;
  add("caught, and then cut by the root", 26, 1.6255879908669075, 20, 0, 0.0,
      rack(1.0, 0.601861456974246), {-32, 4.772070767218855, 10.0, {}});
  add("caught by the second of two arcs", 18, 2.6446916855151734, 14.5, 0, -0.460146941472651,
      rack(1.0, 0.0, 0.3140221860335476), {-27, 11.655747336715296, 10.0, {}});
  StraightRack topped = rack(1.0, 0.0);
  topped.tool_addendum = 0.7650893734821528;
  add("caught beyond a joint", 12, 2.5095020538167967, 20, 0, 0.21240640785769416, topped,
      {-19, 8.389433441233813, 10.0, {}});
  add("caught where the tip is rounded", 8, 2.941089958117187, 20, -7.4828234399254185,
      -0.4068311362443429, rack(1.0, 0.601861456974246, 0.19140816711279887),
      {-18, 14.287147278444685, 10.0, {}});
  StraightRack ramped = rack(1.4, 0.0);
  ramped.tool_addendum = 0.763493171274883;
  ramped.semi_topping_angle = Angle::degrees(30.813248076238104);
  add("caught by two corners", 10, 2.824053383231917, 20, 18.73699906553354, -0.2786879158267314,
      ramped, {-13, 4.473753393811706, 10.0, 27.22915319496373});
  StraightRack long_tip = rack(1.5, 0.0, 0.2);
  long_tip.addendum = 1.3511368534051826;
  add("a corner's cut of 14 picometres, for ever in turn with its neighbour's", 33, 2.5, 14.5, 0,
      0.0, long_tip, {-42, 11.954246308468646, 10.0, 101.91417688396321})
      ->tip_diameter = 89.255684267025913;
  CylindricalSpec* both =
      add("a way back that is the leaving one", 2, 2.661287044854216, 14.5, -35.4599761333882,
          0.1449560937408636, StraightRack{}, {-76, 120.74567157574249, 10.0, 241.43989192980422});
  both->tip_diameter = 12.897084868735355;
  both->root_fillet = RootFilletSpec{0.0003759706024036269};
  both->tip_fillet = TipFilletSpec{TipFilletSpec::By::l, 2.1699432973417028};
  return all;
}

TEST(PinionCutEngine, gears_found_wrong_before_are_right) {
  const PrintsAtHand handler;
  for (const Found& found : found_before()) {
    at_hand = found.name;
    const auto cutter = make_gear(found.cutter);
    ASSERT_TRUE(cutter && cutter->exists()) << found.name;
    const PinionCutOutcome outcome = check_pinion_cut(*cutter, found.cut);
    EXPECT_EQ(outcome.broken, "") << found.name;
    EXPECT_EQ(outcome.ending, Ending::tooth) << found.name << ": " << outcome.key;
    const auto cut = make_pinion_cut_gear(*cutter, found.cut);
    if (!cut || !cut->exists()) continue;
    const double scale = std::max(found.cut.distance, cut->tooth->root_radius);
    EXPECT_EQ(property::broken_law(*cut->tooth, 9, scale), "") << found.name;
  }
}

// Tests the comparison itself: another distance, another cutter and the wrong side are detected on
// both kinds.
TEST(PinionCutEngine, another_gear_is_denied) {
  CylindricalSpec spec;
  spec.teeth = 20;
  spec.normal_module = 2.0;
  spec.face_width = 10.0;
  const auto cutter = make_gear(spec);
  spec.profile_shift = 1e-6;
  const auto other = make_gear(spec);
  ASSERT_TRUE(cutter && other);
  for (const int teeth : {35, -60}) {
    const auto tight = generating_distance(*cutter, teeth, 0.2);
    ASSERT_TRUE(tight);
    const PinionCutSpec wanted{teeth, *tight, 10.0, {}};
    PinionCutSpec further = wanted;
    further.distance += 1e-6;
    const auto cut = make_pinion_cut_gear(*cutter, wanted);
    ASSERT_TRUE(cut);
    const auto points = edged_points(*cut->tooth, 5, true, 1.0);
    const Tooth kind = teeth > 0 ? Tooth::external : Tooth::ring;
    const Tooth wrong = teeth > 0 ? Tooth::ring : Tooth::external;
    const SweptPinion sweep = swept_by(*cutter, wanted);
    EXPECT_TRUE(outline_against_sweep(points, sweep, kind).holds(1e-9)) << teeth;
    EXPECT_FALSE(outline_against_sweep(points, sweep, wrong).holds(1e-9)) << teeth;
    EXPECT_GT(outline_against_sweep(points, swept_by(*cutter, further), kind).worst, 1e-7);
    EXPECT_GT(outline_against_sweep(points, swept_by(*other, wanted), kind).worst, 1e-7);
  }
}

TEST(LongPinionCutEngine, is_what_the_pinion_leaves) {
  PinionCutTally tally = check_gears(1, 8000);
  EXPECT_GT(tally.external, 3500);
  EXPECT_GT(tally.rings, 2500);
  EXPECT_GT(tally.close, 400);
  EXPECT_GT(tally.pointed, 50);
  EXPECT_GT(tally.undercut, 50);
  EXPECT_GT(tally.caught_tip, 50);
  EXPECT_GT(tally.land_cut, 1000);
  EXPECT_GT(tally.rounded_tip, 500);
  EXPECT_LT(tally.errors["cut_by"], 200);  // the engine does not reject gears that can be cut
  EXPECT_LE(tally.worst, 1e-11);
}

}  // namespace
}  // namespace gearwright::oracle
