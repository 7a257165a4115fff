#include "gearwright/job/testing/clear_sheet.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace gearwright::testing {

namespace {

bool meet(const SheetBox& a, const SheetBox& b) {
  constexpr double kTouch = 0.01;  // mm, because an index may touch its letter
  return a.lo.x() < b.hi.x() - kTouch && b.lo.x() < a.hi.x() - kTouch &&
         a.lo.y() < b.hi.y() - kTouch && b.lo.y() < a.hi.y() - kTouch;
}

// True if a piece of a line lies in the box. The piece is halved until the half lies inside, or
// until the bounding box of the half is separate from the box.
bool crosses(const Vec2& a, const Vec2& b, const SheetBox& box) {
  const Vec2 lo = a.cwiseMin(b), hi = a.cwiseMax(b);
  if ((lo.array() >= box.hi.array()).any() || (hi.array() <= box.lo.array()).any()) return false;
  if ((b - a).norm() < 0.02) return true;
  const Vec2 middle = (a + b) / 2;
  return crosses(a, middle, box) || crosses(middle, b, box);
}

// Returns the points of a path in which chords of 0.05 rad replace arcs.
std::vector<Vec2> chords(const SheetPath& path) {
  std::vector<Vec2> points{path.points.front()};
  for (std::size_t i = 0; i < path.bulges.size(); ++i) {
    const Vec2 a = path.points[i], b = path.points[(i + 1) % path.points.size()];
    const double bulge = path.bulges[i], sweep = 4 * std::atan(bulge);
    const int n = 1 + static_cast<int>(std::abs(sweep) / 0.05);
    const Vec2 chord = b - a, left(-chord.y(), chord.x());
    const Vec2 center =
        bulge == 0 ? a : Vec2((a + b) / 2 + left * (1 - bulge * bulge) / (4 * bulge));
    for (int k = 1; k < n; ++k) {
      const double t = sweep * k / n;
      const Vec2 r = a - center;
      points.push_back(center + Vec2(std::cos(t) * r.x() - std::sin(t) * r.y(),
                                     std::sin(t) * r.x() + std::cos(t) * r.y()));
    }
    points.push_back(b);
  }
  return points;
}

}  // namespace

void expect_clear(const Sheet& sheet, const std::string& what) {
  ASSERT_GT(sheet.texts.size(), 10u) << what;
  std::vector<SheetBox> boxes;
  for (const SheetText& t : sheet.texts) boxes.push_back(box_of(t));
  std::vector<std::vector<Vec2>> lines;
  for (const SheetPath& p : sheet.paths) lines.push_back(chords(p));
  for (const SheetCircle& c : sheet.circles) {
    const Vec2 r(c.radius, 0);
    lines.push_back(chords({c.layer, {c.center - r, c.center + r}, {1, 1}, true}));
  }
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const std::string& words = sheet.texts[i].text;
    EXPECT_GE(boxes[i].lo.minCoeff(), 10.0) << what << ": " << words;
    EXPECT_LE(boxes[i].hi.x(), sheet.size.x() - 10) << what << ": " << words;
    EXPECT_LE(boxes[i].hi.y(), sheet.size.y() - 10) << what << ": " << words;
    for (std::size_t k = 0; k < i; ++k)
      EXPECT_FALSE(meet(boxes[i], boxes[k]))
          << what << ": " << words << " on " << sheet.texts[k].text;
    for (std::size_t k = 0; k < lines.size(); ++k) {
      bool hit = false;
      for (std::size_t j = 0; !hit && j + 1 < lines[k].size(); ++j)
        hit = crosses(lines[k][j], lines[k][j + 1], boxes[i]);
      EXPECT_FALSE(hit) << what << ": a line through " << words << " at "
                        << boxes[i].lo.transpose();
    }
  }
}

}  // namespace gearwright::testing
