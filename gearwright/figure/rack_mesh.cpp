#include "gearwright/figure/rack_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "gearwright/base/numbers.hpp"
#include "gearwright/base/units.hpp"
#include "gearwright/figure/gear_shape.hpp"
#include "gearwright/figure/markup.hpp"
#include "gearwright/figure/mesh.hpp"
#include "gearwright/math/involute.hpp"

namespace gearwright {

namespace {

constexpr double kDrawnBack = 2.0;  // modules below the roots, for a rack whose height is not given

double pitch_radius(const RackPair& pair) { return pair.pinion.reference_diameter / 2; }

double alpha_of(const RackPair& pair) { return pair.pinion.reference().transverse_pressure_angle; }

// A point of the line of action at the distance g from the pitch point. If `side` is −1, it is on
// the trailing line.
Vec2 on_action(const RackPair& pair, double g, double side = 1.0) {
  return {pitch_radius(pair) + g * std::sin(alpha_of(pair)), -side * g * std::cos(alpha_of(pair))};
}

}  // namespace

double rack_pinion_rotation(const RackPair& pair) {
  const auto& reference = pair.pinion.reference();
  return reference.base_tooth_thickness / reference.base_diameter - involute(alpha_of(pair));
}

Result<std::vector<Vec2>> rack_section(const RackPair& pair, double reach) {
  const RackGeometry& rack = pair.rack;
  const auto outline = rack_outline(rack);
  if (!outline) return outline.error();
  const double p_t = rack.transverse_pitch;
  const int n = rack.bar.teeth.value_or(2 * static_cast<int>(std::ceil(reach / p_t)) + 1);
  // Half a tooth in the transverse section at the pitch line, H − r above the datum line.
  const double half = (rack.thickness / 2 - (pair.center_distance - pitch_radius(pair)) *
                                                std::tan(rack.normal_pressure_angle.rad())) /
                      std::cos(rack.helix_angle.rad());
  std::vector<Vec2> points;
  const auto add = [&](double height, double y) {
    points.emplace_back(pair.center_distance - height, y);
  };
  std::vector<Vec2> tooth;  // half a tooth, root to tip
  for (const Arc& arc : outline->arcs) {
    const std::vector<Vec2> part = chords(arc, kOutlineTolerance * rack.normal_module);
    tooth.insert(tooth.end(), part.begin() + (tooth.empty() ? 0 : 1), part.end());
  }
  // The middle tooth touches, below C, with the flank that faces the leading flank of the pinion.
  const int most = static_cast<int>(std::ceil(reach / p_t)) + 1;  // on each side of the middle
  for (int k = std::max(0, n / 2 - most); k <= std::min(n - 1, n / 2 + most); ++k) {
    const double middle = -half + (k - n / 2) * p_t;
    for (const Vec2& p : tooth) add(p.x(), middle - p.y());
    for (auto p = tooth.rbegin() + 1; p != tooth.rend(); ++p) add(p->x(), middle + p->y());
  }
  const double back = -rack.bar.height.value_or(rack.dedendum + kDrawnBack * rack.normal_module);
  const double first = points.front().y(), last = points.back().y();
  add(back, last);
  add(back, first);
  points.push_back(points.front());
  return points;
}

Result<Figure> rack_mesh_figure(const RackPair& pair, const std::string& shape, double aspect) {
  GW_EXPECTS(aspect > 0.0);
  const double r = pitch_radius(pair), m = pair.rack.normal_module;
  const double along = std::max(pair.approach, pair.recess) * std::cos(alpha_of(pair));
  const double half = std::max(along, 2.2 * m) + 1.2 * m;
  const Bounds window{{r - aspect * half, -half}, {r + aspect * half, half}};
  const double reach = 3 * half;
  auto section = rack_section(pair, reach);
  if (!section) return section.error();

  Figure f = plane_figure("mesh", "The mesh at the pitch point",
                          "Rack and pinion near the pitch point C in the transverse section, with "
                          "the circles of the pinion, the datum line of the rack, the lines of "
                          "action and the points A and E of the path of contact.",
                          window);
  FigureMark pinion{FigureMark::Kind::shape, "body g1", {Vec2::Zero()}, shape};
  pinion.radius = outline_unit_mm(pair.pinion);
  pinion.turned = kDegPerRad * rack_pinion_rotation(pair);
  pinion.gear = 0;
  f.area(*section, "body g2");
  if (has_outline(pair.pinion)) f.marks.push_back(pinion);
  f.line(*section, "outline g2");
  pinion.style = "outline g1";
  if (has_outline(pair.pinion)) f.marks.push_back(pinion);
  for (const NamedCircle& c :
       {NamedCircle{"d_a", pair.pinion.actual_tip_radius(), "", "tip diameter"},
        NamedCircle{"d_w", r, "", "working pitch diameter"},
        NamedCircle{"d_b", pair.pinion.base_radius(), "", "base diameter"}})
    f.circle(Vec2::Zero(), c.radius, std::string("thin g1") + style_of_circle(c.symbol), 0,
             symbol_svg(symbol_of(c, 0)), c.words);
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
