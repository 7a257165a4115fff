#include "gearwright/cad/sheet_callouts.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace gearwright {
namespace {

bool overlap(const SheetBox& a, const SheetBox& b) {
  return a.lo.x() < b.hi.x() && b.lo.x() < a.hi.x() && a.lo.y() < b.hi.y() && b.lo.y() < a.hi.y();
}

bool crosses_box(const SheetBox& box, double y, double a, double b) {
  return overlap({{std::min(a, b), y}, {std::max(a, b), y + 1e-9}}, box);
}

struct RandomSection {
  AxialSection section;
  SurfaceRequirements required;
};

RandomSection random_section(std::mt19937& random) {
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  const double body = std::exp(std::log(2.0) + unit(random) * std::log(60.0));  // 2 to 120 mm
  const double depth = body * (0.01 + 0.2 * unit(random)), width = body * (0.05 + 2 * unit(random));
  AxialSection s{unit(random) < 0.3, width, width, body, body, body - depth, std::nullopt};
  if (s.ring) {
    s.tip = body - 2 * depth;
    s.reference = body - 1.5 * depth;
  } else if (unit(random) < 0.7) {
    const double r = (body - 2 * depth) * (0.05 + 0.8 * unit(random));
    s.bore = r;
    const bool outside = 2 * r < 12;
    s.on_left.push_back({-14.5, -r - (outside ? 18 : 9.5), r + (outside ? 9.5 : 1.5)});
    if (unit(random) < 0.5)
      s.on_left.push_back({-22.5, -r - (outside ? 18 : 1.5), 1.2 * r + (outside ? 6 : 1.5)});
  } else {
    s.on_left.push_back({-9.5, -9.5, 0});
  }
  const auto texture = [&]() -> std::optional<std::string> {
    const double u = unit(random);
    if (u < 0.2) return std::nullopt;
    return u < 0.5 ? "" : u < 0.8 ? "MRR Ra 0.8" : "0.008-0.8/Rz 12.5 max";
  };
  return {s,
          {texture(), texture(), texture(), unit(random) < 0.5 ? "" : "0.012",
           unit(random) < 0.5 ? "" : "0.00125"}};
}

TEST(SheetCallouts, keep_apart) {
  std::mt19937 random(20261127);
  for (int n = 0; n < 20000; ++n) {
    const auto [s, required] = random_section(random);
    const Callouts callouts(s, required);
    const std::vector<SheetBox> boxes = callouts.boxes();
    EXPECT_EQ(boxes.size(), 2u + required.flank_texture.has_value() +
                                (required.bore_texture.has_value() && s.bore.has_value()));
    const std::string what = "section " + std::to_string(n);
    std::vector<SheetBox> taken{{{0, -s.body}, {s.width, s.body}}};
    for (const OccupiedSpace& o : s.on_left) taken.push_back({{o.left, o.lo}, {-7.5, o.hi}});
    const double centre = -callouts.distance();  // of the transverse view
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      for (std::size_t k = 0; k < i; ++k) EXPECT_FALSE(overlap(boxes[i], boxes[k])) << what;
      for (const SheetBox& box : taken) EXPECT_FALSE(overlap(boxes[i], box)) << what;
      EXPECT_LE(boxes[i].hi.y(), callouts.top() + 1e-9) << what;
      EXPECT_LE(boxes[i].hi.x(), s.width + callouts.right() + 1e-9) << what;
      if (boxes[i].hi.x() >= 0) continue;
      const Vec2 view(centre, 0);
      const Vec2 nearest = view.cwiseMax(boxes[i].lo).cwiseMin(boxes[i].hi);
      EXPECT_GE((nearest - view).norm(), s.body - 1e-9) << what;
    }
    if (::testing::Test::HasFailure()) return;
  }
}

TEST(SheetCallouts, leader_of_the_faces_keeps_off_dimensions) {
  std::mt19937 random(20261128);
  for (int n = 0; n < 20000; ++n) {
    const auto [s, required] = random_section(random);
    const std::vector<SheetBox> boxes = Callouts(s, required).boxes();
    const SheetBox& faces = boxes[1];
    if (faces.lo.x() > 0) continue;
    for (const OccupiedSpace& o : s.on_left)
      EXPECT_FALSE(crosses_box({{o.left, o.lo}, {0, o.hi}}, faces.lo.y() + 2.5, faces.hi.x(), 0));
    if (::testing::Test::HasFailure()) return;
  }
}

}  // namespace
}  // namespace gearwright
