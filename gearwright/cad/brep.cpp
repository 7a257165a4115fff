#include "gearwright/cad/brep.hpp"

#include "gearwright/cad/brep_shell.hpp"

namespace gearwright {

namespace {

using brep::Rims, brep::ShellWriter, brep::Side;

Rims add_teeth(ShellWriter& shell, const SolidGear& gear, const GearFaces& faces, Side side) {
  const BodyWalls& walls = faces.walls;
  const std::vector<Band> bands = gear.bands();
  const bool two = bands.size() == 2;
  const auto add = [&](const Band& band, const HelixSpline& helix, bool mirrored,
                       const brep::Rim* base) {
    if (!faces.fit) return shell.add_walls(walls.teeth, helix, band, side, base);
    const auto modified = [&](const ModifiedFit& fit) {
      return brep::add_modified_teeth(shell, *gear.body->modified, band, fit, side, base);
    };
    return mirrored ? modified(in_mirror(*faces.fit)) : modified(*faces.fit);
  };
  Rims teeth = add(bands.front(), walls.helices.front(), two, nullptr);
  if (!two) return teeth;
  const bool grooved = gear.body->grooved();
  const Rims upper = add(bands.back(), walls.helices.back(), false, grooved ? nullptr : &teeth.top);
  if (grooved) {
    const double half = gear.body->two_helices->gap / 2.0;
    shell.add_neck(gear.body->two_helices->groove_radius, {teeth.top, gear.height - half},
                   {upper.bottom, gear.height + half}, side);
  }
  teeth.top = upper.top;
  return teeth;
}

}  // namespace

Brep add_brep(Part21& out, const ToothedBody& body, const std::vector<GearFaces>& faces) {
  const Side side = body.ring() ? Side::against : Side::along;
  const std::vector<SolidGear> gears = body.gears();
  ShellWriter shell(out);
  Rims teeth = add_teeth(shell, gears.front(), faces.front(), side);
  for (std::size_t i = 1; i < gears.size(); ++i) {
    const Rims next = add_teeth(shell, gears[i], faces[i], side);
    shell.add_neck(gears[i].body->neck, {teeth.top, gears[i - 1].top()},
                   {next.bottom, gears[i].bottom()}, side);
    teeth.top = next.top;
  }
  return shell.close(body, faces.front().walls, teeth);
}

}  // namespace gearwright
