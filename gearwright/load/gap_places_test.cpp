// The positions of least gap are compared with a scan of the whole profile and with closed forms.
#include "gearwright/load/gap_places.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "gearwright/contact/testing/sample_pairs.hpp"

namespace gearwright {
namespace {

using testing::involutes;
using testing::SamplePair;

struct Case {
  std::string name;
  SamplePair pair;
};

FlankModifications relieved(const Gear& gear) {
  const double root = *gear.root_form_radius(), tip = gear.tip_form_radius();
  FlankModifications m;
  m.tip_relief = {0.02, 2 * (root + 0.6 * (tip - root)), ReliefShape::linear};
  m.lead_crowning = 0.01;
  return m;
}

std::vector<Case> cases() {
  std::vector<Case> all;
  struct Teeth {
    int z1, z2;
    double beta;
  };
  for (const auto& [z1, z2, beta] : {Teeth{19, 43, 0}, Teeth{19, 43, 18}, Teeth{43, 19, -25},
                                     Teeth{19, -61, 0}, Teeth{19, -61, 15}})
    for (const bool gear2_drives : {false, true}) {
      const std::string name = std::to_string(z1) + ":" + std::to_string(z2) + " " +
                               std::to_string(beta) + (gear2_drives ? " 2" : " 1");
      Case exact{name, involutes(z1, z2, beta)};
      exact.pair.place.gear2_drives = gear2_drives;
      all.push_back(exact);
      Case modified = exact;
      modified.name += " modified";
      for (const int gear : {1, 2})
        modified.pair.modify(gear, relieved(modified.pair.gears[gear - 1]));
      modified.pair.place.errors.crossing = Angle::degrees(0.04);
      // The tips of gear 1 with 43 teeth then reach below the usable flanks of gear 2.
      modified.pair.place.errors.center_distance = z1 == 43 ? -0.8 : 0.05;
      all.push_back(modified);
    }
  return all;
}

const std::vector<double> kHeights{-9.5, -8.9, -4.0, 0.3, 6.0, 8.5};

struct Scanned {
  double te = -1e300;
  GapJet jet;
  double share = 0.0;  // fraction of flank 1 that lies inside flank 2
};

// The greatest T at one height over the parts of flank 1 that lie inside flank 2, on grids that
// become finer about the best point.
std::optional<Scanned> scanned(const ContactPair& pair, double turn, double z) {
  std::optional<Scanned> best;
  for (const FlankPatch& a : pair.patches(1)) {
    if (z < a.z_lo || z > a.z_hi) continue;
    for (const FlankPatch& b : pair.patches(2)) {
      GapField field = pair.field(a, b);
      field.set_rotation(turn);
      double lo = a.s_lo, hi = a.s_hi, s2 = 0.5 * (b.s_lo + b.s_hi), at = lo;
      Scanned own;
      for (int level = 0; level < 14; ++level) {
        const int n = level == 0 ? 160 : 20;
        for (int i = 0; i <= n; ++i) {
          const double s = lo + (hi - lo) * i / n;
          const GapJet j = field.at(s, z, s2);
          const double from_mesh = std::arg(j.w1) - pair.mesh_azimuth();
          if (std::abs(std::remainder(from_mesh, 2 * std::numbers::pi)) > 0.6) continue;
          if (j.u.v < b.u_lo || j.u.v > b.u_hi || j.Z.v < b.z_lo || j.Z.v > b.z_hi) continue;
          if (level == 0) own.share += 1.0 / n;
          if (j.t.v > own.te) own.te = j.t.v, own.jet = j, at = s;
        }
        const double step = (hi - lo) / n;
        lo = std::max(a.s_lo, at - step);
        hi = std::min(a.s_hi, at + step);
      }
      if (own.te > -1e300 && (!best || own.te > best->te)) best = own;
    }
  }
  return best;
}

TEST(GapPlaces, AreThoseOfAScan) {
  int places = 0, edges = 0;
  for (const Case& c : cases()) {
    const ContactPair pair = c.pair.pair();
    GapSearch search(pair, kHeights);
    for (const double share : {-0.37, 0.0, 0.21}) {
      const double rotation = share * pair.pitch();
      const auto found = search.places(rotation);
      for (int k = -4; k <= 4; ++k) {
        const double turn = rotation - k * pair.pitch();
        const auto own = std::find_if(found.begin(), found.end(),
                                      [&](const PairPlaces& p) { return p.pair == k; });
        for (std::size_t i = 0; i < kHeights.size(); ++i) {
          const auto expected = scanned(pair, turn, kHeights[i]);
          const bool is = own != found.end() && own->at[i];
          const bool between_rows = expected && expected->share < 1.0 / (GapSearch::kRows - 1);
          if (!between_rows) {
            EXPECT_EQ(is, expected.has_value()) << c.name << ' ' << k << ' ' << kHeights[i];
          }
          if (!is || !expected) continue;
          const GapPlace& p = *own->at[i];
          ++places;
          if (is_edge(p.kind)) ++edges;
          EXPECT_EQ(own->turn, turn);
          EXPECT_NEAR(p.te, expected->te, 1e-13) << c.name << ' ' << k << ' ' << kHeights[i];
          EXPECT_NEAR(p.radius[0], std::abs(expected->jet.w1), 1e-5) << c.name << ' ' << k;
          EXPECT_NEAR(p.radius[1], std::abs(expected->jet.w), 1e-5) << c.name << ' ' << k;
          EXPECT_NEAR(p.arm, GapField::arm(expected->jet), 1e-5) << c.name << ' ' << k;
        }
      }
    }
  }
  EXPECT_GT(places, 1000);
  EXPECT_GT(edges, 100);
}

// The kind of a position is an edge if and only if its radius equals the radius of a tip or of an
// end of a flank.
TEST(GapPlaces, EdgesLieAtTheEndsOfTheFlanks) {
  std::array<int, 4> seen{};
  for (const Case& c : cases()) {
    const ContactPair pair = c.pair.pair();
    GapSearch search(pair, kHeights);
    for (const double share : {-0.37, 0.0, 0.21}) {
      for (const PairPlaces& p : search.places(share * pair.pitch())) {
        for (const auto& place : p.at) {
          if (!place) continue;
          const auto near = [&](int gear, double radius) {
            return std::abs(place->radius[gear - 1] - std::abs(radius)) < 1e-9;
          };
          const auto& [one, two] = c.pair.gears;
          const std::array at{near(1, one.tip_form_radius()), near(2, two.tip_form_radius()),
                              near(1, *one.root_form_radius()), near(2, *two.root_form_radius())};
          constexpr std::array kinds{TouchKind::tip1, TouchKind::tip2, TouchKind::form1,
                                     TouchKind::form2};
          const bool edge = std::find(at.begin(), at.end(), true) != at.end();
          EXPECT_EQ(is_edge(place->kind), edge) << c.name << ' ' << p.pair;
          for (std::size_t i = 0; i < kinds.size(); ++i) {
            if (place->kind != kinds[i]) continue;
            EXPECT_TRUE(at[i]) << c.name << ' ' << p.pair << ' ' << i;
            ++seen[i];
          }
        }
      }
    }
  }
  for (const int n : seen) EXPECT_GE(n, 10);
}

// For involutes on parallel axes, there is no gap on the plane of action, the arm is r_b2 cos β_b,
// and the curvature of the gap across the contact line is cos β_b (1/L_1 ± 1/L_2), where
// L = √(ρ² − r_b²).
TEST(GapPlaces, InvolutesHaveTheirClosedForms) {
  int lines = 0;
  for (const auto& [z2, beta] : {std::pair{43, 0.0}, {43, 18.0}, {-61, 0.0}, {-61, 15.0}}) {
    const SamplePair drawn = involutes(19, z2, beta);
    const ContactPair pair = drawn.pair();
    const double cos_b = std::cos(drawn.gears[0].reference().base_helix_angle);
    GapSearch search(pair, kHeights);
    for (const PairPlaces& p : search.places(0.1)) {
      for (const auto& place : p.at) {
        if (!place || is_edge(place->kind)) continue;
        ++lines;
        std::array<double, 2> roll{};
        for (std::size_t g = 0; g < 2; ++g)
          roll[g] =
              std::sqrt(std::pow(place->radius[g], 2) - std::pow(drawn.gears[g].base_radius(), 2));
        EXPECT_NEAR(place->te, 0.0, 1e-13);
        EXPECT_NEAR(place->arm, std::abs(drawn.gears[1].base_radius()) * cos_b, 1e-9);
        EXPECT_NEAR(place->curvature, cos_b * (1 / roll[0] + (z2 < 0 ? -1 : 1) / roll[1]), 1e-7);
      }
    }
  }
  EXPECT_GT(lines, 20);
}

// Where a tip relief begins, both patches have the same gap up to rounding. The curvature there is
// always taken from the same patch, so it changes little from one rotation to the next.
TEST(GapPlaces, TheStartOfAReliefHasOneCurvature) {
  for (const int which : {1, 2}) {
    SamplePair drawn = involutes(19, 43, 18.0);
    const FlankModifications m = relieved(drawn.gears[which - 1]);
    drawn.modify(which, m);
    const ContactPair pair = drawn.pair();
    GapSearch search(pair, {0.0});
    std::optional<double> before;
    int seen = 0;
    for (int i = 0; i < 400; ++i) {
      std::optional<double> curvature;
      for (const PairPlaces& p : search.places(pair.pitch() * (i / 400.0 - 0.5)))
        if (std::abs(p.at[0]->radius[which - 1] - *m.tip_relief.reach / 2) < 1e-9)
          curvature = p.at[0]->curvature;
      if (curvature) ++seen;
      if (curvature && before) {
        EXPECT_NEAR(*curvature / *before, 1.0, 0.01) << which << ' ' << i;
      }
      before = curvature;
    }
    EXPECT_GE(seen, 8) << which;
  }
}

// The slopes with respect to modifications are compared with differences. Positions that move to
// another patch are left out, because the slope changes at the start of a relief.
TEST(GapPlaces, SlopesAreThoseOfDifferences) {
  using P = Modification;
  struct Change {
    P parameter;
    double FlankModifications::*amount;
  };
  constexpr std::array kChanges{Change{P::profile_slope, &FlankModifications::profile_slope},
                                Change{P::profile_crowning, &FlankModifications::profile_crowning},
                                Change{P::lead_crowning, &FlankModifications::lead_crowning},
                                Change{P::lead_slope, &FlankModifications::lead_slope}};
  constexpr double kStep = 1e-5;  // mm
  int compared = 0;
  for (const Case& c : cases()) {
    if (!c.name.ends_with("modified")) continue;
    for (const int gear : {1, 2}) {
      for (const Change& change : kChanges) {
        const auto with = [&](double amount) {
          SamplePair drawn = c.pair;
          FlankModifications m = relieved(drawn.gears[gear - 1]);
          m.*change.amount += amount;
          drawn.modify(gear, m);
          return drawn;
        };
        const SamplePair drawn = with(0), more = with(kStep), less = with(-kStep);
        const ContactPair pair = drawn.pair(), above = more.pair(), below = less.pair();
        GapSearch search(pair, kHeights), of_above(above, kHeights), of_below(below, kHeights);
        const Influence influence{ErrorKind::center_distance, gear, change.parameter};
        const double rotation = 0.13 * pair.pitch();
        const auto here = search.places(rotation);
        const auto there = of_above.places(rotation), back = of_below.places(rotation);
        ASSERT_TRUE(here.size() == there.size() && here.size() == back.size()) << c.name;
        for (std::size_t k = 0; k < here.size(); ++k) {
          for (std::size_t i = 0; i < kHeights.size(); ++i) {
            const auto &a = here[k].at[i], &b = there[k].at[i], &d = back[k].at[i];
            if (!a || !b || !d || b->patches != d->patches || b->kind != d->kind) continue;
            if (std::abs(b->s - d->s) > 0.1) continue;  // moved to another maximum
            ++compared;
            EXPECT_NEAR(search.slope(here[k], i, influence), (b->te - d->te) / (2 * kStep), 2e-6)
                << c.name << ", gear " << gear << ", height " << kHeights[i] << ", pair " << k;
          }
        }
      }
    }
  }
  EXPECT_GT(compared, 500);
}

}  // namespace
}  // namespace gearwright
