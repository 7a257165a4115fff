#include "gearwright/generation/branch.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <memory>
#include <vector>

namespace gearwright::detail {
namespace {

// The half angle is θ = c + k (ρ − a)(ρ − b), with the radius ρ as parameter.
class Parabola final : public Curve {
 public:
  Parabola(double c, double k, double a, double b) : c_(c), k_(k), a_(a), b_(b) {}
  Vec2 point(double t) const override { return at(t).point; }
  CurvePoint at(double t) const override {
    const std::complex<double> i(0.0, 1.0);
    const double slope = k_ * (2 * t - a_ - b_);
    const auto along = std::polar(1.0, polar_angle(t));
    const auto d1 = 1.0 + i * t * slope;
    const auto d2 = 2.0 * i * slope - t * slope * slope + 2.0 * i * t * k_;
    const auto w = t * along;
    return {Vec2(w.real(), w.imag()), std::arg(along * d1),
            (std::conj(d1) * d2).imag() / std::pow(std::abs(d1), 3)};
  }
  double polar_angle(double t) const override { return c_ + k_ * (t - a_) * (t - b_); }

 private:
  double c_, k_, a_, b_;
};

Branch parabola(double c, double k, double a, double b, double from, double to) {
  return branch_of(ArcName::flank, std::make_shared<Parabola>(c, k, a, b), from, to, 1.0);
}

void expect_ends(const std::vector<Branch>& chain, const std::vector<double>& ends) {
  ASSERT_EQ(chain.size() + 1, ends.size());
  for (std::size_t i = 0; i < chain.size(); ++i) {
    EXPECT_NEAR(chain[i].height_lo, ends[i], 1e-12);
    EXPECT_NEAR(chain[i].height_hi, ends[i + 1], 1e-12);
  }
}

// Between 1.415 and 1.4245, the second branch is lower than the first. A search that starts at
// 1.415 evaluates the branches only beyond 1.4245, where the first branch is lower.
TEST(LowerEnvelope, a_dent_narrower_than_the_steps_behind_its_beginning) {
  const std::vector<Branch> branches{parabola(0.1, 0.0, 0.0, 0.0, 1.0, 2.0),
                                     parabola(0.1, 1.0, 1.415, 1.4245, 1.2, 1.9)};
  const auto chain = lower_envelope(branches, 2.0);
  expect_ends(chain, {1.0, 1.415, 1.4245, 2.0});
  EXPECT_EQ(chain[1].curve, branches[1].curve);
}

TEST(LowerEnvelope, branches_that_coincide_are_one) {
  constexpr double kRounded = 1e-15;
  const std::vector<Branch> branches{parabola(0.1, 1.0, 0.2, 0.3, 1.0, 1.6),
                                     parabola(0.1 + kRounded, 1.0, 0.2, 0.3, 1.2, 1.7),
                                     parabola(0.1 - kRounded, 1.0, 0.2, 0.3, 1.4, 2.0)};
  const auto chain = lower_envelope(branches, 2.0);
  ASSERT_FALSE(chain.empty());
  EXPECT_TRUE(is_continuous(chain));
  EXPECT_LE(chain.size(), branches.size());
  EXPECT_NEAR(chain.front().height_lo, 1.0, 1e-12);
  EXPECT_NEAR(chain.back().height_hi, 2.0, 1e-12);
}

}  // namespace
}  // namespace gearwright::detail
