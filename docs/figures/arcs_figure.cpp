// Page 7: circular arcs. Left: a tooth cut by rack F in the space cut by rack P, in the normal section.
// Right: the normal angle at the contact as a function of the centre distance.
#include <cmath>
#include <numbers>
#include <stdexcept>

#include <fmt/format.h>

#include "docs/figures/figure.hpp"
#include "gearwright/pair/arc_contact.hpp"
#include "gearwright/tool/arc_rack.hpp"

namespace gearwright::figures {

namespace {

RackOfArcs rack_of(ArcRack::Cutter cutter, double radius, double a, double b) {
  ArcRack rack = default_arc_rack(cutter);
  rack.arc_radius = radius;
  rack.center_a = a;
  rack.center_b = b;
  const auto made = arcs_of(rack);
  if (!made) throw std::logic_error(made.error().message());
  return *made;
}

// Returns half a tooth of the gear from root to tip, in the plane (y, x): the root land cut by the tip
// of the rack, then the arcs up to the addendum.
std::vector<Vec2> half_profile(const RackOfArcs& rack) {
  std::vector<Vec2> points{{std::numbers::pi / 2, -rack.dedendum}};
  for (const RackArc& arc : rack.arcs) {
    for (int i = 0; i <= 40; ++i) {
      const double tau = arc.begin.rad() + (arc.end.rad() - arc.begin.rad()) * i / 40;
      const Vec2 p = point_at(arc, Angle::radians(tau));
      if (p.x() <= rack.addendum) points.push_back({p.y(), p.x()});
    }
  }
  points.push_back({0.0, points.back().y()});
  return points;
}

}  // namespace

Figure arcs_figure() {
  Figure f("07-circular-arc", 860, 480, "Circular arcs touch in a point",
           "Normal section of a convex tooth in a concave space with the centres of both arcs on "
           "one normal, and "
           "the normal angle at the contact over the change of the centre distance.");
  // The drive of Litvin and Tsay: 12 : 94 teeth, normal diametral pitch 2, lead angle 75°. Lengths are
  // in modules.
  const double psi = std::numbers::pi / 6;
  const WorkingArc convex{1.4, 1.4 * std::cos(psi) - 0.79,
                          1.4 * std::sin(psi) - 0.79 * std::tan(psi)};
  const WorkingArc concave{1.55, convex.a + 0.15 * std::cos(psi), convex.b + 0.15 * std::sin(psi)};
  const RackOfArcs rack_f = rack_of(ArcRack::Cutter::F, convex.radius, convex.a, convex.b);
  const RackOfArcs rack_p = rack_of(ArcRack::Cutter::P, concave.radius, concave.a, concave.b);

  // Left: one tooth between the middles of the two spaces beside it.
  {
    const double kSide = std::numbers::pi / 2;
    f.svg().begin_clip(0, 0, 440, 480);
    const Viewport view{440, 480, {0.0, 0.0}, 440 / std::numbers::pi};
    std::vector<Vec2> tooth;
    for (const Vec2& p : half_profile(rack_f)) tooth.push_back(p);
    for (int i = static_cast<int>(tooth.size()) - 1; i >= 0; --i)
      tooth.push_back({-tooth[i].x(), tooth[i].y()});
    // The profile of gear 2 is upside down, and its y is measured from half a pitch away.
    std::vector<Vec2> space;
    for (const Vec2& p : half_profile(rack_p))
      space.push_back({std::numbers::pi / 2 - p.x(), -p.y()});
    const std::size_t n = space.size();
    for (std::size_t i = 0; i < n; ++i)
      space.push_back({-space[n - 1 - i].x(), space[n - 1 - i].y()});
    std::vector<Vec2> above{{-kSide, 3.0}};
    for (std::size_t i = 0; i < n; ++i)
      above.push_back({-space[n - 1 - i].x(), space[n - 1 - i].y()});
    for (std::size_t i = 0; i < n; ++i) above.push_back(space[i]);
    above.push_back({kSide, 3.0});
    std::vector<Vec2> below{{kSide, -3.0}};
    below.insert(below.end(), tooth.begin(), tooth.end());
    below.push_back({-kSide, -3.0});
    f.shape(view, above, "body2 g2");
    f.shape(view, below, "body1 g1");
    f.line(view, {Vec2(-2, 0), Vec2(2, 0)}, "soft dashdot thin");
    f.line(view, {Vec2(0, -1.7), Vec2(0, 1.7)}, "soft dashdot thin");
    const Vec2 o_f(-convex.a, -convex.b);
    const Vec2 o_p(-concave.a, -concave.b);
    const double theta = std::asin((concave.b - convex.b) / (concave.radius - convex.radius));
    const Vec2 touch = o_f + convex.radius * Vec2(std::cos(theta), std::sin(theta));
    f.circle(view, o_f, convex.radius, "g1 dash thin");
    f.circle(view, o_p, concave.radius, "g2 dash thin");
    f.line(view, {o_p, touch}, "action thick");
    f.dot(view, o_f, "fill-g1", 4);
    f.dot(view, o_p, "fill-g2", 4);
    f.dot(view, touch, "fill-action", 5);
    f.arc(view, o_p, 0.5, 0, theta, "ink", 1);
    f.line(view, {o_p, o_p + Vec2(0.62, 0)}, "ink thin");
    f.label(view.px(o_p + polar(0.54, theta / 2)), "{θ_0}", Anchor::start, {2, 5}, "halo");
    f.label(view.px(o_f), "F", Anchor::start, {-4, -9}, "g1 bold halo");
    f.label(view.px(o_p), "P", Anchor::end, {-8, 16}, "g2 bold halo");
    f.label(view.px(touch), "M", Anchor::start, {9, -6}, "action bold halo");
    f.label(view.px(0.35 * o_f + 0.65 * touch), "{ρ_F}", Anchor::middle, {-2, -12}, "g1 halo");
    f.svg().end_group();
    f.label({14, 24}, "normal section, both racks at the reference distance", Anchor::start,
            Vec2::Zero(), "small halo");
    f.label({14, 468}, "gear 1, cut by F", Anchor::start, Vec2::Zero(), "g1 small halo");
    f.label({426, 44}, "gear 2, cut by P", Anchor::end, Vec2::Zero(), "g2 small halo");
  }

  // Right: θ over ΔC, exactly and to first order, for a module of 12.7 mm.
  const double m = 12.7;
  const Angle lead = Angle::degrees(75);
  const auto scaled = [&](const WorkingArc& arc) {
    return WorkingArc{m * arc.radius, m * arc.a, m * arc.b};
  };
  ArcMeshInput input{scaled(convex),
                     scaled(concave),
                     6 * m / std::sin(lead.rad()),
                     47 * m / std::sin(lead.rad()),
                     lead,
                     0.0};
  const double a_0 = input.pitch_radius_convex + input.pitch_radius_concave;
  const Plot plot{{-0.8, 0.8, 506, 838}, {0, 70, 416, 44}};
  draw_frame(f, plot, "change {ΔC} of the centre distance, mm",
             "normal angle {θ} at the contact, °", 5, 7);
  std::vector<Vec2> exact, first;
  for (int i = 0; i <= 80; ++i) {
    const double change = -0.8 + 1.6 * i / 80;
    input.center_distance = a_0 + change;
    if (const auto theta = contact_angle(input)) exact.push_back({change, theta->deg()});
    const double sine =
        (m * (concave.b - convex.b) - change) / (m * (concave.radius - convex.radius));
    if (std::abs(sine) < 1) first.push_back({change, Angle::radians(std::asin(sine)).deg()});
  }
  draw_curve(f, plot, first, "g2 dash");
  draw_curve(f, plot, exact, "g1 thick");
  const double begin = rack_f.arcs.back().begin.rad();
  const double begin_deg = Angle::radians(begin).deg();
  f.svg().line(plot.px(-0.8, begin_deg), plot.px(0.8, begin_deg), "action dash");
  f.label(plot.px(-0.8, begin_deg), fmt::format("the flank of F begins, {:.1f}°", begin_deg),
          Anchor::start, {8, -6}, "action small halo");
  f.svg().circle(plot.px(0, 30), 4.5, "fill-g1");
  f.label(plot.px(0, 30), "{θ_0} = 30°", Anchor::start, {10, -4}, "g1 halo");
  f.svg().line(plot.px(0.08, 62), plot.px(0.2, 62), "g1 thick");
  f.label(plot.px(0.23, 62), "exact [T7.16]", Anchor::start, {0, 4}, "small halo");
  f.svg().line(plot.px(0.08, 56), plot.px(0.2, 56), "g2 dash");
  f.label(plot.px(0.23, 56), "first order [T7.17]", Anchor::start, {0, 4}, "small halo");
  return f;
}

}  // namespace gearwright::figures
