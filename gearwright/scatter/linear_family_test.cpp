// Laws: (1) without a deviation, the result equals continuous_peak_to_peak()   (2) for small
// deviations, the result changes like continuous_peak_to_peak().
#include "gearwright/scatter/linear_family.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "gearwright/load/gap_places.hpp"
#include "gearwright/scatter/sample_points.hpp"
#include "gearwright/scatter/testing/drawn_pair.hpp"

namespace gearwright {
namespace {

using P = Modification;

// Tolerances of the housing, of the bores and of both flanks, all multiplied by `width`.
std::vector<ScatterTolerance> tolerances_of_all(double width) {
  using testing::tolerance;
  return {
      testing::crossing(0.02 * width),
      tolerance("errors.helix_slope1_um", 1e-3, -8 * width, 8 * width, VaryingError::helix_slope1),
      tolerance("bearings.bore_a", 1.0, -0.02 * width, 0.02 * width, VaryingBore{100, 10, false}),
      tolerance("gear1.modifications.lead_crowning_um", 1e-3, -3 * width, 3 * width,
                VaryingModification{1, P::lead_crowning}),
      tolerance("gear2.modifications.profile_slope_um", 1e-3, -5 * width, 5 * width,
                VaryingModification{2, P::profile_slope})};
}

// Form waves. At their full heights, T has several maxima.
std::vector<ScatterTolerance> waves(double height) {
  using testing::tolerance;
  return {tolerance("gear1.profile_waves", 1.0, 0.0, 1.0, VaryingWave{1, false, {1, 3}, height}),
          tolerance("gear2.helix_waves", 1.0, 0.0, 1.0, VaryingWave{2, true, {1, 3}, height})};
}

struct Compared {
  double change;  // greatest change of the exact peak to peak, rad
  double error;   // greatest error of the first-order estimate, rad
};

Compared compared(const ContactSetup& setup, const ScatterTask& task) {
  const auto linear = LinearFamily::of(setup, task.member);
  EXPECT_TRUE(linear);
  const double drawn =
      continuous_peak_to_peak(setup, {setup.place().errors, setup.modifications(), false, {}, {}},
                              task.member)
          .value;
  Compared c{0.0, 0.0};
  for (const auto& x : SamplePoints(task).first(0, 32)) {
    const Deviation d = deviation_at(setup, task.tolerances, x);
    const double exact = continuous_peak_to_peak(setup, d, task.member).value;
    c.change = std::max(c.change, std::abs(exact - drawn));
    c.error = std::max(c.error, std::abs(linear->peak_to_peak(d) - exact));
  }
  return c;
}

TEST(LinearFamily, WithoutADeviationItIsExact) {
  for (const auto& drawn : {testing::crowned_helical_pair(), testing::plain_helical_pair()}) {
    const ContactSetup setup = drawn.setup();
    const MemberRequest request;
    const Deviation none{setup.place().errors, setup.modifications(), false, {}, {}};
    const auto linear = LinearFamily::of(setup, request);
    ASSERT_TRUE(linear);
    EXPECT_NEAR(linear->peak_to_peak(none), continuous_peak_to_peak(setup, none, request).value,
                1e-12);
  }
}

TEST(LinearFamily, SmallDeviationsChangeItAsTheExactOne) {
  ContactErrors errors;
  errors.crossing = Angle::degrees(0.01);
  for (const bool gear2_drives : {false, true}) {
    testing::DrawnPair drawn = testing::crowned_helical_pair();
    drawn.errors = errors;
    const ContactSetup setup = drawn.setup();
    ScatterTask task;
    task.member.gear2_drives = gear2_drives;
    task.tolerances = waves(5e-6);
    const Compared small = compared(setup, task);
    EXPECT_GT(small.change, 0.0);
    EXPECT_LT(small.error, 0.02 * small.change);
    // With tolerances of full width, the estimate is accurate enough for a diagram.
    task.tolerances = tolerances_of_all(1.0);
    const Compared wide = compared(setup, task);
    EXPECT_LT(wide.error, 0.05 * wide.change) << gear2_drives;
  }
}

// Edges begin to touch within the tolerances, so the peak to peak has no slope there.
TEST(LinearFamily, EdgesTouchAsTheyDoExactly) {
  const ContactSetup setup = testing::plain_helical_pair().setup();
  ScatterTask task;
  task.tolerances = {testing::distance(0.0175), testing::crossing(0.03),
                     testing::intersecting(0.03)};
  const Compared c = compared(setup, task);
  EXPECT_LT(c.error, 0.15 * c.change);
}

TEST(LinearFamily, ALostContactHasNoEstimate) {
  testing::DrawnPair apart = testing::spur_pair(true);
  apart.errors.center_distance = 6.0;
  EXPECT_FALSE(LinearFamily::of(apart.setup(), {}));
}

// The effect of a removal by row_turn(), multiplied by the removal per unit of a modification, is
// the slope of T with respect to this modification.
TEST(RowTurn, TimesAFieldItIsTheSlope) {
  const ContactSetup setup = testing::crowned_helical_pair().setup().with_fields({true, true});
  for (const bool gear2_drives : {false, true}) {
    const ContactPair pair = setup.pair(gear2_drives);
    GapSearch search(pair, {-12.5, -5.0, 0.0, 7.0});
    int places = 0;
    for (const PairPlaces& p : search.places(0.3 * pair.pitch())) {
      for (std::size_t i = 0; i < p.at.size(); ++i) {
        if (!p.at[i]) continue;
        ++places;
        for (const int gear : {1, 2}) {
          const RemovalTurn turn = search.turn(p, i, gear);
          const RemovalField* field = pair.patches(gear).front().removal;
          for (const P parameter : {P::profile_slope, P::lead_crowning, P::lead_slope})
            EXPECT_NEAR(turn.te * field->derivative(parameter, turn.u, turn.z, turn.piece).c,
                        search.slope(p, i, {ErrorKind::center_distance, gear, parameter}),
                        1e-9 * std::abs(turn.te))
                << gear << ' ' << i;
        }
      }
    }
    EXPECT_GT(places, 4);
  }
}

}  // namespace
}  // namespace gearwright
