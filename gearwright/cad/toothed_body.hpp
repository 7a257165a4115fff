// What the CAD rooms need of a gear: one outline, screwed along the face, with an optional bore.
//
//   τ    twist, rad/mm: 2π/lead, signed, > 0 right hand, 0 spur
//   b    face width, mm; the body fills −b/2 ≤ z ≤ b/2, the outline is its section z = 0
//
// The section at height z is the section z = 0 turned by τz. Tip, root and bore are cylinders.
#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <string>

#include "gearwright/base/error.hpp"
#include "gearwright/gear/bore.hpp"
#include "gearwright/generation/outline.hpp"

namespace gearwright {

struct ToothedBody {
  std::string name;         ///< "gear1", the name a CAD tree shows
  Outline outline;          ///< half a tooth; |outline.teeth| copies make the gear
  double twist = 0.0;       ///< τ  rad/mm
  double face_width = 0.0;  ///< b  mm
  std::optional<Bore> bore;
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();  ///< gear frame to housing frame
};

/// Of `teeth`, for the reason `why`.
inline Error not_a_body(int teeth, const std::string& why) {
  return {"teeth", std::to_string(teeth),
          "the outline bounds no body, " + why + "; more teeth or more profile shift help"};
}

}  // namespace gearwright
