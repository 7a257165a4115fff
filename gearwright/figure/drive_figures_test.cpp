#include "gearwright/figure/drive_figures.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

#include "gearwright/cad/figure_files.hpp"
#include "gearwright/drive/short_forms.hpp"
#include "gearwright/figure/figure_svg.hpp"

namespace gearwright {
namespace {

using M = SetMember;

Drive made(const std::vector<std::pair<M, int>>& teeth, const std::string& held,
           const std::string& in, const std::string& out) {
  PlanetarySpec set;
  for (const auto& [member, z] : teeth) set.z(member) = z;
  set.planets = 3;
  set.fixed = {{held}};
  set.inputs = {in};
  set.output = out;
  set.efficiency.all = 0.99;
  set.speeds_rpm = {1500};
  set.torque_Nm = 40;
  auto drive = make_drive({*graph_of(set), {}});
  EXPECT_TRUE(drive) << drive.error().message();
  return std::move(drive).take();
}

std::vector<Drive> drives() {
  return {made({{M::sun, 20}, {M::planet, 25}, {M::ring, 70}}, "ring", "sun", "carrier"),
          made({{M::sun, 20}, {M::planet, 25}, {M::ring, 70}}, "carrier", "ring", "sun"),
          made({{M::planet, 21}, {M::ring, 57}, {M::ring2, 60}}, "ring", "carrier", "ring2"),
          made({{M::sun, 12}, {M::planet, 24}, {M::planet2, 21}, {M::ring, 60}, {M::ring2, 57}},
               "ring", "sun", "ring2"),
          made({{M::sun, 28}, {M::idler, 22}, {M::planet, 22}, {M::sun2, 38}, {M::ring, 82}},
               "carrier", "sun", "ring")};
}

void expect_inside(const Figure& figure) {
  for (const FigureMark& mark : figure.marks)
    for (const Vec2& p : mark.points) {
      if (std::isnan(p.x())) continue;
      EXPECT_GE(p.x(), figure.x.lo) << figure.id << mark.style << mark.words;
      EXPECT_LE(p.x(), figure.x.hi) << figure.id << mark.style << mark.words;
      EXPECT_GE(p.y(), figure.y.lo) << figure.id << mark.style << mark.words;
      EXPECT_LE(p.y(), figure.y.hi) << figure.id << mark.style << mark.words;
    }
}

// The lines of words are at most 14 px above and 4 px below their points. `width` is the width of
// the picture, px.
void expect_words_inside(const Figure& figure, double width) {
  const double per_px = (figure.x.hi - figure.x.lo) / (width - 24.0);
  for (const FigureMark& mark : figure.marks) {
    if (mark.kind != FigureMark::Kind::text) continue;
    const double y = mark.points.front().y() - mark.offset.y() * per_px;  // offsets point down
    EXPECT_LE(y + 14.0 * per_px, figure.y.hi) << mark.words << " at " << width;
    EXPECT_GE(y - 4.0 * per_px, figure.y.lo) << mark.words << " at " << width;
  }
}

TEST(DriveFigures, SchemesNameAllGearsAndGroundWhatIsHeld) {
  for (const Drive& drive : drives()) {
    const auto places = drive_places(drive);
    ASSERT_TRUE(places) << places.error().message();
    EXPECT_FALSE(places->true_scale);  // there is no module
    const Figure figure = scheme_figure(drive, *places, 640.0);
    expect_inside(figure);
    int grounds = 0;
    for (const FigureMark& mark : figure.marks) grounds += mark.style == "ground";
    EXPECT_GT(grounds, 0);
    for (const DriveGear& gear : drive.graph.gears) {
      int named = 0;
      for (const FigureMark& mark : figure.marks)
        named += mark.text().find(gear.name + " " + std::to_string(std::abs(gear.teeth))) !=
                 std::string::npos;
      EXPECT_EQ(named, 1) << gear.name;
    }
  }
}

// "loss 0.89 %" → 0.0089
double share_after(const std::string& words, const std::string& word) {
  if (!words.starts_with(word)) return 0.0;
  return std::strtod(words.c_str() + word.size(), nullptr) / 100;
}

TEST(DriveFigures, NoLineCrossesTheNameOfAGear) {
  for (const Drive& drive : drives()) {
    const Sheet sheet =
        picture_sheet(figure_svg(scheme_figure(drive, *drive_places(drive), 640.0), 640.0), {1.0});
    std::vector<SheetText> names;
    for (const SheetText& text : sheet.texts)
      for (const DriveGear& gear : drive.graph.gears)
        if (text.ink->fill &&
            text.text.ends_with(gear.name + " " + std::to_string(std::abs(gear.teeth))))
          names.push_back(text);
    EXPECT_GE(names.size(), drive.graph.gears.size());
    for (const SheetText& name : names) {
      const SheetBox box = box_of(name);
      for (const SheetPath& path : sheet.paths)
        for (std::size_t i = 1; i < path.points.size(); ++i)
          for (int k = 0; k <= 1000; ++k) {
            const Vec2 p = path.points[i - 1] + k / 1000.0 * (path.points[i] - path.points[i - 1]);
            const bool inside = p.x() > box.lo.x() && p.x() < box.hi.x() && p.y() > box.lo.y() &&
                                p.y() < box.hi.y();
            ASSERT_FALSE(inside) << name.text << " on " << path.ink->name;
          }
    }
  }
}

TEST(DriveFigures, LossesAreWhatTheOutputLacks) {
  for (const Drive& drive : drives()) {
    const auto figure = power_figure(drive);
    ASSERT_TRUE(figure);
    expect_inside(*figure);
    double in = 0.0, out = 0.0, lost = 0.0;
    for (const FigureMark& mark : figure->marks) {
      in += share_after(mark.words, "in ");
      out += share_after(mark.words, "out ");
      lost += share_after(mark.words, "loss ");
    }
    EXPECT_NEAR(in, 1.0, 1e-3);
    EXPECT_NEAR(out, drive.flow->efficiency, 1e-3);
    EXPECT_NEAR(in - out, lost, 2e-3);
  }
}

TEST(DriveFigures, CurvesUnderLoadLieWithinTheAxes) {
  Drive drive = drives().front();
  for (const double varies : {0.0, 0.2}) {
    LoadedDrive loaded;
    loaded.curves.push_back({70.0 / 4.5, {1e-5, -1e-5 * varies, 0.0}, {0.0, 0.0, 0.0}});
    PlanetShares shares;
    shares.share = {{0.3, 0.3 + varies, 0.3}, {0.3, 0.3, 0.3}, {0.4, 0.4 - varies, 0.4}};
    shares.mesh_load_factors = {{0, 1.5}};
    shares.greatest_displacement = 0.2;
    shares.floating = 0;
    shares.displacement = {Vec2(0.0, 0.09), Vec2(varies, 0.0), Vec2(0.0, -varies)};
    loaded.sets.push_back(shares);
    drive.loaded = loaded;
    const Figure share = planet_share_figure(drive, 0);
    expect_inside(share);
    EXPECT_EQ(share.keys.size(), 3u);
    EXPECT_EQ(share.note, "K_γ = 1.500");
    EXPECT_NEAR(share.x.hi, 360 * 4.5 / 70, 1e-9);
    const auto displacement = displacement_figure(drive, 0);
    ASSERT_TRUE(displacement);
    expect_inside(*displacement);
    expect_inside(loaded_output_figure(drive, 0));
  }
  drive.loaded->sets.front().floating.reset();
  EXPECT_FALSE(displacement_figure(drive, 0));
}

// A rack is drawn at the end of the pitch circle of its pinion, either above the pinion or below
// it. The words of the rack are beyond its back.
TEST(DriveFigures, ASchemeOfARackHasItsBarAndItsWords) {
  for (const double module : {0.0, 2.0}) {
    for (const double direction : {0.0, 3.0}) {
      CylindricalSpec spec;
      spec.normal_module = module;
      DriveGraph graph;
      graph.bodies = {{"shaft", {}, 1, {}}, {"bar", {}, 1, {}}};
      graph.gears = {{"p", 0, 20, {}, {}, {}}, {"r", 1, 0, RackBar{.teeth = 30}, {}, {}}};
      if (module > 0.0) graph.gears.front().spec = spec;
      graph.meshes = {{"p_r", {0, 1}, 0.98, {}}};
      graph.meshes.front().direction = Angle::radians(direction);
      graph.inputs = {0};
      graph.output = 1;
      graph.speeds_rpm = {60};
      graph.torque_Nm = 10;
      const auto drive = make_drive({graph, {}});
      ASSERT_TRUE(drive) << drive.error().message();
      const auto places = drive_places(*drive);
      ASSERT_TRUE(places) << places.error().message();
      for (const double width : {640.0, 300.0})
        expect_words_inside(scheme_figure(*drive, *places, width), width);
      const Figure figure = scheme_figure(*drive, *places, 640.0);
      expect_inside(figure);
      double pinion = 0.0, rack = 0.0;
      int words = 0, speeds = 0;
      for (const FigureMark& mark : figure.marks) {
        const double y = mark.points.front().y();
        if (mark.style == "bar-stick b1") rack = y;
        if (mark.style == "bar-stick b0" && y * (direction < 1.0 ? 1 : -1) > 0.0) pinion = y;
        if (mark.text() == "bar out") {
          ++words;
          EXPECT_GT(std::abs(y), std::abs(rack));
        }
        speeds += mark.text() == (module > 0.0 ? "0.1257 m/s" : "20 pitches per turn");
      }
      EXPECT_NEAR(std::abs(rack) - std::abs(pinion), 0.1, 1e-9);
      EXPECT_GT(rack * pinion, 0.0);
      EXPECT_EQ(words, 1);
      EXPECT_EQ(speeds, 1);
    }
  }
}

}  // namespace
}  // namespace gearwright
