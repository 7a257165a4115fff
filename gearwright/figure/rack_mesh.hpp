// Shows a rack and its pinion in section. The housing frame is seen from +z with the axis of the
// pinion on the left, the rack on the right and its travel upright.
//
// The pinion turns clockwise and touches with its leading flank at C. If there is backlash, it
// opens on the other side. C is the pitch point, which lies on the reference circle of the pinion
// at every centre distance.
#pragma once

#include <string>
#include <vector>

#include "gearwright/figure/figure.hpp"
#include "gearwright/pair/rack_pair.hpp"

namespace gearwright {

/// Draws the mesh around C, with circles, datum line, path of contact A–E and both lines of action.
/// `shape` is the name of the pinion's definition (gear_shape.hpp).
///
/// Errors    those of rack_outline()
Result<Figure> rack_mesh_figure(const RackPair& pair, const std::string& shape, double aspect);

/// The section of the rack as one closed line in the housing frame, mm. It contains the teeth
/// within `reach` of the centre line and touches the pinion at C.
///
/// Units     mm
/// Accuracy  fillets are chords within kOutlineTolerance modules
/// Errors    those of rack_outline()
Result<std::vector<Vec2>> rack_section(const RackPair& pair, double reach);

/// Rotation of the pinion, counter-clockwise, at which its leading flank passes through C.
///
/// Formula   ψ_1 = s_bt1/d_b1 − inv α_t        Units rad
double rack_pinion_rotation(const RackPair& pair);

}  // namespace gearwright
