// Compares vector lanes with their scalar instance, and the scalar instance with the formulas of a
// pair.
#include "gearwright/pair/closed_forms.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <numbers>
#include <random>
#include <vector>

#include "gearwright/base/numbers.hpp"
#include "gearwright/gear/reference.hpp"
#include "gearwright/math/involute.hpp"
#include "gearwright/pair/mesh.hpp"

namespace gearwright {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

std::int64_t bits(double x) {
  std::int64_t whole = 0;
  std::memcpy(&whole, &x, sizeof whole);
  return whole;
}

std::int64_t ulps(double a, double b) { return std::abs(bits(a) - bits(b)); }

std::vector<double> involutes_of_all_sizes(std::size_t n) {
  std::mt19937_64 random(41);
  std::uniform_real_distribution<double> exponent(-300.0, 12.0), usual(0.0, 2.0);
  std::vector<double> y{
      0.0,   -0.0, 5e-324, 1e-310, 1e-200, -1e-200, 1.1,      std::nextafter(1.1, 0.0),
      -1e12, 1e12, 2e12,   -2e12,  kNan,   1e-3,    kInfinity};
  while (y.size() < n) {
    y.push_back(std::pow(10.0, exponent(random)));
    y.push_back(-usual(random));
  }
  return y;
}

TEST(ClosedForms, inverse_involutes_in_lanes_have_the_scalar_bits) {  // (1)
  const std::vector<double> y = involutes_of_all_sizes(200'001);
  std::vector<double> lanes(y.size()), scalar(y.size());
  inverse_involutes(y.data(), lanes.data(), y.size());
  inverse_involutes_scalar(y.data(), scalar.data(), y.size());
  for (std::size_t i = 0; i < y.size(); ++i) {
    if (std::isnan(lanes[i]) && std::isnan(scalar[i])) continue;
    ASSERT_EQ(bits(lanes[i]), bits(scalar[i])) << y[i];
  }
}

// According to docs/accuracy.md, the relative error of the iteration is at most 5.3e-16, and that
// of the polynomials at most 2.6e-16. Together this is 7 ulp of an α just below a power of two. The
// greatest errors do not coincide, so the limit is 6 ulp.
TEST(ClosedForms, inverse_involutes_are_where_the_iteration_ends) {
  const std::vector<double> y = involutes_of_all_sizes(200'001);
  std::vector<double> alpha(y.size());
  inverse_involutes(y.data(), alpha.data(), y.size());
  for (std::size_t i = 0; i < y.size(); ++i) {
    if (!(std::abs(y[i]) <= 1e12)) {
      EXPECT_TRUE(std::isnan(alpha[i])) << y[i];
      continue;
    }
    const double iterated = inverse_involute(y[i]);
    EXPECT_EQ(std::signbit(alpha[i]), std::signbit(y[i]));
    ASSERT_LE(ulps(std::abs(alpha[i]), std::abs(iterated)), 6) << y[i];
  }
}

struct Rows {
  std::array<std::vector<double>, BacklashColumns::kIn> columns;
  BacklashConstants constants{2.5, std::tan(std::numbers::pi / 9)};

  std::size_t size() const { return columns[0].size(); }
  void add(const std::array<double, BacklashColumns::kIn>& row) {
    for (std::size_t k = 0; k < row.size(); ++k) columns[k].push_back(row[k]);
  }
  double at(BacklashColumns::In k, std::size_t i) const { return columns[k][i]; }
  template <class F>
  std::vector<double> through(const F& f) const {
    BacklashColumns in;
    for (std::size_t k = 0; k < columns.size(); ++k) in.in[k] = columns[k].data();
    std::vector<double> out(size());
    f(constants, in, out.data(), size());
    return out;
  }
};

Rows some_pairs(std::size_t n) {
  std::mt19937_64 random(42);
  const auto between = [&](double lo, double hi) {
    return std::uniform_real_distribution<double>(lo, hi)(random);
  };
  Rows rows;
  for (std::size_t i = 0; i < n; ++i) {
    const double z1 = std::round(between(8, 100));
    const bool ring = between(0, 1) < 0.25;
    const double z2 = ring ? -z1 - std::round(between(8, 100)) : std::round(between(8, 150));
    const double beta = between(-0.7, 0.7);
    const double a = rows.constants.normal_module * (std::abs(z1 + z2) / (2 * std::cos(beta)) +
                                                     (ring ? -1.0 : 1.0) * between(-0.2, 1));
    rows.add({z1, z2, between(-0.5, 0.8), between(-0.5, 0.8), std::sin(beta), between(-0.2, 0),
              between(-0.2, 0), a});
  }
  return rows;
}

TEST(ClosedForms, backlashes_in_lanes_agree_with_the_scalar_instance) {  // (2)
  const Rows rows = some_pairs(100'000);
  const auto lanes = rows.through(normal_backlashes);
  const auto scalar = rows.through(normal_backlashes_scalar);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    ASSERT_EQ(std::isnan(lanes[i]), std::isnan(scalar[i])) << i;
    if (!std::isnan(lanes[i])) {
      ASSERT_NEAR(lanes[i], scalar[i], 1e-12 * rows.constants.normal_module) << i;
    }
  }
}

TEST(ClosedForms, backlashes_are_those_of_the_mesh) {
  const Rows rows = some_pairs(20'000);
  const auto j = rows.through(normal_backlashes);
  const double alpha_n = std::atan(rows.constants.tan_alpha);
  int compared = 0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const auto at = [&](BacklashColumns::In k) { return rows.at(k, i); };
    using In = BacklashColumns;
    const double beta = std::asin(at(In::sin_beta));
    MeshInput<double> in;
    in.center_distance = at(In::center_distance);
    const auto gear = [&](In::In teeth, double helix, In::In x, In::In allowance) {
      const int z = static_cast<int>(at(teeth));
      return base_gear(
          z, reference_geometry(ReferenceInput<double>{z, rows.constants.normal_module, alpha_n,
                                                       helix, at(x), at(allowance)}));
    };
    in.gears = {gear(In::z1, beta, In::x1, In::allowance_1),
                gear(In::z2, at(In::z2) < 0 ? beta : -beta, In::x2, In::allowance_2)};
    if (!(in.center_distance > base_radius_sum(in.gears))) {
      EXPECT_TRUE(std::isnan(j[i]));
      continue;
    }
    ++compared;
    // The limit is 2a sin α_n times the rounding errors for a ≤ 200 modules.
    ASSERT_NEAR(j[i], mesh_of(in).backlash.normal, 2e-12 * rows.constants.normal_module) << i;
  }
  EXPECT_GT(compared, 15'000);
}

TEST(ClosedForms, rows_that_are_no_pair_are_nan) {
  Rows rows;
  rows.add({17, 43, 0, 0, 0, 0, 0, 80});  // only this row is a pair
  for (const auto& [z1, z2, sin_beta, a] : {std::array{17.5, 43.0, 0.0, 80.0},
                                            {17.0, 43.25, 0.0, 80.0},
                                            {0.0, 43.0, 0.0, 80.0},
                                            {-17.0, 43.0, 0.0, 80.0},
                                            {17.0, 0.0, 0.0, 80.0},
                                            {43.0, -17.0, 0.0, 80.0},
                                            {17.0, -17.0, 0.0, 80.0},
                                            {17.0, 2e6, 0.0, 8e6},
                                            {17.0, 43.0, 1.0, 80.0},
                                            {17.0, 43.0, kNan, 80.0},
                                            {17.0, 43.0, 0.0, 70.0},
                                            {17.0, 43.0, 0.0, -80.0},
                                            {17.0, 43.0, 0.0, kNan},
                                            {kNan, 43.0, 0.0, 80.0},
                                            {17.0, 43.0, 1.5, 80.0}})
    rows.add({z1, z2, 0, 0, sin_beta, 0, 0, a});
  for (const auto& j : {rows.through(normal_backlashes), rows.through(normal_backlashes_scalar)}) {
    EXPECT_GT(j[0], 0.0);
    for (std::size_t i = 1; i < j.size(); ++i) EXPECT_TRUE(std::isnan(j[i])) << i;
  }
  rows.constants.normal_module = -2.5;
  EXPECT_TRUE(std::isnan(rows.through(normal_backlashes)[0]));
}

}  // namespace
}  // namespace gearwright
