#include "gearwright/figure/rack_mesh.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "gearwright/base/units.hpp"
#include "gearwright/figure/gear_shape.hpp"
#include "gearwright/figure/markup.hpp"
#include "gearwright/math/involute.hpp"

namespace gearwright {

namespace {

double pitch_radius(const RackPair& pair) { return pair.pinion.reference_diameter / 2; }

double alpha_of(const RackPair& pair) { return pair.pinion.reference().transverse_pressure_angle; }

// Returns a point of the line of action at the distance g from the pitch point. If `side` is −1,
// the point is on the line of action of the trailing flanks.
Vec2 on_action(const RackPair& pair, double g, double side = 1.0) {
  return {pitch_radius(pair) + g * std::sin(alpha_of(pair)), -side * g * std::cos(alpha_of(pair))};
}

}  // namespace

double rack_pinion_rotation(const RackPair& pair) {
  const auto& reference = pair.pinion.reference();
  return reference.base_tooth_thickness / reference.base_diameter - involute(alpha_of(pair));
}

Result<std::vector<Vec2>> rack_section(const RackPair& pair) {
  const RackGeometry& rack = pair.rack;
  const auto outline = rack_outline(rack);
  if (!outline) return outline.error();
  std::vector<Vec2> tooth;  // half a tooth, root to tip
  for (const Arc& arc : outline->arcs) {
    const std::vector<Vec2> part = chords(arc, kOutlineTolerance * rack.normal_module);
    tooth.insert(tooth.end(), part.begin() + (tooth.empty() ? 0 : 1), part.end());
  }
  std::vector<Vec2> points;
  const int n = rack.teeth;
  for (int k = 0; k < n; ++k) {
    const double middle = (k - (n - 1) / 2.0) * rack.transverse_pitch;
    for (const Vec2& p : tooth) points.emplace_back(p.x(), middle - p.y());
    for (auto p = tooth.rbegin() + 1; p != tooth.rend(); ++p)
      points.emplace_back(p->x(), middle + p->y());
  }
  const double first = points.front().y(), last = points.back().y();
  points.emplace_back(-rack.height, last);
  points.emplace_back(-rack.height, first);
  points.push_back(points.front());
  return points;
}

Result<std::string> rack_definition(const RackPair& pair, const std::string& name) {
  const auto section = rack_section(pair);
  if (!section) return section.error();
  return fmt::format("<path id=\"{}\" vector-effect=\"non-scaling-stroke\" d=\"{}\"/>\n", name,
                     outline_path(*section, outline_unit_mm(pair.pinion)));
}

Vec2 rack_place(const RackPair& pair) {
  const RackGeometry& rack = pair.rack;
  // Half the transverse tooth thickness of the rack at the pitch line. The distance from the datum
  // line to the pitch line is the centre distance minus the reference radius of the pinion.
  const double half = (rack.thickness / 2 - (pair.center_distance - pitch_radius(pair)) *
                                                std::tan(rack.normal_pressure_angle.rad())) /
                      std::cos(rack.helix_angle.rad());
  const bool odd = pair.rack.teeth % 2 == 1;
  return {pair.center_distance, (odd ? 0.0 : rack.transverse_pitch / 2) - half};
}

Bounds rack_window(const RackScene& scene, MeshFrame frame, double aspect) {
  GW_EXPECTS(aspect > 0.0);
  const RackPair& pair = *scene.pair;
  const double r = pitch_radius(pair), m = pair.rack.normal_module;
  Bounds box;
  if (frame == MeshFrame::whole) {
    const double tip = pair.pinion.actual_tip_radius();
    const double along = pair.rack.teeth * pair.rack.transverse_pitch / 2;
    const Vec2 origin = rack_place(pair);
    box.cover({-tip, -tip});
    box.cover({tip, tip});
    box.cover(origin + Vec2(-pair.rack.addendum, -along));
    box.cover(origin + Vec2(pair.rack.height, along));
  } else if (frame == MeshFrame::flank && pair.approach + pair.recess > 0.0) {
    box.cover(on_action(pair, -pair.approach));
    box.cover(on_action(pair, pair.recess));
  } else {
    const double along = std::max(pair.approach, pair.recess) * std::cos(alpha_of(pair));
    const double half = std::max(along, 2.2 * m) + 1.2 * m;
    box.cover({r - half, -half});
    box.cover({r + half, half});
  }
  return with_aspect(box, aspect);
}

Figure rack_bodies_figure(const RackScene& scene, const Bounds& window) {
  const RackPair& pair = *scene.pair;
  Figure f =
      plane_figure("gears", "Rack and pinion in section", "Rack and pinion in section.", window);
  FigureMark pinion{FigureMark::Kind::shape, "body g1", {Vec2::Zero()}, scene.shapes[0]};
  pinion.radius = outline_unit_mm(pair.pinion);
  pinion.turned = kDegPerRad * rack_pinion_rotation(pair);
  pinion.gear = 0;
  FigureMark rack{FigureMark::Kind::shape, "body g2", {rack_place(pair)}, scene.shapes[1]};
  rack.radius = pinion.radius;
  rack.turned = 180.0;
  rack.gear = 1;
  for (const char* style : {"body ", "outline "}) {
    rack.style = std::string(style) + kInk[1];
    pinion.style = std::string(style) + kInk[0];
    f.marks.push_back(rack);
    if (has_outline(pair.pinion)) f.marks.push_back(pinion);
  }
  return f;
}

Figure rack_mesh_figure(const RackScene& scene, const Bounds& window) {
  const RackPair& pair = *scene.pair;
  const double r = pitch_radius(pair);
  Figure f = rack_bodies_figure(scene, window);
  f.id = "mesh";
  f.title = "The mesh at the pitch point";
  f.description =
      "Rack and pinion near the pitch point C in the transverse section, with the circles of the "
      "pinion, the datum line of the rack, the lines of action and the points A and E of the path "
      "of contact.";
  std::vector<NamedCircle> circles = scene.circles;
  if (circles.empty())
    circles = {{"d_a", pair.pinion.actual_tip_radius(), style_of_circle("d_a"), "tip diameter"},
               {"d_w", r, style_of_circle("d_w"), "working pitch diameter"},
               {"d_b", pair.pinion.base_radius(), style_of_circle("d_b"), "base diameter"}};
  for (const NamedCircle& c : circles)
    f.circle(Vec2::Zero(), c.radius, std::string("thin g1") + c.style, 0,
             symbol_svg(symbol_of(c, 0)), c.words);
  const double reach = pair.rack.teeth * pair.rack.transverse_pitch;
  const auto upright = [&](double x, const char* style, const char* words) {
    f.line({{x, -reach}, {x, reach}}, style, words);
  };
  upright(pair.center_distance, "thin g2 dashdot", "datum line of the rack");
  upright(pair.center_distance - pair.rack.addendum, "thin g2", "tip line of the rack");
  f.line({{-r, 0.0}, {pair.center_distance + pair.rack.dedendum, 0.0}}, "thin dashdot");
  f.cross(Vec2::Zero());
  const double tangent = r * std::sin(alpha_of(pair));
  const double from = std::max(tangent, pair.approach), to = std::max(tangent, pair.recess);
  f.line({on_action(pair, -from, -1), on_action(pair, to, -1)}, "trailing-line");
  f.line({on_action(pair, -from), on_action(pair, to)}, "action-line");
  const Vec2 way = (on_action(pair, 1) - on_action(pair, 0));
  const Vec2 across = 14.0 * Vec2(way.y(), way.x());  // px; y points down
  if (pair.approach + pair.recess > 0.0) {
    f.line({on_action(pair, -pair.approach), on_action(pair, pair.recess)}, "action");
    f.point(on_action(pair, -pair.approach), 3.2, "mark action-dot", symbol_svg("A"), across);
    f.point(on_action(pair, pair.recess), 3.2, "mark action-dot", symbol_svg("E"), across);
  }
  f.point(on_action(pair, 0.0), 3.2, "mark pitch-dot", symbol_svg("C"), across);
  f.point(on_action(pair, -tangent), 3.2, "mark hollow", symbol_svg("T_1"), across);
  return f;
}

}  // namespace gearwright
