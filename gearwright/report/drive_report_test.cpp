// Laws: (1) in the section of a drive, the drawn shapes of rack and pinion overlap at no position
// of the control; (2) they overlap if the rack moves 2 % further than drawn.
#include "gearwright/report/drive_report.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <tuple>

#include "gearwright/base/testing/taken.hpp"
#include "gearwright/base/units.hpp"
#include "gearwright/figure/gear_shape.hpp"
#include "gearwright/figure/rack_mesh.hpp"

namespace gearwright {
namespace {

Drive pinion_and_rack(int teeth, int rack_teeth, double beta_deg, double direction) {
  CylindricalSpec spec;
  spec.normal_module = 2.0;
  spec.helix_angle = Angle::degrees(beta_deg);
  spec.face_width = 20.0;
  spec.thickness_allowance = -0.04;
  DriveGraph graph;
  graph.bodies = {{"shaft", {}, 1, {}}, {"bar", {}, 1, {}}};
  graph.gears = {{"pinion", 0, teeth, {}, spec, 0.2},
                 {"rack", 1, 0, RackBar{.teeth = rack_teeth}, {}, {}}};
  graph.meshes = {{"mesh", {0, 1}, {}, {}}};
  graph.meshes.front().direction = Angle::radians(direction);
  graph.inputs = {0};
  graph.output = 1;
  return testing::taken(make_drive({graph, {}}));
}

// The numbers after `name` in a tag, up to the next character that is no part of a number.
std::vector<double> numbers_after(const std::string& tag, const std::string& name) {
  std::vector<double> list;
  const std::size_t at = tag.find(name);
  if (at == std::string::npos) return list;
  const char* p = tag.c_str() + at + name.size();
  for (char* end = nullptr;; p = end) {
    const double x = std::strtod(p, &end);
    if (end == p) return list;
    list.push_back(x);
  }
}

// A shape of a picture as the page shows it: its outline in path units, and its motion.
struct DrawnShape {
  std::vector<Vec2> points;
  Vec2 at, travel = Vec2::Zero();
  double scale, turned, turn = 0.0;

  std::vector<Vec2> shown(double t, double further = 1.0) const {
    const Eigen::Rotation2Dd r((turned + turn * t) / kDegPerRad);
    std::vector<Vec2> moved;
    for (const Vec2& p : points)
      moved.push_back(at + further * t * travel + scale * (r * Vec2(p.x(), -p.y())));
    return moved;
  }
};

DrawnShape shape_in(const std::string& page, const std::string& name, const std::vector<Vec2>& mm,
                    double unit_mm) {
  DrawnShape shape;
  const std::size_t at = page.find("href=\"#" + name + "\"");
  EXPECT_NE(at, std::string::npos) << name;
  const std::string tag = page.substr(at, page.find("/>", at) - at);
  for (const Vec2& p : mm) shape.points.push_back(p / unit_mm);
  const auto place = numbers_after(tag, "translate(");
  shape.at = {place.at(0), place.at(1)};
  shape.scale = numbers_after(tag, "scale(").at(0);
  shape.turned = numbers_after(tag, "rotate(").at(0);
  if (const auto turn = numbers_after(tag, "data-turn=\""); !turn.empty()) shape.turn = turn[0];
  if (const auto travel = numbers_after(tag, "data-travel=\""); !travel.empty())
    shape.travel = {travel.at(0), travel.at(1)};
  return shape;
}

// The chords are within 1 µm of the outline. The play at each flank is about 20 µm.
std::vector<Vec2> outline_of(const Gear& gear) {
  std::vector<Vec2> half, all;
  for (const Arc& arc : gear.tooth->outline.arcs)
    for (const Vec2& p : chords(arc, 1e-3)) half.push_back(p);
  for (int k = 0; k < gear.spec.teeth; ++k) {
    const Eigen::Rotation2Dd r(kTurn * k / gear.spec.teeth);
    for (const Vec2& p : half) all.push_back(r * Vec2(p.x(), -p.y()));
    for (auto p = half.rbegin(); p != half.rend(); ++p) all.push_back(r * *p);
  }
  return all;
}

// Polygons as lists x, y, x, y …: tests are not optimised, so their loops use plain doubles.
std::vector<double> coordinates_of(const std::vector<Vec2>& polygon) {
  std::vector<double> list;
  for (const Vec2& p : polygon) list.insert(list.end(), {p.x(), p.y()});
  return list;
}

bool inside(double x, double y, const std::vector<double>& polygon) {
  bool in = false;
  const double* const end = polygon.data() + polygon.size();
  const double* b = end - 2;
  for (const double* a = polygon.data(); a != end; b = a, a += 2)
    if ((a[1] > y) != (b[1] > y) && x < (b[0] - a[0]) * (y - a[1]) / (b[1] - a[1]) + a[0]) in = !in;
  return in;
}

// True if a point of the rack is inside the pinion, or if a point of the pinion is inside the rack.
bool shapes_overlap(const std::vector<double>& pinion, const Vec2& axis,
                    const std::vector<double>& rack) {
  const auto away = [x = axis.x(), y = axis.y()](const double* p) {
    return std::sqrt((p[0] - x) * (p[0] - x) + (p[1] - y) * (p[1] - y));
  };
  double reach = 0.0;
  for (std::size_t i = 0; i < pinion.size(); i += 2) reach = std::max(reach, away(&pinion[i]));
  double nearest = reach;
  for (std::size_t i = 0; i < rack.size(); i += 2) {
    const double distance = away(&rack[i]);
    nearest = std::min(nearest, distance);
    if (distance < reach && inside(rack[i], rack[i + 1], pinion)) return true;
  }
  for (std::size_t i = 0; i < pinion.size(); i += 2)
    if (away(&pinion[i]) > nearest && inside(pinion[i], pinion[i + 1], rack)) return true;
  return false;
}

TEST(DriveReport, ADrawnRackMeshesWithItsPinionAtAllTimes) {
  constexpr int kSteps = 120;
  for (const auto& [teeth, rack_teeth, beta, direction] :
       {std::tuple{17, 30, 0.0, 0.0}, {20, 31, 25.0, 2.0}, {9, 26, -25.0, -1.5}}) {
    const Drive drive = pinion_and_rack(teeth, rack_teeth, beta, direction);
    const RackPair& pair = *drive.geometry.racks[0];
    const std::string page =
        drive_section_figures(drive, testing::taken(drive_layout(drive)), UnitSystem::mm);
    const double unit = outline_unit_mm(pair.pinion);
    const DrawnShape pinion = shape_in(page, "gear1", outline_of(*drive.geometry.gears[0]), unit);
    const DrawnShape rack = shape_in(page, "gear2", testing::taken(rack_section(pair)), unit);
    EXPECT_GT(rack.travel.norm(), 0.0);
    EXPECT_NE(page.find("data-sways"), std::string::npos);
    bool too_far = false;
    for (int step = 0; step <= kSteps; ++step) {
      const double t = static_cast<double>(step) / kSteps - 0.5;
      const auto drawn = coordinates_of(pinion.shown(t));
      EXPECT_FALSE(shapes_overlap(drawn, pinion.at, coordinates_of(rack.shown(t))))
          << teeth << " at " << t;
      too_far = too_far || shapes_overlap(drawn, pinion.at, coordinates_of(rack.shown(t, 1.02)));
    }
    EXPECT_TRUE(too_far) << teeth;
  }
}

// The pinion stays within the middle half of the rack, so the pinion never leaves the rack.
TEST(DriveReport, ARackMovesByAtMostHalfItsLength) {
  for (const int rack_teeth : {1, 2, 30, 400}) {
    const Drive drive = pinion_and_rack(20, rack_teeth, 0.0, 0.0);
    const RackPair& pair = *drive.geometry.racks[0];
    const std::string page =
        drive_section_figures(drive, testing::taken(drive_layout(drive)), UnitSystem::mm);
    const DrawnShape rack = shape_in(page, "gear2", {}, 1.0);
    const double px_per_mm = rack.scale / outline_unit_mm(pair.pinion);
    EXPECT_NEAR(rack.travel.norm() / px_per_mm,
                std::min(pair.travel_per_turn, *pair.rack.length() / 2), 1e-4)
        << rack_teeth;
  }
}

}  // namespace
}  // namespace gearwright
