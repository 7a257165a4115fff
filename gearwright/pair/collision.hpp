// Collisions of two finished outlines other than flank on flank: the bodies overlap, or contact
// leaves the flanks while the gears still turn.
//
// Collisions are computed from the outlines [T2.29]…[T2.33]. The findings of interference.hpp,
// which refer to circles and corners, then only give the reason.
#pragma once

#include <optional>
#include <string>

#include "gearwright/pair/outline_gap.hpp"

namespace gearwright {

/// The parts that collide.
enum class CollisionCause {
  negative_backlash,  ///< the flanks themselves
  root,               ///< a tip below the mating gear's root circle
  tip_to_fillet,
  tip_corner,
  trochoid,
  tip_bulge,
  outline,      ///< parts without a name
  form_circle,  ///< only in beyond_flank, like the next one
  base_tangent,
};
const char* to_string(CollisionCause cause);

/// Two parts of the pair's outlines that collide.
struct Collision {
  CollisionCause cause;
  int gear;      ///< the gear whose root, or projecting tip, collides; 0 for both
  double depth;  ///< mm along the common normal: depth of an overlap in the middle of the play; for
                 ///< contact beyond the flank, how much earlier it is than that of the flanks
  std::optional<OutlineTouch> touch;  ///< place of contact; none if a named circle, and not the
                                      ///< outlines, determines the collision
  std::string message;                ///< one sentence
};

}  // namespace gearwright
