// Shows a rack and its pinion in section. The housing frame is seen from +z with the axis of the
// pinion on the left, the rack on the right and its travel upright.
//
// The pinion turns clockwise, and its leading flank touches the rack at the pitch point C. If there
// is backlash, the gap is at the trailing flank. C lies on the reference circle of the pinion at
// every centre distance.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "gearwright/figure/mesh.hpp"
#include "gearwright/pair/rack_pair.hpp"

namespace gearwright {

struct RackScene {
  const RackPair* pair = nullptr;
  std::array<std::string, 2> shapes;      ///< names of the definitions of pinion and rack
  std::vector<NamedCircle> circles = {};  ///< of the pinion; by default tip, pitch and base circle
};

/// Returns the extent of a picture with this ratio of width to height.
Bounds rack_window(const RackScene& scene, MeshFrame frame, double aspect);

Figure rack_bodies_figure(const RackScene& scene, const Bounds& window);
/// Draws the bodies with circles, datum line, path of contact A–E and both lines of action.
Figure rack_mesh_figure(const RackScene& scene, const Bounds& window);

/// Returns the definition of the rack's shape in its own frame, in units of kOutlineUnit modules.
///
/// Errors    as rack_outline()
Result<std::string> rack_definition(const RackPair& pair, const std::string& name);

/// Returns the section of the rack as one closed line in its own frame (pair/rack_pair.hpp), mm. If
/// the number of teeth is not given, the rack has an odd number of teeth, at least as many as its
/// pinion.
///
/// Accuracy  fillets are chords within kOutlineTolerance modules
/// Errors    as rack_outline()
Result<std::vector<Vec2>> rack_section(const RackPair& pair);

/// Returns the point of the figure at which the origin of the rack lies. The rack is turned by
/// 180°, and its flank touches the leading flank of the pinion at C.
Vec2 rack_place(const RackPair& pair);

/// Returns the counter-clockwise rotation of the pinion that moves its leading flank to C.
///
/// Formula   ψ_1 = s_bt1/d_b1 − inv α_t        Units rad
double rack_pinion_rotation(const RackPair& pair);

}  // namespace gearwright
