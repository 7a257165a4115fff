// Checks the outline of a tooth as cut.
#pragma once

#include <gtest/gtest.h>

#include <vector>

#include "gearwright/generation/generate.hpp"

namespace gearwright::testing {

inline std::vector<ArcName> names(const GeneratedTooth& tooth) {
  std::vector<ArcName> all;
  for (const Arc& arc : tooth.outline.arcs) all.push_back(arc.name);
  return all;
}

/// Checks that the arcs join to the last bit, and lie on their own curves to 1e-12 of a radius of
/// the gear.
inline void expect_joined(const GeneratedTooth& tooth, double radius) {
  const auto& arcs = tooth.outline.arcs;
  ASSERT_FALSE(arcs.empty());
  for (std::size_t i = 0; i + 1 < arcs.size(); ++i)
    EXPECT_EQ(arcs[i].end_point, arcs[i + 1].begin_point);
  for (const Arc& arc : arcs) {
    EXPECT_LE((arc.curve->point(arc.begin) - arc.begin_point).norm(), 1e-12 * radius);
    EXPECT_LE((arc.curve->point(arc.end) - arc.end_point).norm(), 1e-12 * radius);
  }
}

}  // namespace gearwright::testing
