#include "gearwright/cad/svg_outline.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <sstream>

#include "gearwright/base/numbers.hpp"
#include "gearwright/cad/section.hpp"
#include "gearwright/cad/testing/odd_outlines.hpp"
#include "gearwright/cad/testing/sample_outlines.hpp"

namespace gearwright {
namespace {

using testing::C;

struct Subpath {
  double area = 0.0;    // mm², positive if counter-clockwise with y upwards
  double length = 0.0;  // mm; for curves, the length of the control polygon
  C begin, end;
  int arcs = 0, cubics = 0, lines = 0;
};

std::string attribute(const std::string& text, const std::string& name) {
  const std::size_t at = text.find(" " + name + "=\"") + name.size() + 3;
  return text.substr(at, text.find('"', at) - at);
}

// Reads the d attribute as a renderer does. The area is computed by Green's theorem, exactly for
// arcs and cubics.
std::vector<Subpath> subpaths_of(const std::string& text) {
  std::vector<Subpath> paths;
  std::istringstream in(attribute(text, "d"));
  for (std::string line; std::getline(in, line);) {
    if (line.empty()) continue;
    if (line == "Z") {
      paths.back().area += 0.5 * (std::conj(paths.back().end) * paths.back().begin).imag();
      continue;
    }
    std::istringstream numbers(line.substr(1));
    std::vector<double> v;
    for (double x; numbers >> x;) v.push_back(x);
    const auto point = [&](std::size_t i) { return C(v[i], -v[i + 1]); };
    if (line[0] == 'M') {
      paths.push_back({});
      paths.back().begin = paths.back().end = point(0);
      continue;
    }
    Subpath& path = paths.back();
    const C from = path.end;
    const C to = point(v.size() - 2);
    path.area += 0.5 * (std::conj(from) * to).imag();
    path.length += std::abs(to - from);
    if (line[0] == 'A') {
      EXPECT_EQ(v[0], v[1]);
      EXPECT_EQ(v[4], 0.0);  // counter-clockwise
      const double half = std::asin(std::min(1.0, std::abs(to - from) / (2 * v[0])));
      const double sweep = v[3] != 0.0 ? 2 * (kPi - half) : 2 * half;
      path.area += 0.5 * v[0] * v[0] * (sweep - std::sin(sweep));
      path.length += v[0] * sweep;
      ++path.arcs;
    } else if (line[0] == 'C') {
      // ½ ∫ C × dC from the start of the cubic: 3/20 (a×b + a×d + 2 b×d).
      const C a = point(0) - from, b = point(2) - from, d = to - from;
      const auto cross = [](C p, C q) { return (std::conj(p) * q).imag(); };
      path.area += 3.0 / 20.0 * (cross(a, b) + cross(a, d) + 2 * cross(b, d));
      ++path.cubics;
    } else {
      ++path.lines;
    }
    path.end = to;
  }
  return paths;
}

Drawing svg_drawing_of(const ToothedBody& body, const SvgOptions& options = {}) {
  const auto drawing = svg_drawing(body, options);
  EXPECT_TRUE(static_cast<bool>(drawing)) << (drawing ? "" : drawing.error().message());
  return *drawing;
}

TEST(Svg, AreaIsThatOfTheGear) {
  for (const ToothedBody& body :
       testing::bodies_with(testing::plain_body(1, 10.0, 1.0, 14.0, 0.8))) {
    for (const double tolerance : {1e-3, 1e-4, 1e-6}) {
      const Drawing drawing = svg_drawing_of(body, {.tolerance_mm = tolerance});
      EXPECT_LE(drawing.deviation_mm, tolerance);
      const std::vector<Subpath> paths = subpaths_of(drawing.text);
      ASSERT_EQ(paths.size(), body.bore ? 2U : 1U);
      const double exact = section_area(body.outline);
      // Rounding to ten decimals moves a boundary point by at most 1e-10 mm.
      EXPECT_NEAR(paths[0].area, exact, (drawing.deviation_mm + 2e-10) * paths[0].length)
          << body.name;
      if (body.bore) {
        EXPECT_NEAR(paths[1].area, bore_area(*body.bore), 1e-9 * paths[1].length);
      }
      int segments = 0;
      for (const Subpath& p : paths) {
        EXPECT_EQ(p.begin, p.end) << body.name;
        segments += p.arcs + p.cubics + p.lines;
      }
      EXPECT_EQ(segments, drawing.segments);
    }
  }
}

TEST(Svg, LandsAreArcs) {
  const std::vector<Subpath> spur = subpaths_of(svg_drawing_of(testing::sample_body({})).text);
  EXPECT_EQ(spur[0].arcs, 2 * 20);
  EXPECT_EQ(spur[0].cubics, 2 * 20 * (5 + 5));
  const std::vector<Subpath> sharp = subpaths_of(
      svg_drawing_of(testing::sample_body({.pointed = true, .full_radius_root = true})).text);
  EXPECT_EQ(sharp[0].arcs, 0);
}

TEST(Svg, SizeIsInMillimetres) {
  const Drawing drawing = svg_drawing_of(testing::sample_body({}));  // d_a = 44
  EXPECT_EQ(attribute(drawing.text, "width"), "46.200000mm");
  EXPECT_EQ(attribute(drawing.text, "height"), "46.200000mm");
  EXPECT_EQ(attribute(drawing.text, "viewBox"), "-23.100000 -23.100000 46.200000 46.200000");
  EXPECT_EQ(attribute(drawing.text, "fill-rule"), "evenodd");
}

TEST(Svg, NameIsText) {
  ToothedBody body = testing::sample_body({});
  body.name = "a < b & c";
  EXPECT_NE(svg_drawing_of(body).text.find("<title>a &lt; b &amp; c</title>"), std::string::npos);
}

TEST(Svg, RefusesWhatIsNoGear) {
  ToothedBody body = testing::sample_body({});
  body.bore = Bore{36.0};
  EXPECT_FALSE(svg_drawing(body));
  EXPECT_FALSE(svg_drawing(testing::plain_body(12, 20.0, -0.02, 24.0, 0.05)));
  const auto drawing = svg_drawing(testing::sample_body({}), {.tolerance_mm = 1e-18});
  ASSERT_FALSE(drawing);
  EXPECT_EQ(drawing.error().field, "tolerance_mm");
}

}  // namespace
}  // namespace gearwright
