// For small tolerances, variances and percentiles of the samples equal the values of a linear form
// with the exact derivatives at the nominal pair.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "gearwright/contact/contact.hpp"
#include "gearwright/math/statistics.hpp"
#include "gearwright/scatter/scatter.hpp"
#include "gearwright/scatter/testing/drawn_pair.hpp"

namespace gearwright {
namespace {

using Q = ScatterQuantity;

struct Small {
  ScatterTolerance tolerance;
  double width;  // mm or rad
  Influence influence;
};

// The widths are a thousandth of usual widths, so that terms of second order are a thousandth of
// the terms of first order.
std::vector<Small> small_tolerances() {
  const auto range = [](const char* name, double width, auto of, Influence influence) {
    return Small{testing::tolerance(name, 1.0, -width, width, of), width, influence};
  };
  return {range("distance", 2e-5, VaryingError::center_distance, {ErrorKind::center_distance}),
          range("crossing", 3e-7, VaryingError::crossing, {ErrorKind::crossing}),
          range("intersecting", 5e-7, VaryingError::intersecting, {ErrorKind::intersecting}),
          range("helix slope", 5e-6, VaryingError::helix_slope2, {ErrorKind::helix_slope2}),
          range("crowning", 2e-6, VaryingModification{1, Modification::lead_crowning},
                {ErrorKind::center_distance, 1, Modification::lead_crowning}),
          range("profile", 2e-6, VaryingModification{1, Modification::profile_slope},
                {ErrorKind::center_distance, 1, Modification::profile_slope})};
}

// The derivatives of TE, averaged over the positions.
std::vector<double> mean_slopes(const ContactSetup& setup, int positions,
                                const std::vector<Small>& all) {
  const ContactPair pair = setup.pair(false);
  Transmission transmission(pair);
  const auto touches = one_pitch(transmission, -0.5 * pair.pitch(), positions);
  std::vector<double> slopes;
  for (const Small& s : all) {
    double sum = 0.0;
    for (const PairTouch& t : touches) sum += sensitivity(transmission, t, s.influence).te;
    slopes.push_back(sum / positions);
  }
  return slopes;
}

TEST(LinearLimit, IsThatOfTheExactDerivatives) {
  testing::DrawnPair drawn = testing::crowned_helical_pair();
  drawn.errors = {.center_distance = 0.01,
                  .crossing = Angle::degrees(0.01),
                  .intersecting = Angle::degrees(-0.02)};
  const ContactSetup setup = drawn.setup();
  const std::vector<Small> all = small_tolerances();
  ScatterTask task;
  std::vector<Influence> influences;
  for (const Small& s : all) {
    task.tolerances.push_back(s.tolerance);
    influences.push_back(s.influence);
  }
  task.samples = 1024;
  task.replicates = 4;
  task.percentiles = {5, 25, 75, 95};
  Deviation none;
  none.errors = drawn.errors;
  const MemberSpan span = continuous_peak_to_peak(setup, none, task.member, influences);
  const auto scatter = scatter_of(setup, task);
  ASSERT_TRUE(scatter) << scatter.error().message();
  const std::vector<double> mean = mean_slopes(setup, task.member.positions, all);
  const FamilyMember middle = member_at(setup, none, task.member);
  ASSERT_FALSE(middle.edge());
  ASSERT_NEAR(*middle[Q::peak_to_peak], *span.value, 1e-15);
  for (const auto& [quantity, slopes] :
       {std::pair(Q::peak_to_peak, span.slope), std::pair(Q::mean, mean)}) {
    // The variance of a uniform variable is a third of the square of its half width.
    double variance = 0.0;
    for (std::size_t i = 0; i < all.size(); ++i)
      variance += slopes[i] * slopes[i] * all[i].width * all[i].width / 3;
    const Spread& s = *scatter->spread[static_cast<std::size_t>(quantity)];
    const double deviation = std::sqrt(variance);
    ASSERT_GT(deviation, 1e-10);  // rad: 100 times the accuracy of an extreme
    EXPECT_NEAR(s.standard_deviation.value, deviation, 1e-3 * deviation);
    EXPECT_NEAR(s.mean.value, *middle[quantity], 1e-3 * deviation);
    // The linear form at the same samples has the same percentiles.
    std::vector<double> values;
    for (const auto& sample : scatter->samples) {
      double value = *middle[quantity];
      for (std::size_t i = 0; i < all.size(); ++i) value += slopes[i] * sample.x[i];
      values.push_back(value);
    }
    std::sort(values.begin(), values.end());
    for (const Percentile& p : s.percentiles)
      EXPECT_NEAR(p.estimate.value, quantile(values, p.percent / 100), 1e-3 * deviation)
          << p.percent;
  }
}

}  // namespace
}  // namespace gearwright
