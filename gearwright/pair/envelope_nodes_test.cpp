#include "gearwright/pair/envelope_nodes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace gearwright::detail {
namespace {

std::vector<EnvelopeNode> list(const EnvelopeNodes& nodes) { return {nodes.begin(), nodes.end()}; }

// Checks that the radius is monotone between connected nodes.
template <class At>
void expect_one_way(const At& at, const std::vector<EnvelopeNode>& nodes) {
  constexpr int kLooks = 200;
  constexpr double kRounding = 1e-11;
  for (std::size_t i = 1; i < nodes.size(); ++i) {
    if (nodes[i].begins) continue;
    const EnvelopeNode one = nodes[i - 1], two = nodes[i];
    const double way = two.radius > one.radius ? 1.0 : -1.0;
    double last = one.radius;
    for (int k = 1; k <= kLooks; ++k) {
      const double here = at(one.u + (two.u - one.u) * k / kLooks).radius;
      EXPECT_GE(way * (here - last), -kRounding) << one.u << " to " << two.u;
      last = here;
    }
  }
}

// Near the end of the envelope, its radius varies like a square root. Shortly before this end, in
// the same eighth of the arc, the radius is stationary.
TEST(EnvelopeNodes, end_where_the_envelope_ends_and_stand_where_it_turns) {
  constexpr double kEnd = 0.62;
  const auto at = [](double u) {
    const double left = std::sqrt(std::max(0.0, kEnd - u));
    return EnvelopePlace{kEnd - u, -1.0, 2.0 - u - 0.2 * left, 0.1 - left};
  };
  const auto nodes = list(EnvelopeNodes(at));
  expect_one_way(at, nodes);
  ASSERT_EQ(nodes.size(), 7u);
  EXPECT_TRUE(nodes[0].begins);
  EXPECT_NEAR(nodes[5].u, kEnd - 0.01, 1e-6);
  EXPECT_NEAR(nodes[6].u, kEnd, 1e-13);
}

// The whole envelope lies within one eighth of the arc, and there is no envelope at the ends of
// this eighth.
TEST(EnvelopeNodes, find_an_envelope_between_two_looks) {
  const auto at = [](double u) {
    const double off = u - 0.31;
    return EnvelopePlace{1e-3 - off * off, -2 * off, 1.0 + u, 1.0};
  };
  const auto nodes = list(EnvelopeNodes(at));
  expect_one_way(at, nodes);
  ASSERT_EQ(nodes.size(), 3u);
  EXPECT_TRUE(nodes[0].begins);
  EXPECT_NEAR(nodes[0].u, 0.31 - std::sqrt(1e-3), 1e-12);
  EXPECT_NEAR(nodes[2].u, 0.31 + std::sqrt(1e-3), 1e-12);
}

}  // namespace
}  // namespace gearwright::detail
