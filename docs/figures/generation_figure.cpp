// Page 3: a rack rolls over a gear of nine teeth. The envelope of its edge is the tooth. The flank
// is an involute and the fillet a trochoid, with undercut in this example.
#include <cmath>
#include <numbers>

#include "docs/figures/figure.hpp"
#include "gearwright/generation/rack_envelope.hpp"

namespace gearwright::figures {

namespace {

// Returns the cutter's edge on the side y ≥ 0, from the middle of a cutter tooth to the end of its
// flank, but at most to `highest` above the datum line. The section is the normal one, which is
// also the transverse one here (β = 0).
std::vector<Vec2> edge_points(const CutterEdge& edge, double module, double highest) {
  std::vector<Vec2> points{{-edge.tip_depth, std::numbers::pi * module / 2},
                           {-edge.tip_depth, edge.tip_land_end}};
  for (const EdgeArc& arc : edge.arcs) {
    if (const auto* circle = std::get_if<EdgeCircle>(&arc.shape)) {
      const EdgeCircle& c = *circle;
      for (int i = 0; i <= 12; ++i) {
        const double begin = c.begin_tau.rad(), end = c.end_tau.rad();
        const double tau = begin + (end - begin) * i / 12;
        points.push_back(c.center + c.q * Vec2(std::sin(tau), std::cos(tau)));
      }
    } else {
      const auto& line = std::get<EdgeLine>(arc.shape);
      for (const double x : {line.begin_height, std::min(line.end_height, highest)})
        points.push_back({x, line.y_datum - x * std::tan(line.tau.rad())});
    }
  }
  return points;
}

}  // namespace

Drawing generation_figure() {
  Drawing f(
      "03-rack-and-generation", 860, 600, "A rack cuts a tooth",
      "Positions of a rack's edge seen from a gear of 9 teeth, and the tooth that they leave: "
      "involute, trochoid, and the crossing where undercut ends the flank.");
  CylindricalSpec spec;
  spec.teeth = 9;
  spec.normal_module = 10;
  spec.face_width = 20;
  const Gear gear = gear_of(spec);
  const double r = gear.reference_diameter / 2;
  const auto made = make_edge(spec.straight_rack(), spec.normal_module, spec.normal_pressure_angle);
  const std::vector<Vec2> side = edge_points(made->edge, spec.normal_module, 10.0);
  const double pitch = std::numbers::pi * spec.normal_module;
  const Viewport view{860, 600, {45.5, 0}, 16, true};

  // The teeth of the cutter on both sides of the gear's tooth. When the gear has turned by `angle`,
  // the cutter has moved by r · `angle`.
  std::vector<Vec2> cutter;
  for (auto p = side.rbegin(); p != side.rend(); ++p) cutter.push_back(*p);
  for (const Vec2& p : side) cutter.push_back({p.x(), pitch - p.y()});
  std::vector<Vec2> other = cutter;
  for (Vec2& p : other) p.y() -= pitch;
  const auto seen = [&](const std::vector<Vec2>& points, double angle) {
    std::vector<Vec2> moved = points;
    for (Vec2& p : moved) p += Vec2(r, -r * angle);
    return placed(moved, angle, Vec2::Zero());
  };

  f.shape(view, teeth(gear, -1, 1, 0, 0.002), "body1");
  for (int i = -13; i <= 13; ++i) {
    f.line(view, seen(cutter, i * 0.06), "grey thin");
    f.line(view, seen(other, i * 0.06), "grey thin");
  }
  f.circle(view, {0, 0}, r, "ink dashdot");
  f.circle(view, {0, 0}, gear.base_radius(), "green dash");
  for (const int mirrored : {1, -1}) {
    for (const Arc& arc : gear.tooth->outline.arcs) {
      std::vector<Vec2> points = sample(arc, 80);
      for (Vec2& p : points) p.y() *= mirrored;
      f.line(view, points,
             arc.name == ArcName::flank         ? "g1 heavy"
             : arc.name == ArcName::root_fillet ? "g2 heavy"
                                                : "ink thick");
    }
  }

  // One position. A point of the flank is cut when its normal passes through the pitch point P.
  const Arc& flank = *gear.tooth->outline.find(ArcName::flank);
  const CurvePoint cut = flank.at(0.62);
  const double alpha = spec.normal_pressure_angle.rad();
  // The tangent of the flank is the turned tangent of the rack's edge, at the angle `angle` − α.
  const double angle = cut.tangent_angle + alpha;
  const Vec2 pitch_point = polar(r, angle);
  f.line(view, seen(cutter, angle), "action thick");
  f.line(view, seen(other, angle), "action thick");
  f.line(view, {pitch_point, cut.point}, "action dash");
  f.dot(view, cut.point, "fill-action", 4.5);
  f.dot(view, pitch_point, "fill-action", 4.5);
  f.label(view.px(pitch_point), "pitch point", Anchor::end, {-9, -7}, "action halo");
  f.label(view.px(cut.point), "W", Anchor::start, {9, 14}, "action bold halo");

  const Vec2 crossing = flank.begin_point;
  f.svg().circle(view.px({crossing.x(), -crossing.y()}), 6, "ink thick");
  f.label(view.px({crossing.x(), -crossing.y()}), "the trochoid crosses the involute: {d_Ff}",
          Anchor::start, {12, 5}, "halo");
  f.label(view.px(polar(r, -0.52)), "{d}", Anchor::start, {6, -6}, "halo");
  f.label(view.px(polar(gear.base_radius(), -0.52)), "{d_b}", Anchor::start, {6, 4}, "green halo");
  const Arc& fillet = *gear.tooth->outline.find(ArcName::root_fillet);
  const Vec2 low = fillet.point(0.45);
  f.label(view.px({low.x(), -low.y()}), "trochoid", Anchor::end, {-12, 8}, "g2 halo");
  const Vec2 high = flank.point(0.75);
  f.label(view.px({high.x(), -high.y()}), "involute", Anchor::start, {12, -4}, "g1 halo");
  f.label({846, 590}, "9 teeth, x = 0, rack ISO 53 A; undercut without x ≥ 0.474", Anchor::end,
          Vec2::Zero(), "soft small halo");
  return f;
}

}  // namespace gearwright::figures
