// Page 2: the mesh triangle. The figure shows two base circles, their common tangent and the path
// of contact on it. The teeth are in contact at a point between B and C.
#include <cmath>

#include "docs/figures/figure.hpp"
#include "gearwright/figure/gear_shape.hpp"
#include "gearwright/figure/mesh.hpp"
#include "gearwright/pair/pair.hpp"

namespace gearwright::figures {

Drawing mesh_triangle_figure() {
  Drawing f("02-involute-and-pair", 860, 620, "The mesh triangle",
            "Base circles of a pair of 17 and 23 teeth, the line of action between their base "
            "tangent points, and the points A to E of the path of contact.");
  CylindricalSpec spec;
  spec.teeth = 17;
  spec.normal_module = 10;
  spec.profile_shift = 0.25;
  spec.face_width = 20;
  const Gear one = gear_of(spec);
  spec.teeth = 23;
  const Gear two = gear_of(spec);
  const double alpha_0 = spec.normal_pressure_angle.rad();
  const double a = tight_center_distance(17, 23, 10.0, alpha_0, alpha_0, 1.0, 0.5);
  const auto pair = mount_as<ParallelPair>(one, two, {.center_distance = a});
  const Mesh<double>& m = pair->mesh;
  const Vec2 o_1 = Vec2::Zero(), o_2(a, 0), middle(a / 2 - 6, 8), half(116, 84);
  const MeshScene scene = mesh_scene(*pair, {"one", "two"});
  Figure mesh = mesh_figure(scene, {middle - half, middle + half});
  mesh.definitions = gear_definition(one, "one") + gear_definition(two, "two");

  const auto on = [&](double rho_1) {
    const Vec3 p = pair->on_line_of_action(rho_1).r;
    return Vec2(p.x(), p.y());
  };
  const Vec2 t_1 = on(0), t_2 = on(m.base_tangent_distance);
  const double alpha = m.rack.sides[0].transverse_angle;
  const auto triangle = [&](const Vec2& center, const Vec2& tangent, double turned,
                            const char* style, const char* radius) {
    mesh.line({center, tangent}, style);
    mesh.text(0.5 * (center + tangent), markup(radius), Anchor::end, "halo", {-8, -4});
    mesh.line(arc_points(center, 24, turned, turned + alpha), "one");
    mesh.text(center + polar(30, turned + alpha / 2), markup("{α_wt}"), Anchor::middle, "halo",
              {0, 4});
  };
  triangle(o_1, t_1, 0, "curve g1", "{r_b1}");
  triangle(o_2, t_2, kPi, "curve g2", "{r_b2}");

  // The dimension N is parallel to the line of action, and a is parallel to the centre line.
  const auto dimension = [&](const Vec2& from, const Vec2& to, const Vec2& aside,
                             const char* words) {
    for (const Vec2& end : {from, to}) mesh.line({end, end + 1.04 * aside}, "thin");
    add_arrow(mesh, {from + aside, to + aside}, "thin", true);
    mesh.text(0.5 * (from + to) + aside, markup(words), Anchor::start, "halo", {8, -7});
  };
  dimension(t_1, t_2, 17.6 * Vec2(std::cos(alpha), std::sin(alpha)), "{N} = {a} sin {α_wt}");
  dimension(o_1, o_2, {0, -66}, "{a}");
  f.add(mesh, {0, 0}, 860);
  return f;
}

}  // namespace gearwright::figures
