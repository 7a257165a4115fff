#include "gearwright/cad/brep.hpp"

#include "gearwright/cad/brep_shell.hpp"

namespace gearwright {

Brep add_brep(Part21& out, const ToothedBody& body, const BodyWalls& walls) {
  using brep::Side;
  const Side side = body.ring() ? Side::against : Side::along;
  const std::vector<Band> bands = body.bands();
  brep::ShellWriter shell(out);
  brep::Rims teeth = shell.add_walls(walls.teeth, walls.helices.front(), bands.front(), side);
  if (bands.size() == 2) {
    const brep::Rims upper = shell.add_walls(walls.teeth, walls.helices.back(), bands.back(), side,
                                             body.grooved() ? nullptr : &teeth.top);
    if (body.grooved()) shell.add_groove(body, teeth.top, upper.bottom);
    teeth.top = upper.top;
  }
  return shell.close(body, walls, teeth);
}

}  // namespace gearwright
