// The oracle is the peak to peak of TE at thousands of positions (a comb). Laws: (1) the span is
// not less than that of a comb, and exceeds it by at most the error of the comb   (2) the result
// does not depend on the number of positions   (3) span_slope() is the limit of differences of the
// span.
#include "gearwright/contact/continuous.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "gearwright/base/units.hpp"
#include "gearwright/contact/contact.hpp"
#include "gearwright/contact/testing/sample_pairs.hpp"

namespace gearwright {
namespace {

double continuous(const ContactPair& pair, int positions) {
  Transmission transmission(pair);
  return continuous_extremes(transmission, one_pitch(transmission, -0.5 * pair.pitch(), positions))
      .span();
}

// The peak to peak of a comb, and a bound for its error, which arises between the positions.
struct Comb {
  double span, missed;
};

Comb comb(const ContactPair& pair, int positions) {
  const std::vector<double> te = transmission_error(pair, positions);
  double steepest = 0.0;
  for (std::size_t i = 0; i < te.size(); ++i)
    steepest = std::max(steepest, std::abs(te[i] - te[(i + 1) % te.size()]));
  return {peak_to_peak(te), 2 * steepest};
}

std::vector<testing::SamplePair> pairs() {
  std::vector<testing::SamplePair> all{testing::involutes(23, 61, -20),
                                       testing::involutes(20, 40, 0),
                                       testing::involutes(17, -61, 12), testing::arcs()};
  FlankModifications crowned;
  crowned.lead_crowning = 0.008;
  crowned.profile_crowning = 0.004;
  all.push_back(testing::involutes(17, 43, 15));
  all.back().modify(1, crowned);
  return all;
}

TEST(Continuous, IsTheCurveOfManyPositions) {
  std::mt19937 seeded(38);
  const auto angle = [&] {
    return Angle::degrees(std::uniform_real_distribution<>(-0.03, 0.03)(seeded));
  };
  for (testing::SamplePair sample : pairs()) {
    for (int i = 0; i < 4; ++i) {
      sample.place.errors = {
          .center_distance = 0.01 * (i - 2), .crossing = angle(), .intersecting = angle()};
      sample.place.gear2_drives = i == 3;
      const ContactPair pair = sample.pair();
      SCOPED_TRACE(std::to_string(pair.patches(2).size()) + " patches, teeth " +
                   std::to_string(sample.gears[1].spec.teeth) + ", errors " + std::to_string(i));
      const Comb fine = comb(pair, 2048);
      const double found = continuous(pair, 64);
      EXPECT_GE(found, fine.span - 1e-12);
      EXPECT_LE(found, fine.span + fine.missed + 1e-12);
    }
  }
}

TEST(Continuous, DoesNotDependOnThePositions) {
  auto sample = testing::involutes(23, 61, -20);
  sample.place.errors = {.center_distance = 0.0085,
                         .crossing = Angle::degrees(0.02),
                         .intersecting = Angle::degrees(-0.02)};
  const ContactPair pair = sample.pair();
  const double few = continuous(pair, 32);
  for (const int n : {33, 96, 128, 1000}) EXPECT_NEAR(continuous(pair, n), few, 1e-11) << n;
  // The error of a comb of 32 positions is more than a thousand times the limit above.
  EXPECT_GT(std::abs(peak_to_peak(transmission_error(pair, 32)) - few), 1e-8);
}

// On crossed crowned spur gears, the greatest TE is where the contact leaves the tip edge. The slope
// of T jumps there.
TEST(Continuous, KinksDoNotDependOnThePositions) {
  FlankModifications crowned;
  crowned.lead_crowning = 0.008;
  for (const auto& [z1, z2] : {std::pair{17, 43}, {18, 38}, {23, 61}}) {
    auto sample = testing::involutes(z1, z2, 0);
    sample.modify(1, crowned);
    sample.place.errors = {.crossing = Angle::degrees(0.03)};
    const ContactPair pair = sample.pair();
    EXPECT_NEAR(continuous(pair, 32), continuous(pair, 1000), 3e-12) << z1;
  }
}

TEST(Continuous, SlopesAreThoseOfDifferences) {
  // (3) span_slope() is compared with central differences of the span, for three kinds of error and
  // for lead crowning.
  std::mt19937 seeded(16);
  const auto random = [&](double w) { return std::uniform_real_distribution<>(-w, w)(seeded); };
  const auto span_at = [](testing::SamplePair sample, FlankModifications m, ErrorKind kind,
                          double by, double crowning) {
    ContactErrors& e = sample.place.errors;
    if (kind == ErrorKind::center_distance) e.center_distance += by;
    if (kind == ErrorKind::crossing) e.crossing += Angle::radians(by);
    if (kind == ErrorKind::intersecting) e.intersecting += Angle::radians(by);
    m.lead_crowning += crowning;
    sample.modify(1, m);
    return continuous(sample.pair(), 32);
  };
  FlankModifications m;
  m.lead_crowning = 0.004;
  m.profile_crowning = 0.003;
  for (int i = 0; i < 8; ++i) {
    testing::SamplePair sample = testing::involutes(23, 61, i % 2 == 0 ? -20 : 0);
    sample.place.errors = {.center_distance = random(0.02),
                           .crossing = Angle::degrees(random(0.03)),
                           .intersecting = Angle::degrees(random(0.03))};
    sample.place.gear2_drives = i % 4 >= 2;
    sample.modify(1, m);
    const ContactPair pair = sample.pair();
    Transmission transmission(pair);
    const CurveExtremes extremes =
        continuous_extremes(transmission, one_pitch(transmission, -0.5 * pair.pitch(), 32));
    for (const ErrorKind kind :
         {ErrorKind::center_distance, ErrorKind::crossing, ErrorKind::intersecting}) {
      const double h = 1e-6;
      const double difference =
          (span_at(sample, m, kind, h, 0) - span_at(sample, m, kind, -h, 0)) / (2 * h);
      const double slope = span_slope(transmission, extremes, {kind});
      EXPECT_NEAR(slope, difference, 1e-4 * std::abs(difference) + 1e-7)
          << i << " error " << static_cast<int>(kind);
    }
    const double h = 1e-6;  // mm
    const double difference =
        (span_at(sample, m, ErrorKind::axial, 0, h) - span_at(sample, m, ErrorKind::axial, 0, -h)) /
        (2 * h);
    const double slope = span_slope(transmission, extremes,
                                    {ErrorKind::center_distance, 1, Modification::lead_crowning});
    EXPECT_NEAR(slope, difference, 1e-4 * std::abs(difference) + 1e-7) << i << " crowning";
  }
}

TEST(Continuous, ConjugateFlanksHaveNoSpan) {
  EXPECT_LT(continuous(testing::involutes(20, 41, 12).pair(), 16), 1e-13);
}

TEST(Continuous, EdgesAreThoseOfTheDescription) {
  for (testing::SamplePair sample : pairs()) {
    for (const double tilt : {0.0, 0.01, 0.2}) {
      sample.place.errors.crossing = Angle::degrees(tilt);
      const ContactPair pair = sample.pair();
      Transmission transmission(pair);
      for (const PairTouch& t : one_pitch(transmission, -0.5 * pair.pitch(), 12)) {
        const auto kind = describe(transmission, t, Angle::radians(t.phi), 0.005).kind;
        EXPECT_EQ(on_edge(transmission, t), is_edge(kind));
      }
    }
  }
}

}  // namespace
}  // namespace gearwright
