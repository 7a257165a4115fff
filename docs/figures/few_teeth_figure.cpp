// Page 6: the pinion of two teeth of the example in the paper. Left: its circular fillets, tangent
// to the involute. Right: the pinion in mesh with the wheel of sixty teeth that it has cut.

#include "docs/figures/figure.hpp"
#include "gearwright/figure/gear_shape.hpp"
#include "gearwright/figure/mesh.hpp"
#include "gearwright/gear/pinion_cut.hpp"
#include "gearwright/pair/pair.hpp"
#include "gearwright/report/gear_figures.hpp"

namespace gearwright::figures {

Drawing few_teeth_figure() {
  Drawing f(
      "06-few-teeth", 860, 500, "A pinion of two teeth and the wheel that it cuts",
      "Left, the tooth of a two-tooth pinion with the circles of its fillets. Right, the pinion "
      "in mesh with its wheel of sixty teeth.");
  CylindricalSpec spec;  // Table 1 of Chen and Tsay
  spec.teeth = 2;
  spec.normal_module = 1.75;
  spec.helix_angle = Angle::degrees(30);
  spec.profile_shift = 0.7;
  spec.face_width = 12;
  spec.straight_rack().dedendum = 1.0;
  spec.straight_rack().root_fillet_radius = 0;
  spec.root_fillet = RootFilletSpec{0.01};
  spec.tip_fillet = TipFilletSpec{TipFilletSpec::By::radius, 0.332};
  const Gear pinion = gear_of(spec);
  const auto distance = generating_distance(pinion, 60, -1.4);
  PinionCutSpec cut;
  cut.teeth = 60;
  cut.distance = *distance;
  cut.face_width = 12;
  const auto wheel = make_pinion_cut_gear(pinion, cut);

  const auto pair = mount_as<ParallelPair>(pinion, *wheel, {.center_distance = *distance});
  Figure left = root_plot(pinion, "pinion", "Pinion");
  left.definitions = gear_definition(pinion, "pinion") + gear_definition(*wheel, "wheel");
  left.y.hi += 0.1 * (left.y.hi - left.y.lo);
  left.tall *= 1.1;
  left.text({-kInfinity, kInfinity}, "both circles are centred on a normal of the flank",
            Anchor::start, "halo", {14, 24});
  f.add(left, {0, 0}, 480);

  // Right: the mesh without backlash, seen along the axes.
  const MeshScene scene = mesh_scene(*pair, {"pinion", "wheel"});
  Figure right = mesh_figure(scene, mesh_window(scene, MeshFrame::mesh, 0.8));
  right.text({-kInfinity, kInfinity}, "2 : 60 teeth, module 1.75 mm, β = 30°, x = 0.7, −1.4",
             Anchor::start, "tick halo", {10, 24});
  f.add(right, {495, 20}, 360);
  return f;
}

}  // namespace gearwright::figures
