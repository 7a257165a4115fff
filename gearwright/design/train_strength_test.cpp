// The estimate of the safety factors of trains. Trains whose safety factors follow the fitted law
// are left out if and only if they miss the required safety factors by more than the margins.
#include "gearwright/design/train_strength.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace gearwright {
namespace {

// A train of two stages with safeties by hand formulas: S_H² = A/(κ z_1^0.6), S_F = B/(w u^0.5).
// S_H and S_F are multiplied by e^s, where s is random within ±`scatter_range`.
RatedTrain law_train(std::mt19937& random, double scatter_range) {
  std::uniform_int_distribution<int> pinion(17, 40), wheel(40, 150), width(15, 60);
  std::uniform_real_distribution<double> scatter(-scatter_range, scatter_range);
  RatedTrain train;
  train.candidate.stages = {{pinion(random), wheel(random)}, {pinion(random), wheel(random)}};
  train.candidate.face_widths = {1.0 * width(random), 1.0 * width(random)};
  double torque = 1.0;
  for (std::size_t k = 0; k < 2; ++k) {
    const auto& [z1, z2] = train.candidate.stages[k];
    const double u = static_cast<double>(z2) / z1;
    const double w = torque / (train.candidate.face_widths[k] * z1);
    const double kappa = w * (u + 1) / (u * z1);
    train.stages.push_back(
        {std::sqrt(0.0001 / (kappa * std::pow(z1, 0.6))) * std::exp(scatter(random)),
         0.002 / (w * std::sqrt(u)) * std::exp(scatter(random))});
    torque *= u;
  }
  return train;
}

std::vector<RatedTrain> law_trains(std::mt19937& random, double scatter_range) {
  std::vector<RatedTrain> trains;
  for (int i = 0; i < 64; ++i) trains.push_back(law_train(random, scatter_range));
  return trains;
}

// Without scatter, the estimate gives exactly the safeties of the law. It therefore rules out a
// train if and only if a required safety exceeds the safety of the train by more than the margin.
TEST(TrainStrengthTest, LeavesOutTrainsBeyondTheMargins) {
  std::mt19937 random(7);
  const TrainStrength strength(law_trains(random, 0.0));
  for (int i = 0; i < 200; ++i) {
    const RatedTrain train = law_train(random, 0.0);
    const double flank = std::min(train.stages[0].flank, train.stages[1].flank);
    const double root = std::min(train.stages[0].root, train.stages[1].root);
    EXPECT_FALSE(strength.is_hopeless(train.candidate, {0.999 * flank * std::exp(kFlankMargin),
                                                        0.999 * root * std::exp(kRootMargin)}));
    EXPECT_TRUE(
        strength.is_hopeless(train.candidate, {1.001 * flank * std::exp(kFlankMargin), 1e-9}));
    EXPECT_TRUE(
        strength.is_hopeless(train.candidate, {1e-9, 1.001 * root * std::exp(kRootMargin)}));
  }
}

// Law (1): a train from which the estimate was made is not hopeless if it has the required
// safeties. With scatter, other trains of the same kind are not hopeless either, because the
// margins cover the difference.
TEST(TrainStrengthTest, KeepsTrainsWithTheRequiredSafeties) {
  std::mt19937 random(11);
  const std::vector<RatedTrain> rated = law_trains(random, 0.06);
  const TrainStrength strength(rated);
  std::vector<RatedTrain> all = rated;
  for (int i = 0; i < 500; ++i) all.push_back(law_train(random, 0.06));
  for (const RatedTrain& train : all)
    EXPECT_FALSE(strength.is_hopeless(train.candidate,
                                      {std::min(train.stages[0].flank, train.stages[1].flank),
                                       std::min(train.stages[0].root, train.stages[1].root)}));
}

// Without scatter, the least face width for the safeties of a stage is the width of this stage,
// whichever of the safeties is required.
TEST(TrainStrengthTest, TheLeastWidthHasTheRequiredSafeties) {
  std::mt19937 random(5);
  const TrainStrength strength(law_trains(random, 0.0));
  ASSERT_TRUE(strength.estimates(2));
  EXPECT_FALSE(strength.estimates(3));
  for (int i = 0; i < 200; ++i) {
    const RatedTrain train = law_train(random, 0.0);
    for (const std::size_t k : {0, 1}) {
      const double own = train.candidate.face_widths[k];
      const auto [flank, root] = train.stages[k];
      EXPECT_NEAR(strength.least_width(train.candidate, k, {flank, 1e-9}), own, 1e-6 * own);
      EXPECT_NEAR(strength.least_width(train.candidate, k, {1e-9, root}), own, 1e-6 * own);
      // S_H is proportional to √b and S_F to b.
      EXPECT_NEAR(strength.least_width(train.candidate, k, {1.1 * flank, 1.1 * root}), 1.21 * own,
                  1e-6 * own);
    }
  }
}

TEST(TrainStrengthTest, EstimatesNothingFromTooFewTrains) {
  std::mt19937 random(3);
  std::vector<RatedTrain> few = law_trains(random, 0.0);
  few.resize(kLeastRatedTrains - 1);
  for (const TrainStrength& strength : {TrainStrength(), TrainStrength(few)})
    EXPECT_FALSE(strength.is_hopeless(few.front().candidate, {1e9, 1e9}));
}

// Equal pinions and a fixed face width make terms of the fit equal.
TEST(TrainStrengthTest, AcceptsTermsWithoutVariation) {
  std::vector<RatedTrain> rated;
  for (int z2 = 40; z2 < 80; ++z2) {
    RatedTrain train;
    train.candidate.stages = {{20, z2}};
    train.stages = {{1.5, 2.5}};
    rated.push_back(train);
  }
  const TrainStrength strength(rated);
  EXPECT_FALSE(strength.is_hopeless(rated[10].candidate, {1.5, 2.5}));
  EXPECT_TRUE(strength.is_hopeless(rated[10].candidate, {1.8, 2.5}));
}

}  // namespace
}  // namespace gearwright
