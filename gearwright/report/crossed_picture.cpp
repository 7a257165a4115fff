#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include "gearwright/base/contract.hpp"
#include "gearwright/figure/svg.hpp"
#include "gearwright/report/crossed_figures.hpp"
#include "gearwright/report/html_text.hpp"
#include "gearwright/report/line_marks.hpp"

namespace gearwright {

namespace {

constexpr double kPlanWidth = 640.0;
constexpr double kPlanHeight = 520.0;
constexpr double kWholeWidth = 420.0;
constexpr double kWholeHeight = 400.0;
// Greatest reduction, relative to the scale of the whole gears, for lines far outside the faces.
constexpr double kMaxReduction = 5.0;
constexpr double kMaxEnlargement = 12.0;
constexpr int kTeethShown = 400;  // with more teeth, a grey area is drawn

// Directions along the axis of a gear and across it, in plan. Axis 2 lies along (sin Σ, cos Σ).
struct PlanFrame {
  Vec2 along, across;
  Vec2 at(double s, double t) const { return s * along + t * across; }
};

PlanFrame frame_of(const InvolutePair& pair, std::size_t which) {
  const double sigma = which == 0 ? 0.0 : pair.shaft_angle.rad();
  return {{std::sin(sigma), std::cos(sigma)}, {std::cos(sigma), -std::sin(sigma)}};
}

void draw_face(Svg& svg, const Viewport& view, const InvolutePair& pair, std::size_t i,
               double radius, const std::string& style) {
  const auto corners = face_in_plan(pair, i, radius);
  svg.polygon(view.px(std::vector<Vec2>(corners.begin(), corners.end())), style + kInk[i]);
}

// Half the size of the area that contains the tips of both gears, mm.
Vec2 extent(const InvolutePair& pair) {
  Vec2 half = Vec2::Zero();
  for (const std::size_t i : {0u, 1u}) {
    for (const Vec2& c : face_in_plan(pair, i, pair.gears[i].actual_tip_radius()))
      half = half.cwiseMax(c.cwiseAbs());
  }
  return half;
}

// Half the size of the area that contains the lines of action.
Vec2 lines_extent(const InvolutePair& pair) {
  Vec2 half = Vec2::Zero();
  for (const double rho1 : line_ends(pair))
    half = half.cwiseMax(in_plan(pair.on_line_of_action(rho1)).cwiseAbs());
  return half;
}

// A window that contains the lines, room for letters and a sufficient part of the gears.
Viewport plan_window(const InvolutePair& pair) {
  const Vec2 lines = lines_extent(pair);
  const auto scale = [](const Vec2& half) {
    return 0.5 * std::min((kPlanWidth - 90) / half.x(), (kPlanHeight - 90) / half.y());
  };
  const double close = 0.8 * scale(lines.cwiseMax(1e-3 * extent(pair)));
  const double whole = scale(extent(pair));
  return {kPlanWidth, kPlanHeight, Vec2::Zero(),
          std::clamp(close, whole / kMaxReduction, kMaxEnlargement * whole)};
}

void draw_axes(Svg& svg, const Viewport& view, const InvolutePair& pair) {
  const double far = 1.1 * extent(pair).norm() + Vec2(view.width, view.height).norm() / view.scale;
  for (const std::size_t i : {0u, 1u}) {
    const PlanFrame f = frame_of(pair, i);
    svg.line(view.px(f.at(-far, 0)), view.px(f.at(far, 0)), std::string("thin dashdot ") + kInk[i]);
  }
}

// The names of the axes are where the axes leave the picture.
void name_axes(Svg& svg, const Viewport& view, const InvolutePair& pair) {
  for (const std::size_t i : {0u, 1u}) {
    const Vec2 d(frame_of(pair, i).along.x(), -frame_of(pair, i).along.y());  // on the screen
    const double room = std::min((view.width / 2 - 34) / std::max(std::abs(d.x()), 1e-9),
                                 (view.height / 2 - 16) / std::max(std::abs(d.y()), 1e-9));
    const Vec2 at = Vec2(view.width / 2, view.height / 2) + room * d;
    // Nearly parallel axes leave the picture together, so the name of gear 1 goes to the left of
    // both.
    const Vec2 aside =
        std::abs(d.y()) > std::abs(d.x()) ? Vec2(i == 0 ? -24.0 : 24.0, 5.0) : Vec2(0.0, -8.0);
    svg.text(at, fmt::format("axis {}", i + 1), Anchor::middle, std::string("halo ") + kInk[i],
             aside);
  }
}

std::string plan_svg(const InvolutePair& pair) {
  const Viewport view = plan_window(pair);
  Svg svg("plan", kPlanWidth, kPlanHeight, "Lines of action in plan",
          "Both gears seen along the centre line from gear 2: the faces of their pitch cylinders "
          "as rectangles, tip cylinders thin, both axes, the direction of the teeth, and the "
          "leading and trailing lines of action with their ends and base tangent points.");
  for (const std::size_t i : {0u, 1u}) {
    draw_face(svg, view, pair, i, pair.mesh.rack.sides[i].pitch_radius, "face ");
    draw_face(svg, view, pair, i, pair.gears[i].actual_tip_radius(), "thin ");
  }
  draw_axes(svg, view, pair);
  const auto& side = pair.mesh.rack.sides[0];
  const Vec2 teeth(std::sin(side.helix_angle), side.cos_helix);
  const double far = extent(pair).norm() + kPlanWidth / view.scale;
  svg.line(view.px(-far * teeth), view.px(far * teeth), "thin dash");
  const auto on = [&](const Point<Housing>& p) { return view.px(in_plan(p)); };
  draw_lines_of_action(svg, pair, on);
  name_axes(svg, view, pair);
  return svg.str();
}

// The teeth on the side of a pitch cylinder that is seen from gear 2's side: x > 0.
void draw_teeth(Svg& svg, const Viewport& view, const InvolutePair& pair, std::size_t i) {
  const auto& side = pair.mesh.rack.sides[i];
  const int z = pair.input.gears[i].teeth;
  if (z > kTeethShown) return;
  const double r = side.pitch_radius;
  const double half = pair.input.face_width[i] / 2;
  const PlanFrame f = frame_of(pair, i);
  // Over the top of the cylinder at the angle φ from the view, a right-hand tooth goes to the
  // right as it rises.
  const double turn = side.tan_helix / r;  // rad/mm
  const double reach = std::abs(turn) * half + std::numbers::pi / 2;
  const double pitch = 2 * std::numbers::pi / z;
  for (int k = static_cast<int>(-reach / pitch); k * pitch <= reach; ++k) {
    // The range of s in which φ = k pitch + turn s is on the visible half.
    double lo = -half;
    double hi = half;
    if (turn != 0.0) {
      const double a = (-std::numbers::pi / 2 - k * pitch) / turn;
      const double b = (std::numbers::pi / 2 - k * pitch) / turn;
      lo = std::max(lo, std::min(a, b));
      hi = std::min(hi, std::max(a, b));
    } else if (std::abs(k * pitch) > std::numbers::pi / 2) {
      continue;
    }
    if (lo >= hi) continue;
    const int steps =
        turn == 0.0 ? 1 : std::clamp(static_cast<int>(std::abs(turn) * (hi - lo) * 8), 2, 24);
    std::vector<Vec2> points;
    for (int n = 0; n <= steps; ++n) {
      const double s = lo + n * (hi - lo) / steps;
      points.push_back(view.px(f.at(s, r * std::sin(k * pitch + turn * s))));
    }
    svg.polyline(points, std::string("tooth-line ") + kInk[i]);
  }
}

Viewport whole_window(const InvolutePair& pair) {
  const Vec2 half = extent(pair);
  const double scale =
      0.5 * std::min((kWholeWidth - 70) / half.x(), (kWholeHeight - 60) / half.y());
  const double height = std::clamp(2 * scale * half.y() + 60.0, 160.0, kWholeHeight);
  return {kWholeWidth, height, Vec2::Zero(), scale};
}

// The size of the plan in the picture of the whole pair, px. None if the plan shows more than that
// picture.
std::optional<Vec2> frame_of_plan(const InvolutePair& pair) {
  const Viewport whole = whole_window(pair);
  const Viewport plan = plan_window(pair);
  const Vec2 size = Vec2(plan.width, plan.height) * (whole.scale / plan.scale);
  if (size.x() > whole.width - 8 || size.y() > whole.height - 8) return std::nullopt;
  return size;
}

std::string whole_svg(const InvolutePair& pair) {
  const Viewport view = whole_window(pair);
  Svg svg(
      "whole", view.width, view.height, "The whole pair",
      "Both gears seen along the centre line, gear 2 in front, with the direction of their teeth.");
  for (const std::size_t i : {0u, 1u}) {
    draw_face(svg, view, pair, i, pair.gears[i].actual_tip_radius(), "solid ");
    draw_teeth(svg, view, pair, i);
  }
  draw_axes(svg, view, pair);
  if (const auto size = frame_of_plan(pair)) {
    svg.rect((view.width - size->x()) / 2, (view.height - size->y()) / 2, size->x(), size->y(),
             "frame");
  }
  name_axes(svg, view, pair);
  return svg.str();
}

}  // namespace

Vec2 in_plan(const Point<Housing>& p) { return {p.r.y(), p.r.z()}; }

std::array<Vec2, 4> face_in_plan(const InvolutePair& pair, std::size_t which, double radius) {
  GW_EXPECTS(pair.crossed() && which < 2);
  const PlanFrame f = frame_of(pair, which);
  const double half = pair.input.face_width[which] / 2;
  return {f.at(-half, -radius), f.at(-half, radius), f.at(half, radius), f.at(half, -radius)};
}

std::string plan_figures(const InvolutePair& pair) {
  const std::string whole = fmt::format(
      "<strong>The whole pair</strong>, gear 2 in front: shaft angle {}°, centre distance {} mm{}.",
      fixed(pair.shaft_angle.deg(), kAngleDigits), fixed(pair.center_distance, kLengthDigits),
      frame_of_plan(pair) ? "; the frame is the picture of the lines of action" : "");
  return "<div class=\"figures mesh\">\n" +
         captioned(plan_svg(pair),
                   "<strong>Lines of action</strong> seen along the centre line from gear 2. " +
                       line_key() +
                       " Rectangles: pitch cylinders from face to face, thin: tip cylinders; "
                       "dashed: the common direction of the teeth.") +
         captioned(whole_svg(pair), whole) + "</div>\n";
}

}  // namespace gearwright
