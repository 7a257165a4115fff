#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "gearwright/base/contract.hpp"
#include "gearwright/catalogue/figure_units.hpp"
#include "gearwright/figure/figure_svg.hpp"
#include "gearwright/report/crossed_figures.hpp"
#include "gearwright/report/html_text.hpp"
#include "gearwright/report/line_marks.hpp"

namespace gearwright {

namespace {

constexpr double kPlanAspect = 640.0 / 520.0;
// The scale of the plan is at least 1/kMaxReduction and at most kMaxEnlargement times the scale
// of a picture of the whole gears. The plan is reduced if the lines of action lie far outside
// the faces.
constexpr double kMaxReduction = 5.0;
constexpr double kMaxEnlargement = 12.0;
constexpr int kTeethShown = 400;  // with more teeth, no tooth lines are drawn

// Unit vectors along the axis of a gear and across it, in plan. Axis 2 lies along (sin Σ, cos Σ),
// where Σ is the shaft angle.
struct PlanFrame {
  Vec2 along, across;
  Vec2 at(double s, double t) const { return s * along + t * across; }
};

PlanFrame frame_of(const CrossedPair& pair, std::size_t which) {
  const double sigma = which == 0 ? 0.0 : pair.axis_angle().rad();
  return {{std::sin(sigma), std::cos(sigma)}, {std::cos(sigma), -std::sin(sigma)}};
}

void add_face(Figure& f, const CrossedPair& pair, std::size_t i, double radius,
              const std::string& style) {
  const auto corners = face_in_plan(pair, i, radius);
  f.area({corners.begin(), corners.end()}, style + kInk[i]);
}

// Returns half the width and height of the area that contains the tips of both gears, mm.
Vec2 extent(const CrossedPair& pair) {
  Vec2 half = Vec2::Zero();
  for (const std::size_t i : {0u, 1u}) {
    for (const Vec2& c : face_in_plan(pair, i, pair.gears[i].actual_tip_radius()))
      half = half.cwiseMax(c.cwiseAbs());
  }
  return half;
}

// Returns half the width and height of the area that contains the lines of action, mm.
Vec2 lines_extent(const CrossedPair& pair) {
  Vec2 half = Vec2::Zero();
  for (const double rho1 : line_ends(pair))
    half = half.cwiseMax(in_plan(pair.on_line_of_action(rho1)).cwiseAbs());
  return half;
}

// Returns half the width and half the height of a picture, mm. `half` is half the width and half
// the height of its content. The picture has a margin around the content. `aspect` is the ratio of
// width to height of the picture.
Vec2 window(const Vec2& half, double aspect) {
  const double wide = std::max(1.17 * half.x(), 1.2 * aspect * half.y());
  return {wide, wide / aspect};
}

// Returns half the width and height of the plan, mm. It contains the lines of action with their
// letters, and a sufficient part of the gears.
Vec2 plan_window(const CrossedPair& pair) {
  const Vec2 whole = window(extent(pair), kPlanAspect);
  const Vec2 close = 1.25 * window(lines_extent(pair).cwiseMax(1e-3 * extent(pair)), kPlanAspect);
  return whole / std::clamp(whole.x() / close.x(), 1.0 / kMaxReduction, kMaxEnlargement);
}

// Draws both axes beyond the borders of the picture. The names of the axes are at the border.
void add_axes(Figure& f, const CrossedPair& pair, double width) {
  const Vec2 half(f.x.hi, f.y.hi);
  const double px = 2 * half.x() / width;  // mm per px
  const double far = 1.1 * extent(pair).norm() + 2 * half.norm();
  for (const std::size_t i : {0u, 1u}) {
    const Vec2 along = frame_of(pair, i).along;
    f.line({Vec2(-far * along), Vec2(far * along)}, std::string("thin dashdot ") + kInk[i]);
    const double room = std::min((half.x() - 34 * px) / std::max(std::abs(along.x()), 1e-9),
                                 (half.y() - 16 * px) / std::max(std::abs(along.y()), 1e-9));
    // If the axes are nearly parallel, both reach the border of the picture at the same point. The
    // name of axis 1 is therefore to the left of both axes, and the name of axis 2 is to the right.
    const Vec2 aside = std::abs(along.y()) > std::abs(along.x()) ? Vec2(i == 0 ? -24.0 : 24.0, 5.0)
                                                                 : Vec2(0.0, -8.0);
    f.text(room * along, fmt::format("axis {}", i + 1), Anchor::middle,
           std::string("halo ") + kInk[i], aside);
  }
}

Figure plan_figure(const CrossedPair& pair) {
  const Vec2 half = plan_window(pair);
  Figure f = plane_figure(
      "plan", "Lines of action",
      "Both gears seen along the centre line from gear 2. Rectangles show the pitch cylinders, and "
      "rectangles in thin lines show the tip cylinders. Lines show both axes, the direction of the "
      "teeth, and the leading and trailing lines of action with their ends and base tangent "
      "points.",
      {-half, half});
  f.caption = " seen along the centre line from gear 2. " + line_key() +
              " The rectangles are the pitch cylinders from face to face, and the rectangles in "
              "thin lines are the tip cylinders. The dashed line is the common direction of the "
              "teeth.";
  for (const std::size_t i : {0u, 1u}) {
    add_face(f, pair, i, pair.mesh.rack.sides[i].pitch_radius, "face ");
    add_face(f, pair, i, pair.gears[i].actual_tip_radius(), "thin ");
  }
  add_axes(f, pair, kWideFigure);
  const auto& side = pair.mesh.rack.sides[0];
  const Vec2 teeth(std::sin(side.helix_angle), side.cos_helix);
  const double far = extent(pair).norm() + 2 * half.x();
  f.line({Vec2(-far * teeth), Vec2(far * teeth)}, "thin dash");
  add_lines_of_action(f, pair, in_plan);
  return f;
}

// Draws the tooth lines on the side x > 0 of the pitch cylinder, which is visible from gear 2.
void add_teeth(Figure& figure, const CrossedPair& pair, std::size_t i) {
  const auto& side = pair.mesh.rack.sides[i];
  const int z = std::abs(pair.input.gears[i].teeth);
  if (z > kTeethShown) return;
  const double r = side.pitch_radius;
  const double half = pair.input.face_width[i] / 2;
  const PlanFrame f = frame_of(pair, i);
  // φ is the angle between the direction of view and the radius to a point of the cylinder. In this
  // view, a right-hand tooth rises to the right.
  const double turn = side.tan_helix / r;  // rad/mm
  const double reach = std::abs(turn) * half + std::numbers::pi / 2;
  const double pitch = 2 * std::numbers::pi / z;
  for (int k = static_cast<int>(-reach / pitch); k * pitch <= reach; ++k) {
    // The range of s in which the tooth line φ = k pitch + turn s is on the visible half.
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
      points.push_back(f.at(s, r * std::sin(k * pitch + turn * s)));
    }
    figure.line(std::move(points), std::string("tooth-line ") + kInk[i]);
  }
}

Vec2 whole_window(const CrossedPair& pair) {
  const Vec2 half = extent(pair);
  return window(half, std::clamp(half.x() / half.y(), 1.05, 2.6));
}

// True if the plan shows a smaller area than the picture of the whole pair.
bool plan_is_within(const CrossedPair& pair) {
  return (plan_window(pair).array() < 0.98 * whole_window(pair).array()).all();
}

Figure whole_figure(const CrossedPair& pair) {
  const Vec2 half = whole_window(pair);
  // Gear 2 is in front. If gear 2 is internal, gear 1 is in front, because gear 2 would hide it.
  const std::size_t front = pair.side() > 0.0 ? 1 : 0;
  Figure f = plane_figure("whole", "The whole pair",
                          fmt::format("Both gears seen along the centre line, gear {} in front, "
                                      "with the direction of their teeth.",
                                      front + 1),
                          {-half, half});
  f.caption = fmt::format(
      ", with gear {} in front, shaft angle {}°, centre distance {} mm{}.", front + 1,
      fixed(pair.shaft_angle.deg(), kAngleDigits), fixed(pair.center_distance, kLengthDigits),
      plan_is_within(pair) ? "; the frame marks the picture of the lines of action" : "");
  for (const std::size_t i : {1 - front, front}) {
    add_face(f, pair, i, pair.gears[i].actual_tip_radius(), "solid ");
    add_teeth(f, pair, i);
  }
  if (plan_is_within(pair)) f.bar(-plan_window(pair), plan_window(pair), "frame");
  add_axes(f, pair, kNarrowFigure);
  return f;
}

}  // namespace

Vec2 in_plan(const Point<Housing>& p) { return {p.r.y(), p.r.z()}; }

std::array<Vec2, 4> face_in_plan(const CrossedPair& pair, std::size_t which, double radius) {
  GW_EXPECTS(which < 2);
  const PlanFrame f = frame_of(pair, which);
  const double half = pair.input.face_width[which] / 2;
  return {f.at(-half, -radius), f.at(-half, radius), f.at(half, radius), f.at(half, -radius)};
}

std::array<Figure, 2> plan_figures(const CrossedPair& pair) {
  return {plan_figure(pair), whole_figure(pair)};
}

std::string plan_part(const CrossedPair& pair, const FigureForm& form) {
  const auto [plan, whole] = plan_figures(pair);
  const std::string first = form.html(plan, kWideFigure), second = form.html(whole, kNarrowFigure);
  return first.empty() ? side_by_side(second)
                       : "<div class=\"figures mesh\">\n" + first + second + "</div>\n";
}

}  // namespace gearwright
