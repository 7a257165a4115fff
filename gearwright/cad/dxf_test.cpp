#include "gearwright/cad/dxf.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <map>
#include <set>
#include <sstream>
#include <utility>

#include "gearwright/base/numbers.hpp"
#include "gearwright/cad/biarc.hpp"
#include "gearwright/cad/section.hpp"
#include "gearwright/cad/testing/arc_distance.hpp"
#include "gearwright/cad/testing/odd_outlines.hpp"
#include "gearwright/cad/testing/sample_outlines.hpp"

namespace gearwright {
namespace {

using DxfGroup = std::pair<int, std::string>;

std::vector<DxfGroup> pairs_of(const std::string& text) {
  std::istringstream in(text);
  std::vector<DxfGroup> pairs;
  for (std::string code, value; std::getline(in, code) && std::getline(in, value);) {
    pairs.emplace_back(std::stoi(code), value);
  }
  return pairs;
}

struct Entity {
  std::string type;
  std::string layer;
  std::vector<DxfGroup> pairs;

  std::vector<double> reals(int code) const {
    std::vector<double> result;
    for (const DxfGroup& p : pairs) {
      if (p.first == code) result.push_back(std::stod(p.second));
    }
    return result;
  }
  std::vector<std::string> words(int code) const {
    std::vector<std::string> result;
    for (const DxfGroup& p : pairs) {
      if (p.first == code) result.push_back(p.second);
    }
    return result;
  }
};

std::vector<Entity> entities_of(const std::string& text) {
  std::vector<Entity> entities;
  bool inside = false;
  const std::vector<DxfGroup> pairs = pairs_of(text);
  for (const DxfGroup& p : pairs) {
    if (p == DxfGroup{2, "ENTITIES"})
      inside = true;
    else if (inside && p == DxfGroup{0, "ENDSEC"})
      break;
    else if (inside && p.first == 0)
      entities.push_back({p.second, "", {}});
    else if (inside) {
      entities.back().pairs.push_back(p);
      if (p.first == 8) entities.back().layer = p.second;
    }
  }
  return entities;
}

struct Polyline {
  std::vector<Vec2> points;
  std::vector<double> bulges;

  explicit Polyline(const Entity& e) {
    for (const auto& [code, value] : e.pairs) {
      if (code == 10) {
        points.emplace_back(std::stod(value), 0.0);
        bulges.push_back(0.0);
      }
      if (code == 20) points.back().y() = std::stod(value);
      if (code == 42) bulges.back() = std::stod(value);
    }
  }
  double area() const {
    double sum = 0.0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Vec2& a = points[i];
      const Vec2& b = points[(i + 1) % points.size()];
      sum += 0.5 * (a.x() * b.y() - a.y() * b.x()) + testing::bulge_area(a, b, bulges[i]);
    }
    return sum;
  }
  double length() const {
    double sum = 0.0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double chord = (points[(i + 1) % points.size()] - points[i]).norm();
      const double half = 2 * std::atan(bulges[i]);
      sum += half == 0.0 ? chord : chord * half / std::sin(half);
    }
    return sum;
  }
};

std::vector<ToothedBody> dxf_bodies() {
  return testing::bodies_with(testing::few_tooth_body(1, 5.0, 0.0, 10.0));
}

Drawing dxf_drawing_of(const ToothedBody& body, const ContourOptions& options = {}) {
  const auto drawing = dxf_drawing(body, options);
  EXPECT_TRUE(static_cast<bool>(drawing)) << (drawing ? "" : drawing.error().message());
  return *drawing;
}

TEST(Dxf, AreaOfThePolylineIsThatOfTheGear) {
  for (const ToothedBody& body : dxf_bodies()) {
    for (const double tolerance : {1e-2, 1e-3, 1e-5}) {
      const Drawing drawing = dxf_drawing_of(body, {.tolerance_mm = tolerance});
      EXPECT_LE(drawing.deviation_mm, tolerance);
      const std::vector<Entity> entities = entities_of(drawing.text);
      ASSERT_FALSE(entities.empty());
      ASSERT_EQ(entities[0].type, "LWPOLYLINE");
      EXPECT_EQ(entities[0].layer, "PROFILE");
      EXPECT_EQ(entities[0].words(70), std::vector<std::string>{"1"});  // closed
      const Polyline profile(entities[0]);
      EXPECT_EQ(std::to_string(profile.points.size()), entities[0].words(90).front());
      // If a boundary stays within δ of the exact one, the enclosed areas differ by at most δ times
      // the length of the boundary.
      const double allowed = drawing.deviation_mm * profile.length() + 1e-9;
      EXPECT_NEAR(profile.area(), section_area(body.outline), allowed) << body.name;
    }
  }
}

TEST(Dxf, NeighboursAreTangentWhereTheOutlineIs) {
  // The only corners of a spur gear are at the tip circle, two per tooth.
  const Polyline profile(entities_of(dxf_drawing_of(testing::sample_body({})).text)[0]);
  const std::size_t n = profile.points.size();
  int corners = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2 in = profile.points[(i + 1) % n] - profile.points[i];
    const Vec2 out = profile.points[(i + 2) % n] - profile.points[(i + 1) % n];
    const double turn = std::atan2(in.x() * out.y() - in.y() * out.x(), in.dot(out)) -
                        2 * std::atan(profile.bulges[i]) -
                        2 * std::atan(profile.bulges[(i + 1) % n]);
    if (std::abs(std::remainder(turn, 2 * kPi)) > 1e-8) ++corners;
  }
  EXPECT_EQ(corners, 2 * 20);
}

TEST(Dxf, SegmentsGrowWithTheTeeth) {  // law 2
  const auto segments = [](int teeth, ContourOptions::Style style) {
    return dxf_drawing_of(
               testing::plain_body(teeth, 20.0, 0.6 * kPi / teeth, 24.0, 0.3 * kPi / teeth),
               {.style = style})
        .segments;
  };
  for (const auto style : {ContourOptions::Style::biarcs, ContourOptions::Style::splines}) {
    EXPECT_EQ(segments(30, style), 3 * segments(10, style));
    EXPECT_EQ(segments(1, style), 4);
  }
  EXPECT_EQ(dxf_drawing_of(testing::sample_body({})).segments, 20 * (2 * (6 + 6) + 2));
}

TEST(Dxf, SeveralBodiesStandAtTheirPoses) {
  const ToothedBody first = dxf_bodies()[0];
  ToothedBody second = first;
  second.pose =
      SolidPose(Eigen::Translation3d(100.0, 5.0, 0.0) * Eigen::AngleAxisd(kPi / 2, Vec3::UnitZ()));
  const auto both = dxf_drawing(std::vector<ToothedBody>{first, second});
  ASSERT_TRUE(both);
  EXPECT_EQ(both->segments, 2 * dxf_drawing_of(first).segments);
  std::vector<Entity> profiles;
  for (Entity& e : entities_of(both->text)) {
    if (e.layer == "PROFILE") profiles.push_back(std::move(e));
  }
  ASSERT_EQ(profiles.size(), 2U);
  EXPECT_EQ(profiles[0].words(42), profiles[1].words(42));  // the same bulges
  const std::vector<double> x0 = profiles[0].reals(10);
  const std::vector<double> y0 = profiles[0].reals(20);
  const std::vector<double> x1 = profiles[1].reals(10);
  const std::vector<double> y1 = profiles[1].reals(20);
  for (std::size_t i = 0; i < x0.size(); ++i) {
    EXPECT_NEAR(x1[i], 100.0 - y0[i], 1e-13);
    EXPECT_NEAR(y1[i], 5.0 + x0[i], 1e-13);
  }
}

TEST(Dxf, SameBodySameBytes) {  // law 1
  for (const auto style : {ContourOptions::Style::biarcs, ContourOptions::Style::splines}) {
    EXPECT_EQ(dxf_drawing_of(dxf_bodies()[1], {.style = style}).text,
              dxf_drawing_of(dxf_bodies()[1], {.style = style}).text);
  }
}

TEST(Dxf, SplinesShareTheirEndsAsText) {
  for (const ToothedBody& body : dxf_bodies()) {
    const Drawing drawing = dxf_drawing_of(body, {.style = ContourOptions::Style::splines});
    EXPECT_LE(drawing.deviation_mm, 1e-6);
    std::vector<Entity> profile;
    for (Entity& e : entities_of(drawing.text)) {
      if (e.layer == "PROFILE") profile.push_back(std::move(e));
    }
    ASSERT_FALSE(profile.empty());
    for (std::size_t i = 0; i < profile.size(); ++i) {
      const Entity& a = profile[i];
      const Entity& b = profile[(i + 1) % profile.size()];
      ASSERT_EQ(a.type, "SPLINE");
      EXPECT_EQ(a.words(10).back(), b.words(10).front());
      EXPECT_EQ(a.words(20).back(), b.words(20).front());
      if (a.reals(70).front() == 12) {
        // A land is a rational curve whose points all lie on its circle.
        const std::vector<double> weights = a.reals(41);
        const std::vector<double> x = a.reals(10);
        const std::vector<double> y = a.reals(20);
        ASSERT_EQ(weights.size(), x.size());
        const double r = std::hypot(x[0], y[0]);
        for (std::size_t k = 0; k + 2 < x.size(); k += 2) {
          for (double t = 0.0; t <= 1.0; t += 0.125) {
            const double b0 = (1 - t) * (1 - t);
            const double b1 = 2 * t * (1 - t) * weights[k + 1];
            const double b2 = t * t;
            const double w = b0 + b1 + b2;
            EXPECT_NEAR(std::hypot(b0 * x[k] + b1 * x[k + 1] + b2 * x[k + 2],
                                   b0 * y[k] + b1 * y[k + 1] + b2 * y[k + 2]) /
                            w,
                        r, 1e-13 * r);
          }
        }
      }
      if (a.type == "SPLINE") {
        const std::vector<double> knots = a.reals(40);
        EXPECT_EQ(knots.size(), a.words(10).size() + static_cast<std::size_t>(a.reals(71)[0]) + 1);
        EXPECT_EQ(knots.front(), 0.0);
        EXPECT_EQ(knots.back(), 1.0);
        EXPECT_TRUE(std::is_sorted(knots.begin(), knots.end()));
      }
    }
  }
}

TEST(Dxf, BoreAndKeyway) {
  for (const ToothedBody& body : dxf_bodies()) {
    const std::vector<Entity> entities = entities_of(dxf_drawing_of(body).text);
    ASSERT_EQ(entities.size(), body.bore ? 2U : 1U);
    if (!body.bore) continue;
    EXPECT_EQ(entities[1].layer, "BORE");
    if (body.bore->keyway_width == 0.0) {
      EXPECT_EQ(entities[1].type, "CIRCLE");
      EXPECT_EQ(entities[1].reals(40), std::vector<double>{body.bore->diameter / 2});
      continue;
    }
    const Polyline bore(entities[1]);
    EXPECT_EQ(entities[1].words(70), std::vector<std::string>{"1"});
    EXPECT_NEAR(bore.area(), bore_area(*body.bore), 1e-12 * bore.area());
    double top = 0.0;
    for (const Vec2& p : bore.points) top = std::max(top, p.y());
    EXPECT_EQ(top, 8.0 + 2.3);
  }
}

TEST(Dxf, EveryHandleIsUsedOnceAndTheSeedIsAboveThem) {
  for (const auto style : {ContourOptions::Style::biarcs, ContourOptions::Style::splines}) {
    const std::vector<DxfGroup> pairs =
        pairs_of(dxf_drawing_of(dxf_bodies()[0], {.style = style}).text);
    std::set<unsigned long> handles;
    std::set<unsigned long> wanted;
    unsigned long seed = 0;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      const auto number = [&] { return std::stoul(pairs[i].second, nullptr, 16); };
      if (i > 0 && pairs[i - 1].second == "$HANDSEED") {
        seed = number();
      } else if (pairs[i].first == 5 || pairs[i].first == 105) {
        EXPECT_TRUE(handles.insert(number()).second) << pairs[i].second;
      } else if (pairs[i].first == 330 || pairs[i].first == 340 || pairs[i].first == 350 ||
                 pairs[i].first == 390) {
        wanted.insert(number());
      }
    }
    ASSERT_FALSE(handles.empty());
    EXPECT_GT(seed, *handles.rbegin());
    wanted.erase(0);
    for (const unsigned long h : wanted) EXPECT_EQ(handles.count(h), 1U) << std::hex << h;
    EXPECT_EQ(pairs.back(), (DxfGroup{0, "EOF"}));
  }
}

TEST(Dxf, RefusesWhatIsNoGear) {
  ToothedBody body = testing::sample_body({});
  // The root diameter is 35 mm. The last bore is smaller, but its keyway extends beyond the root.
  body.bore = Bore{34.9};
  EXPECT_TRUE(static_cast<bool>(dxf_drawing(body)));
  body.bore = Bore{35.1};
  const auto wide = dxf_drawing(body);
  ASSERT_FALSE(wide);
  EXPECT_NE(wide.error().field.find("bore.diameter"), std::string::npos);
  body.bore = Bore{34.0, 8.0, 3.0};
  EXPECT_FALSE(dxf_drawing(body));
  ToothedBody ring = testing::ring_body(40, 2.0, 0.0, 10.0, 84.0);
  EXPECT_FALSE(dxf_drawing(ring));
  EXPECT_FALSE(dxf_drawing(testing::plain_body(12, 20.0, -0.02, 24.0, 0.05)));
}

TEST(Dxf, SaysWhatToleranceItCanKeep) {
  // No curve in double precision is accurate to 1e-18 mm.
  const auto drawing = dxf_drawing(testing::sample_body({}), {.tolerance_mm = 1e-18});
  ASSERT_FALSE(drawing);
  EXPECT_EQ(drawing.error().field, "tolerance_mm");
  EXPECT_NE(drawing.error().message().find("root_fillet"), std::string::npos);
}

}  // namespace
}  // namespace gearwright
