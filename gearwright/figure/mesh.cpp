#include "gearwright/figure/mesh.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "gearwright/base/contract.hpp"
#include "gearwright/base/numbers.hpp"
#include "gearwright/base/units.hpp"
#include "gearwright/figure/gear_shape.hpp"
#include "gearwright/figure/markup.hpp"

namespace gearwright {

namespace {

constexpr double kRoom = 0.06;  // margin relative to the extent of the pair
// The distance from the edge of gear 1 to the axis of gear 2, divided by the radius of gear 2, if
// the gears are drawn side by side.
constexpr double kBesideTooth = 1.12;

Vec2 flat(const Point<Housing>& p) { return {p.r.x(), p.r.y()}; }

bool meshing(const MeshScene& s) { return s.pair && !s.pair->crossed(); }

Vec2 axis_of(const MeshScene& s, std::size_t i) {
  if (i == 0) return Vec2::Zero();
  if (meshing(s)) return {s.pair->center_distance, 0.0};
  return {drawn_radius(*s.gears[0]) + kBesideTooth * drawn_radius(*s.gears[1]), 0.0};
}

// Directions of the x axes of the gears in the picture, degrees counter-clockwise.
std::array<double, 2> drawn_angles(const MeshScene& s) {
  if (!meshing(s)) return {0.0, 0.0};
  const std::array<double, 2> phi =
      s.involute ? rotation_to_pitch_point(*s.involute) : std::array{0.0, 0.0};
  return {kDegPerRad * (s.pair->pose_1().turn() + phi[0]),
          kDegPerRad * (s.pair->pose_2().turn() + phi[1])};
}

Bounds extent_of(const MeshScene& s) {
  Bounds all;
  for (std::size_t i = 0; i < s.gears.size(); ++i) {
    const double r = drawn_radius(*s.gears[i]);
    all.cover(axis_of(s, i) - Vec2(r, r));
    all.cover(axis_of(s, i) + Vec2(r, r));
  }
  return all;
}

Bounds with_room(const Bounds& box, double room) {
  return {box.lo - Vec2(room, room), box.hi + Vec2(room, room)};
}

// Returns the region around the pitch point, with the path of contact and some of the teeth.
Bounds about_pitch_point(const InvolutePair& pair) {
  const Mesh<double>& mesh = pair.mesh;
  const double m = pair.gears[0].spec.normal_module;
  const double reach =
      std::max(std::abs(mesh.rho1_A - mesh.rho1_C), std::abs(mesh.rho1_E - mesh.rho1_C));
  const double half =
      std::max(reach * std::cos(mesh.rack.sides[0].transverse_angle), 2.2 * m) + 1.2 * m;
  const Vec2 C = flat(pair.on_line_of_action(mesh.rho1_C));
  return with_room({C, C}, half);
}

// Returns the region around the overlap of the tip cylinders on the centre line.
Bounds about_overlap(const MeshScene& s) {
  const double a = s.pair->center_distance;
  const double r_1 = s.gears[0]->actual_tip_radius(), r_2 = s.gears[1]->actual_tip_radius();
  const auto [from, to] = std::minmax({s.pair->side() * r_1, a - r_2});
  const Vec2 middle((from + to) / 2, 0.0);
  return with_room({middle, middle}, 1.2 * (to - from));
}

// Draws the line of action with A … E and the base tangent points. For an internal gear, both base
// tangent points are on the same side of the pitch point.
void add_path(Figure& f, const InvolutePair& pair) {
  const Mesh<double>& mesh = pair.mesh;
  const auto at = [&](double rho1) { return flat(pair.on_line_of_action(rho1)); };
  const double T2 = mesh.sigma * mesh.base_tangent_distance;
  const double from = std::min({0.0, T2, mesh.rho1_A}), to = std::max({0.0, T2, mesh.rho1_E});
  f.line({flat(pair.on_trailing_line(0.0)), flat(pair.on_trailing_line(T2))}, "trailing-line");
  f.line({at(from), at(to)}, "action-line");
  f.line({at(mesh.rho1_A), at(mesh.rho1_E)}, "action");
  struct Letter {
    const char* words;
    double rho1;
    const char* style;
  };
  std::vector<Letter> letters{{"C", mesh.rho1_C, "mark pitch-dot"},
                              {"A", mesh.rho1_A, "mark action-dot"},
                              {"E", mesh.rho1_E, "mark action-dot"},
                              {"B", mesh.rho1_B, "mark action-dot"},
                              {"D", mesh.rho1_D, "mark action-dot"},
                              {"T_1", 0.0, "mark hollow"},
                              {"T_2", T2, "mark hollow"}};
  const Vec2 along = (at(to) - at(from)).normalized();
  const Vec2 across = 14.0 * Vec2(along.y(), along.x());  // px; y points down
  for (const Letter& one : letters) {
    if (at(one.rho1).allFinite())
      f.point(at(one.rho1), 3.2, one.style, symbol_svg(one.words), across);
  }
  if (pair.flanks_meet() && mesh.true_ratio > 0.0) {
    f.slide = {at(mesh.rho1_C), at(mesh.rho1_C + mesh.step) - at(mesh.rho1_C),
               (mesh.rho1_true_begin - mesh.rho1_C) / mesh.step,
               (mesh.rho1_true_end - mesh.rho1_C) / mesh.step, "touch"};
  }
}

// Draws an arrow above the axis. The arrow shows the direction of rotation.
void add_turn(Figure& f, const Vec2& axis, double radius, bool clockwise, int gear) {
  constexpr double kHalf = 0.55;  // rad, half the angle of the arrow
  std::vector<Vec2> arc;
  for (int k = 0; k <= 24; ++k) {
    const double angle = (clockwise ? 1.0 : -1.0) * (k / 12.0 - 1.0) * kHalf;
    arc.push_back(axis + radius * Vec2(std::sin(angle), std::cos(angle)));
  }
  f.line(std::move(arc), std::string("turn ") + kInk[static_cast<std::size_t>(gear)]);
  f.marks.back().head = true;
  f.marks.back().gear = gear;
}

}  // namespace

Bounds with_aspect(const Bounds& box, double aspect) {
  const Vec2 size = box.size();
  const double height = std::max(size.y(), size.x() / aspect);
  const Vec2 half(aspect * height / 2, height / 2), middle = (box.lo + box.hi) / 2;
  return {middle - half, middle + half};
}

std::string symbol_of(const NamedCircle& circle, std::size_t i) {
  if (circle.symbol.empty()) return {};
  const char* between = circle.symbol.find('_') == circle.symbol.npos ? "_" : "";
  return circle.symbol + between + std::to_string(i + 1);
}

const char* style_of_circle(std::string_view symbol) {
  const std::string_view kind = symbol.substr(0, 3);
  if (kind == "d_a" || kind == "d_f") return "";
  if (kind == "d_w" || kind == "d") return " dashdot";
  return kind == "d_b" ? " dash" : " dot";
}

std::vector<NamedCircle> mesh_circles(const InvolutePair& pair, std::size_t i) {
  const Gear& gear = pair.gears[i];
  std::vector<NamedCircle> circles;
  for (const auto& [symbol, radius, words] :
       {std::tuple("d_a", gear.actual_tip_radius(), "tip diameter"),
        std::tuple("d_w", pair.mesh.rack.sides[i].pitch_radius, "working pitch diameter"),
        std::tuple("d_b", gear.base_radius(), "base diameter")})
    circles.push_back({symbol, radius, style_of_circle(symbol), words});
  return circles;
}

MeshScene mesh_scene(const InvolutePair& pair, const std::array<std::string, 2>& shapes) {
  MeshScene s{{&pair.gears[0], &pair.gears[1]}, &pair, &pair, shapes};
  for (const std::size_t i : {0u, 1u}) {
    s.circles[i] = mesh_circles(pair, i);
    if (!has_outline(pair.gears[i]))
      s.circles[i].push_back({"d_f", pair.gears[i].root_diameter / 2, "", "root diameter"});
  }
  return s;
}

Bounds mesh_window(const MeshScene& s, MeshFrame frame, double aspect) {
  GW_EXPECTS(!s.gears.empty() && aspect > 0.0);
  if (frame == MeshFrame::whole || !meshing(s)) {
    const Bounds all = extent_of(s);
    return with_aspect(with_room(all, kRoom * all.size().maxCoeff() / 2), aspect);
  }
  if (!s.involute) return with_aspect(about_overlap(s), aspect);
  if (frame == MeshFrame::mesh || !s.involute->flanks_meet())
    return with_aspect(about_pitch_point(*s.involute), aspect);
  Bounds path;
  const Mesh<double>& mesh = s.involute->mesh;
  for (const double rho1 : {mesh.rho1_A, mesh.rho1_E})
    path.cover(flat(s.involute->on_line_of_action(rho1)));
  return with_aspect(with_room(path, 0.08 * path.size().maxCoeff()), aspect);
}

void add_bodies(Figure& f, const MeshScene& s, const std::array<double, 2>& angles) {
  for (const char* style : {"body ", "outline "}) {
    for (std::size_t i = s.gears.size(); i-- > 0;) {
      if (!has_outline(*s.gears[i])) continue;
      FigureMark shape{
          FigureMark::Kind::shape, std::string(style) + kInk[i], {axis_of(s, i)}, s.shapes[i]};
      shape.radius = outline_unit_mm(*s.gears[i]);
      shape.turned = angles[i];
      if (meshing(s)) shape.per_pitch = turn_per_pitch(*s.pair, i);
      shape.gear = static_cast<int>(i);
      f.marks.push_back(std::move(shape));
    }
  }
}

void add_circles(Figure& f, const MeshScene& s, bool named) {
  for (std::size_t i = 0; i < s.gears.size(); ++i) {
    for (const NamedCircle& c : s.circles[i])
      f.circle(axis_of(s, i), c.radius, std::string("thin ") + kInk[i] + c.style,
               static_cast<int>(i), named ? symbol_svg(symbol_of(c, i)) : "", c.words);
  }
}

Figure bodies_figure(const MeshScene& s, const Bounds& window) {
  Figure f = plane_figure("gears", "The gears in section", "Both gears in section.", window);
  add_bodies(f, s, drawn_angles(s));
  return f;
}

Figure mesh_figure(const MeshScene& s, const Bounds& window) {
  Figure f = bodies_figure(s, window);
  f.id = "mesh";
  f.title = s.involute && meshing(s) ? "The mesh at the pitch point" : "The gears in section";
  f.description =
      s.involute && meshing(s)
          ? "Both gears near the pitch point C in the transverse section, with their circles, the "
            "lines of action and the points A to E of the path of contact."
          : "The gears in the transverse section with their circles.";
  add_circles(f, s, true);
  if (meshing(s)) {
    // The lines extend over both gears, so that they are complete after zooming out.
    const Bounds all = extent_of(s);
    f.line({{all.lo.x(), 0.0}, {all.hi.x(), 0.0}}, "thin dashdot");
  }
  for (std::size_t i = 0; i < s.gears.size(); ++i) f.cross(axis_of(s, i));
  if (s.involute && meshing(s)) add_path(f, *s.involute);
  return f;
}

Figure whole_figure(const MeshScene& s, const Bounds& window, const Bounds& framed) {
  const bool external = !s.gears[1]->internal();
  Figure f = bodies_figure(s, window);
  f.id = "whole";
  f.title = "The whole pair";
  f.description =
      external
          ? "Both gears in place with their axes and directions of rotation; a frame marks the "
            "part that the picture of the mesh shows."
      : has_outline(*s.gears[1])
          ? "The pinion in the internal gear with axes and directions of rotation; a frame marks "
            "the part that the picture of the mesh shows."
          : "The pinion in the internal gear, with axes and directions of rotation. Only circles "
            "are drawn for the internal gear. A frame marks the part that the picture of the mesh "
            "shows.";
  add_circles(f, s, false);
  const Bounds all = extent_of(s);
  f.line({{all.lo.x(), 0.0}, {all.hi.x(), 0.0}}, "thin dashdot");
  f.bar(framed.lo, framed.hi, "frame");
  for (const std::size_t i : {0u, 1u}) {
    const Gear& gear = *s.gears[i];
    const double r = 0.66 * gear.root_diameter / 2;
    // The arrow is omitted on a gear that is too small, and on an internal gear 2, where it would
    // cover the pinion.
    constexpr double kReadable = 0.05;  // relative to the width of the picture
    if (r > kReadable * window.size().x() && (i == 0 || external))
      add_turn(f, axis_of(s, i), r, i == 0, static_cast<int>(i));
    f.cross(axis_of(s, i), external ? std::to_string(i + 1) : "");
  }
  return f;
}

std::array<double, 2> rotation_to_pitch_point(const InvolutePair& pair) {
  const double inv_w = involute(pair.mesh.rack.sides[0].transverse_angle);
  const auto base_half = [&](std::size_t i) {
    const Gear& gear = pair.gears[i];
    return gear.reference().base_tooth_thickness / gear.reference().base_diameter;
  };
  const double sigma = pair.side();
  const double psi_1 = base_half(0) - inv_w;
  const double psi_2 = base_half(1) - sigma * inv_w;
  return {psi_1, -sigma * (kPi / std::abs(pair.input.gears[1].teeth) - psi_2)};
}

double turn_per_pitch(const MountedGears& pair, std::size_t i) {
  GW_EXPECTS(!pair.crossed() && i < 2);
  const double one = 360.0 / std::abs(pair.gears[i].spec.teeth);
  return i == 0 ? one : -pair.side() * one;
}

}  // namespace gearwright
