#include "gearwright/cad/brep.hpp"

#include "gearwright/cad/brep_shell.hpp"

namespace gearwright {

Brep add_brep(Part21& out, const ToothedBody& body, const BodyWalls& walls) {
  const bool ring = body.outline.teeth < 0;
  const double b = body.face_width;
  brep::ShellWriter shell(out);
  const brep::Rims teeth =
      shell.add_walls(walls.teeth, walls.helix, b, ring ? brep::Side::against : brep::Side::along);
  return shell.close(body, walls, teeth);
}

}  // namespace gearwright
