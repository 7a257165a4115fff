#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "gearwright/base/units.hpp"
#include "gearwright/report/gear_shape.hpp"
#include "gearwright/report/html_text.hpp"
#include "gearwright/report/line_marks.hpp"
#include "gearwright/report/named_circles.hpp"
#include "gearwright/report/pair_figures.hpp"
#include "gearwright/report/turning.hpp"

namespace gearwright {

namespace {

constexpr double kMeshWidth = 640.0;
constexpr double kMeshHeight = 560.0;
constexpr double kWholeWidth = 420.0;
constexpr double kWholeHeight = 360.0;
constexpr double kLetterRoom = 17.0;  // px between two letters on one side of the line

Vec2 flat(const Point<Housing>& p) { return {p.r.x(), p.r.y()}; }

Vec2 axis_of(const InvolutePair& pair, std::size_t i) {
  return {i == 0 ? 0.0 : pair.center_distance, 0.0};
}

// The area of the pair, mm.
struct Extent {
  double left, right, tall;
};

Extent extent_of(const InvolutePair& pair) {
  const double a = pair.center_distance;
  const double R1 = drawn_radius(pair.gears[0]);
  const double R2 = drawn_radius(pair.gears[1]);
  return {std::min(-R1, a - R2), std::max(R1, a + R2), 2 * std::max(R1, R2)};
}

// Drawn directions of the x axes of the gears, degrees counter-clockwise.
std::array<double, 2> drawn_angles(const InvolutePair& pair) {
  const std::array<double, 2> phi = rotation_to_pitch_point(pair);
  const auto angle = [](const Eigen::Isometry3d& x) { return std::atan2(x(1, 0), x(0, 0)); };
  return {kDegPerRad * (angle(pair.pose_1().isometry()) + phi[0]),
          kDegPerRad * (angle(pair.pose_2().isometry()) + phi[1])};
}

void draw_bodies(Svg& svg, const Viewport& view, const InvolutePair& pair,
                 const std::array<std::string, 2>& shapes) {
  const std::array<double, 2> angles = drawn_angles(pair);
  // Outlines are drawn after both bodies, so that both are visible where the teeth overlap.
  for (const char* style : {"body ", "outline "}) {
    for (const std::size_t i : {1, 0}) {
      const Gear& gear = pair.gears[i];
      if (!has_outline(gear)) continue;
      svg.use(shapes[i], view.px(axis_of(pair, i)), view.scale * outline_unit_mm(gear), angles[i],
              std::string(style) + kInk[i], turn_attribute(pair, i));
    }
  }
}

std::vector<NamedCircle> circles_of(const InvolutePair& pair, std::size_t i) {
  const Gear& gear = pair.gears[i];
  std::vector<NamedCircle> circles = mesh_circles(pair, i);
  if (!has_outline(gear))
    circles.push_back({"d_f" + std::to_string(i + 1), gear.root_diameter / 2, ""});
  return circles;
}

std::vector<PixelBox> draw_circles(Svg& svg, const Viewport& view, const InvolutePair& pair,
                                   std::size_t i) {
  // The side of the axis on which the mesh is.
  const double side =
      flat(pair.on_line_of_action(pair.mesh.rho1_C)).x() > axis_of(pair, i).x() ? 1.0 : -1.0;
  return draw_named_circles(svg, view, axis_of(pair, i), side, i, circles_of(pair, i));
}

// The line of action with A … E. Letters change sides if they would touch each other or a name.
void draw_path(Svg& svg, const Viewport& view, const InvolutePair& pair,
               const std::vector<PixelBox>& taken) {
  const Mesh<double>& mesh = pair.mesh;
  const auto at = [&](double rho1) { return view.px(flat(pair.on_line_of_action(rho1))); };
  // Base tangent points: ρ_1 = 0 and ρ_2 = 0 (an internal gear's lies on the same side as gear
  // 1's).
  const double T2 = mesh.sigma * mesh.base_tangent_distance;
  const double from = std::min({0.0, T2, mesh.rho1_A});
  const double to = std::max({0.0, T2, mesh.rho1_E});
  svg.line(at(from), at(to), "action-line");
  svg.line(at(mesh.rho1_A), at(mesh.rho1_E), "action");

  std::vector<PathMark> marks{{"A", mesh.rho1_A, "mark action-dot"},
                              {"B", mesh.rho1_B, "mark action-dot"},
                              {"C", mesh.rho1_C, "mark pitch-dot"},
                              {"D", mesh.rho1_D, "mark action-dot"},
                              {"E", mesh.rho1_E, "mark action-dot"},
                              {"T_1", 0.0, "mark hollow"},
                              {"T_2", T2, "mark hollow"}};
  sort_marks(marks);
  const Vec2 along = (at(to) - at(from)).normalized();
  const Vec2 across(-along.y(), along.x());
  std::array<double, 2> last{-1e9, -1e9};
  for (const PathMark& mark : marks) {
    const Vec2 p = at(mark.rho1);
    svg.dot(p, 3.2, mark.style);
    const double s = p.dot(along);
    std::size_t side = s - last[0] >= kLetterRoom || s - last[0] >= s - last[1] ? 0 : 1;
    const auto offset = [&](std::size_t which) { return (which == 0 ? 14.0 : -14.0) * across; };
    const auto free = [&](std::size_t which) {
      const PixelBox box = label_box({p, offset(which), Anchor::middle}, mark.letter);
      return s - last[which] >= kLetterRoom &&
             std::none_of(taken.begin(), taken.end(),
                          [&](const PixelBox& b) { return meet(b, box); });
    };
    if (!free(side) && free(1 - side)) side = 1 - side;
    last[side] = s;
    svg.text(p, symbol_svg(mark.letter), Anchor::middle, "letter halo",
             offset(side) + Vec2(0.0, 5.0));
  }
}

Viewport mesh_window(const InvolutePair& pair) {
  const Mesh<double>& mesh = pair.mesh;
  const double m = pair.gears[0].spec.normal_module;
  const double reach =
      std::max(std::abs(mesh.rho1_A - mesh.rho1_C), std::abs(mesh.rho1_E - mesh.rho1_C));
  const double half =
      std::max(reach * std::cos(mesh.rack.sides[0].transverse_angle), 2.2 * m) + 1.2 * m;
  return {kMeshWidth, kMeshHeight, flat(pair.on_line_of_action(mesh.rho1_C)),
          kMeshHeight / (2 * half)};
}

std::string mesh_svg(const InvolutePair& pair, const std::array<std::string, 2>& shapes) {
  const Viewport view = mesh_window(pair);
  Svg svg("mesh", kMeshWidth, kMeshHeight, "The mesh at the pitch point",
          "Both gears near the pitch point C in the transverse section, with pitch, base and tip "
          "circles, the line of action and the points A to E of the path of contact on it.");
  draw_bodies(svg, view, pair, shapes);
  // The centre line extends over both gears, for users who zoom out.
  const Extent across = extent_of(pair);
  svg.line(view.px({across.left, 0}), view.px({across.right, 0}), "thin dashdot");
  std::vector<PixelBox> taken = draw_circles(svg, view, pair, 0);
  for (const PixelBox& box : draw_circles(svg, view, pair, 1)) taken.push_back(box);
  draw_path(svg, view, pair, taken);
  draw_touches(svg, view, pair);
  return svg.str();
}

// An arrow on the circle `radius` px about `axis`, over its top, in the sense of rotation.
void draw_turn(Svg& svg, const Vec2& axis, double radius, bool clockwise, const char* ink) {
  const double half = 0.55;  // rad
  const double s = clockwise ? 1.0 : -1.0;
  const auto on = [&](double angle, double r) {
    return Vec2(axis.x() + s * r * std::sin(angle), axis.y() - r * std::cos(angle));
  };
  std::vector<Vec2> arc;
  for (int k = 0; k <= 16; ++k) arc.push_back(on(-half + k * half / 8, radius));
  svg.polyline(arc, std::string("turn ") + ink);
  const double back = half - 9.0 / radius;
  svg.polygon({on(half + 2.0 / radius, radius), on(back, radius - 4.5), on(back, radius + 4.5)},
              std::string("head ") + ink);
}

std::string whole_svg(const InvolutePair& pair, const std::array<std::string, 2>& shapes) {
  const bool external = pair.kind == PairKind::parallel_external;
  const auto [left, right, tall] = extent_of(pair);
  const double scale = 0.94 * std::min(kWholeWidth / (right - left), kWholeHeight / tall);
  // The height is no more than the pair needs.
  const double height = std::max(120.0, std::min(kWholeHeight, scale * tall + 24.0));
  const Viewport view{kWholeWidth, height, Vec2((left + right) / 2, 0.0), scale};

  Svg svg("whole", kWholeWidth, height, "The whole pair",
          external
              ? "Both gears in place with their axes and directions of rotation; a frame marks the "
                "part that the picture of the mesh shows."
          : has_outline(pair.gears[1])
              ? "The pinion in the internal gear with axes and directions of rotation; a frame "
                "marks the part that the picture of the mesh shows."
              : "The pinion in the internal gear, whose circles alone are drawn, with axes and "
                "directions of rotation; a frame marks the part that the picture of the mesh "
                "shows.");
  draw_bodies(svg, view, pair, shapes);
  for (const std::size_t i : {0, 1}) {
    for (const NamedCircle& c : circles_of(pair, i)) {
      svg.circle(view.px(axis_of(pair, i)), c.radius * scale,
                 std::string("thin ") + kInk[i] + c.style);
    }
  }
  svg.line(view.px({left, 0}), view.px({right, 0}), "thin dashdot");
  const Viewport mesh = mesh_window(pair);
  const Vec2 corner = view.px(mesh.mm({0, 0}));
  const Vec2 size = view.px(mesh.mm({mesh.width, mesh.height})) - corner;
  svg.rect(corner.x(), corner.y(), size.x(), size.y(), "frame");
  for (const std::size_t i : {0, 1}) {
    const Vec2 axis = view.px(axis_of(pair, i));
    const Gear& gear = pair.gears[i];
    const double r = 0.66 * scale * gear.root_diameter / 2;
    const bool readable = r > 20.0 && !gear.internal();  // the arrow would lie on its pinion
    if (readable) draw_turn(svg, axis, r, i == 0, kInk[i]);
    svg.line(axis - Vec2(5, 0), axis + Vec2(5, 0), "cross");
    svg.line(axis - Vec2(0, 5), axis + Vec2(0, 5), "cross");
    if (external) {
      // The number of a small gear is below it, away from the frame.
      const double below = scale * drawn_radius(gear) > 26.0
                               ? 19.0
                               : 15.0 + std::max(scale * drawn_radius(gear), size.y() / 2);
      svg.text(axis, std::to_string(i + 1), Anchor::middle, "letter halo", {0.0, below});
    }
  }
  return svg.str();
}

}  // namespace

std::array<double, 2> rotation_to_pitch_point(const InvolutePair& pair) {
  const double inv_w = involute(pair.mesh.rack.sides[0].transverse_angle);
  const auto base_half = [&](std::size_t i) {
    const Gear& gear = pair.gears[i];
    return gear.reference().base_tooth_thickness / gear.reference().base_diameter;
  };
  const double sigma = pair.kind == PairKind::parallel_external ? 1.0 : -1.0;
  const double psi_1 = base_half(0) - inv_w;
  const double psi_2 = base_half(1) - sigma * inv_w;
  return {psi_1, -sigma * (std::numbers::pi / std::abs(pair.input.gears[1].teeth) - psi_2)};
}

std::string mesh_figures(const InvolutePair& pair, const std::array<std::string, 2>& shapes,
                         const std::string& below) {
  const Gear& gear_2 = pair.gears[1];
  const std::string ring =
      !gear_2.internal() ? ""
      : has_outline(gear_2)
          ? fmt::format(" The internal gear is drawn with a rim of {:g} modules.", kRim)
          : " <strong>The internal gear has no outline</strong>, for its cutter is not given: tip "
            "and root circles stand for it.";
  const std::string mesh = fmt::format(
      "<strong>The mesh</strong> at the pitch point C, gear 1 driving clockwise. {} {} <span "
      "class=\"key turn-key\" hidden><i class=\"swatch touch\"></i>flanks touch, once "
      "turned</span> "
      "Tip circles full, pitch circles dash-dot, base circles dashed; T: base tangent points.{}",
      caption_of_gears(), caption_key("action", "path of contact A–E"), ring);
  const std::string whole = fmt::format(
      "<strong>The whole pair</strong>, centre distance {} mm; the frame is the picture of the "
      "mesh.",
      fixed(pair.center_distance, kLengthDigits));
  return "<div class=\"figures mesh\">\n" +
         captioned(mesh_svg(pair, shapes) + turn_control(pair), mesh) + "<div>" +
         captioned(whole_svg(pair, shapes), whole) + below + "</div>\n</div>\n";
}

}  // namespace gearwright
