// Page 3: a rack rolls over a gear of nine teeth. The envelope of its edge is the tooth. The flank
// is an involute and the fillet a trochoid, with undercut in this example.
#include <cmath>

#include "docs/figures/figure.hpp"
#include "gearwright/generation/rack_envelope.hpp"
#include "gearwright/report/gear_figures.hpp"

namespace gearwright::figures {

namespace {

// Returns the cutter's edge on the side y ≥ 0, from the middle of a cutter tooth to the end of its
// flank, but at most to `highest` above the datum line. The section is the normal one, which is
// also the transverse one here (β = 0).
std::vector<Vec2> edge_points(const CutterEdge& edge, double module, double highest) {
  std::vector<Vec2> points{{-edge.tip_depth, kPi * module / 2},
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
  CylindricalSpec spec;
  spec.teeth = 9;
  spec.normal_module = 10;
  spec.face_width = 20;
  const Gear gear = gear_of(spec);
  const double r = gear.reference_diameter / 2;
  const auto made = make_edge(spec.straight_rack(), spec.normal_module, spec.normal_pressure_angle);
  const std::vector<Vec2> side = edge_points(made->edge, spec.normal_module, 10.0);
  const double pitch = kPi * spec.normal_module;
  Figure f = plane_figure(
      "03-rack-and-generation", "A rack cuts a tooth",
      "Positions of a rack's edge seen from a gear of 9 teeth, and the tooth that they leave: "
      "involute, trochoid, and the crossing where undercut ends the flank.",
      window({0, 45.5}, {860, 600}, 16));

  // The teeth of the cutter on both sides of the gear's tooth. When the gear has turned by `angle`,
  // the cutter has moved by r · `angle`. The centre line of the gear's tooth points up.
  std::vector<Vec2> cutter;
  for (auto p = side.rbegin(); p != side.rend(); ++p) cutter.push_back(*p);
  for (const Vec2& p : side) cutter.push_back({p.x(), pitch - p.y()});
  const auto cut_at = [&](double angle, const char* style) {
    for (const double moved : {0.0, pitch}) {
      std::vector<Vec2> points = cutter;
      for (Vec2& p : points) p += Vec2(r, -r * angle - moved);
      f.line(placed(std::move(points), angle + kHalfPi, Vec2::Zero()), style);
    }
  };
  const auto up = [](const Vec2& p) { return Vec2(-p.y(), p.x()); };

  add_gear(f, gear, "gear", "neighbour", Vec2::Zero(), kHalfPi);
  for (int i = -13; i <= 13; ++i) cut_at(i * 0.06, "leader");
  f.circle(Vec2::Zero(), r, "thin dashdot", -1);
  f.circle(Vec2::Zero(), gear.base_radius(), "thin dash", -1);
  add_upright_arcs(f, gear, arc_style);

  // One position. A point of the flank is cut when its normal passes through the pitch point P.
  const Arc& flank = *gear.tooth->outline.find(ArcName::flank);
  const CurvePoint cut = flank.at(0.62);
  // The tangent of the flank is the turned tangent of the rack's edge, at the angle `angle` − α.
  const double angle = cut.tangent_angle + spec.normal_pressure_angle.rad();
  const Vec2 pitch_point = up(polar(r, angle)), touch = up(cut.point);
  cut_at(angle, "curve action-curve");
  f.line({pitch_point, touch}, "action-line");
  f.dot(touch, 4.5, "mark action-dot");
  f.dot(pitch_point, 4.5, "mark action-dot");
  f.text(pitch_point, "pitch point", Anchor::end, "halo here", {-9, -7});
  f.text(touch, "W", Anchor::start, "letter halo here", {9, 14});

  const Vec2 crossing = upright(flank.begin_point);
  f.dot(crossing, 6, "mark ring");
  f.text(crossing, markup("the trochoid crosses the involute: {d_Ff}"), Anchor::start, "halo",
         {12, 5});
  f.text(up(polar(r, -0.52)), markup("{d}"), Anchor::start, "halo", {6, -6});
  f.text(up(polar(gear.base_radius(), -0.52)), markup("{d_b}"), Anchor::start, "halo", {6, 4});
  const Arc& fillet = *gear.tooth->outline.find(ArcName::root_fillet);
  f.text(upright(fillet.point(0.45)), "trochoid", Anchor::end, "halo", {-12, 8});
  f.text(upright(flank.point(0.75)), "involute", Anchor::start, "halo", {12, -4});
  f.text({kInfinity, -kInfinity}, "9 teeth, x = 0, rack ISO 53 A; undercut without x ≥ 0.474",
         Anchor::end, "tick halo", {-14, -10});
  return {f, 860};
}

}  // namespace gearwright::figures
