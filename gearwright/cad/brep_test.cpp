#include "gearwright/cad/brep.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <map>
#include <set>
#include <sstream>

#include "gearwright/base/numbers.hpp"
#include "gearwright/cad/step.hpp"
#include "gearwright/cad/testing/sample_outlines.hpp"

namespace gearwright {
namespace {

using testing::sample_body;

struct Instance {
  std::string keyword;  // empty for a complex instance
  std::string text;
  std::vector<std::size_t> names;
};

// Instances are numbered from 1. An instance ends at a line that ends in a semicolon.
std::vector<Instance> instances_of(const std::string& file) {
  std::vector<Instance> list(1);
  const std::size_t data = file.find("DATA;\n") + 6;
  std::istringstream lines(file.substr(data, file.rfind("ENDSEC;") - data));
  for (std::string text; std::getline(lines, text, ';') && text.size() > 1; lines.get()) {
    const std::size_t equals = text.find('=');
    EXPECT_EQ(text.substr(0, equals), "#" + std::to_string(list.size()));
    Instance one{text.substr(equals + 1, text.find('(') - equals - 1), text.substr(equals + 1), {}};
    bool quoted = false;
    for (std::size_t i = equals; i < text.size(); ++i) {
      if (text[i] == '\'') quoted = !quoted;
      if (text[i] == '#' && !quoted) one.names.push_back(std::strtoul(&text[i + 1], nullptr, 10));
    }
    list.push_back(std::move(one));
  }
  return list;
}

ToothedBody keyed(double beta) {
  auto body = sample_body({.beta = beta});
  body.bore = Bore{20.0, 6.0, 2.8};
  return body;
}

std::vector<Instance> instances_of(const ToothedBody& body) {
  const auto made = step_document({body, body}, "two.step");
  EXPECT_TRUE(made);
  return instances_of(made->text);
}

TEST(Brep, EveryInstanceNamesEarlierOnesAndIsNamed) {
  const std::set<std::string> roots{
      "APPLICATION_PROTOCOL_DEFINITION", "SHAPE_DEFINITION_REPRESENTATION",
      "CONTEXT_DEPENDENT_SHAPE_REPRESENTATION", "PRODUCT_RELATED_PRODUCT_CATEGORY",
      "MECHANICAL_DESIGN_GEOMETRIC_PRESENTATION_REPRESENTATION"};
  for (const double beta : {0.0, 15 * kPi / 180}) {
    const std::vector<Instance> all = instances_of(keyed(beta));
    ASSERT_GT(all.size(), 5000u);
    std::vector<bool> named(all.size(), false);
    for (std::size_t i = 1; i < all.size(); ++i) {
      for (const std::size_t name : all[i].names) {
        EXPECT_TRUE(name >= 1 && name < i) << all[i].text;
        named[name] = true;
      }
    }
    for (std::size_t i = 1; i < all.size(); ++i)
      EXPECT_EQ(named[i], roots.count(all[i].keyword) == 0) << all[i].text;
  }
}

TEST(Brep, EveryEdgeIsUsedOnceEachWay) {
  const auto all = instances_of(keyed(0.2));
  const auto forward = [](const Instance& one) { return one.text.ends_with(".T.)"); };
  std::map<std::size_t, std::array<int, 2>> uses;
  for (const Instance& bound : all) {
    if (bound.keyword != "FACE_BOUND" && bound.keyword != "FACE_OUTER_BOUND") continue;
    for (const std::size_t use : all[bound.names.at(0)].names) {
      const bool along = forward(all[use]) == forward(bound);
      ++uses[all[use].names.at(0)][along ? 0 : 1];
    }
  }
  EXPECT_GT(uses.size(), 700u);
  for (const auto& [edge, ways] : uses) {
    EXPECT_EQ(all[edge].keyword, "EDGE_CURVE");
    EXPECT_EQ(ways, (std::array<int, 2>{1, 1})) << edge;
  }
}

TEST(Brep, NeighboursShareTheirPoles) {
  const auto made = step_document({keyed(0.2)}, "one.step");
  ASSERT_TRUE(made);
  std::set<std::string> points;
  for (const Instance& one : instances_of(made->text)) {
    if (one.keyword != "CARTESIAN_POINT") continue;
    // The origin is used by the axis and by the part.
    const bool origin = one.text.ends_with("(0.,0.,0.))");
    EXPECT_TRUE(points.insert(one.text).second || origin) << one.text;
  }
}

TEST(Brep, TeethAreExactTurnsOfTheFirst) {
  // A quarter turn maps tooth 0 of 20 exactly to tooth 5: (x, y) becomes (−y, x).
  const auto made = step_document({sample_body({})}, "spur.step");
  ASSERT_TRUE(made);
  std::set<std::array<double, 3>> points;
  for (const Instance& one : instances_of(made->text)) {
    if (one.keyword != "CARTESIAN_POINT") continue;
    std::array<double, 3> p{};
    const char* at = one.text.c_str() + one.text.find(",(") + 1;
    for (double& x : p) {
      char* end = nullptr;
      x = std::strtod(at + 1, &end);
      at = end;
    }
    points.insert(p);
  }
  ASSERT_GT(points.size(), 1000u);
  for (const auto& [x, y, z] : points)
    EXPECT_TRUE(points.count({y == 0.0 ? 0.0 : -y, x, z})) << x << ' ' << y << ' ' << z;
}

TEST(Brep, TextGrowsWithTheTeethAlone) {
  const auto size = [](int teeth) {
    return static_cast<double>(
        step_document({sample_body({.teeth = teeth, .beta = 0.2})}, "a.step")->text.size());
  };
  EXPECT_NEAR(size(400) / size(100), 4.0, 0.1);
}

}  // namespace
}  // namespace gearwright
