// Page 7: circular arcs. Left: a tooth cut by rack F in the space cut by rack P, in the normal
// section. Right: the normal angle at the contact as a function of the centre distance.
#include <cmath>

#include <fmt/format.h>

#include "docs/figures/figure.hpp"
#include "gearwright/base/numbers.hpp"
#include "gearwright/pair/arc_pair.hpp"
#include "gearwright/report/pair_figures.hpp"
#include "gearwright/tool/arc_rack.hpp"

namespace gearwright::figures {

namespace {

Gear gear_of_arcs(int teeth, double helix_deg, const ArcRack& rack) {
  CylindricalSpec spec;
  spec.teeth = teeth;
  spec.normal_module = 12.7;
  spec.helix_angle = Angle::degrees(helix_deg);
  spec.face_width = 180;
  spec.rack = rack;
  return gear_of(spec);
}

}  // namespace

Drawing arcs_figure() {
  Drawing f("07-circular-arc", 860, 480, "Circular arcs touch at a point",
            "Normal section of a convex tooth in a concave space with the centres of both arcs on "
            "one normal, and the normal angle at the contact over the change of the centre "
            "distance.");
  // The drive of Litvin and Tsay: 12 : 94 teeth, normal diametral pitch 2, lead angle 75°.
  const double psi = kPi / 6;
  ArcRack convex = default_arc_rack(ArcRack::Cutter::F);
  convex.arc_radius = 1.4;
  convex.center_a = 1.4 * std::cos(psi) - 0.79;
  convex.center_b = 1.4 * std::sin(psi) - 0.79 * std::tan(psi);
  ArcRack concave = default_arc_rack(ArcRack::Cutter::P);
  concave.arc_radius = 1.55;
  concave.center_a = convex.center_a + 0.15 * std::cos(psi);
  concave.center_b = convex.center_b + 0.15 * std::sin(psi);
  const auto pair =
      mount_arcs(gear_of_arcs(12, 15, convex), gear_of_arcs(94, -15, concave), std::nullopt);
  Figure racks = arc_contact_figures(*pair).front();
  racks.text({-kInfinity, kInfinity}, "normal section, both racks at the reference distance",
             Anchor::start, "halo", {10, 20});
  racks.text({-kInfinity, -kInfinity}, "gear 1, cut by F", Anchor::start, "halo g1", {10, -12});
  racks.text({kInfinity, kInfinity}, "gear 2, cut by P", Anchor::end, "halo g2", {-10, 44});
  f.add(racks, {10, 40}, 420);

  // Right: θ over ΔC, exactly and to first order, for a module of 12.7 mm.
  const WorkingArc v = convex_arcs(pair->gears[0]).front();
  const WorkingArc c = concave_arcs(pair->gears[1]).front();
  ArcMeshInput input{v,
                     c,
                     pair->gears[0].reference_diameter / 2,
                     pair->gears[1].reference_diameter / 2,
                     Angle::degrees(75),
                     0.0};
  std::vector<Vec2> exact, first;
  for (int i = 0; i <= 80; ++i) {
    const double change = -0.8 + 1.6 * i / 80;
    input.center_distance = input.pitch_radius_convex + input.pitch_radius_concave + change;
    if (const auto theta = contact_angle(input)) exact.push_back({change, theta->deg()});
    const double sine = (c.b - v.b - change) / (c.radius - v.radius);
    if (std::abs(sine) < 1) first.push_back({change, Angle::radians(std::asin(sine)).deg()});
  }
  Figure angle{
      "angle",
      "Normal angle at the contact",
      "The normal angle at the contact over the change of the centre distance.",
      "",
      {.words = "change of the centre distance",
       .unit = "mm",
       .lo = -0.8,
       .hi = 0.8,
       .symbol = "ΔC"},
      {.words = "normal angle at the contact", .unit = "°", .lo = 0, .hi = 70, .symbol = "θ"}};
  angle.tall = 1.0;
  angle.line(std::move(first), "curve g2 dash");
  angle.line(std::move(exact), "curve g1");
  angle.text({0.0, 60.0}, "exact [T7.16]; first order [T7.17], dashed", Anchor::middle, "halo");
  const double begin = pair->gears[0].arc_cutter()->arcs.back().begin.deg();
  angle.line({{-kInfinity, begin}, {kInfinity, begin}}, "action-line");
  angle.text({-kInfinity, begin}, fmt::format("the flank of F begins, {:.1f}°", begin),
             Anchor::start, "halo", {8, -6});
  angle.point({0, 30}, 4.0, "mark g1", markup("{θ_0} = 30°"), {10.0, -6.0});
  f.add(angle, {440, 0}, 420);
  return f;
}

}  // namespace gearwright::figures
