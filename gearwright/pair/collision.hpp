// Collisions of two finished outlines. In a collision, either the bodies overlap, or parts other
// than the flanks touch while the gears can still turn.
//
// Collisions are computed from the outlines [T2.29]…[T2.33]. The findings of interference.hpp are
// based on circles and corners, and are used only to explain collisions.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "gearwright/pair/outline_gap.hpp"

namespace gearwright {

enum class CollisionCause {
  negative_backlash,  ///< the flanks overlap
  root,               ///< a tip that reaches below the mating gear's root circle
  tip_to_fillet,
  tip_corner,
  trochoid,
  tip_bulge,
  outline,       ///< parts without a name
  form_circle,   ///< only in beyond_flank
  base_tangent,  ///< only in beyond_flank
};
const char* to_string(CollisionCause cause);

/// Two parts of the pair's outlines that collide.
struct Collision {
  CollisionCause cause;
  int gear;      ///< the gear whose root, flank or projecting tip collides; 0 for both gears
  double depth;  ///< mm along the common normal. For an overlap, its depth in the middle of the
                 ///< play. For a contact beyond the flank, the distance by which this contact
                 ///< precedes the contact of the flanks. For the cause `root` and for collisions
                 ///< found from a circle, the distance beyond the circle or the base tangent point
  std::optional<OutlineTouch> touch;  ///< position of the contact; none if the collision was found
                                      ///< from a circle, and for `root` of a crossed internal pair
                                      ///< and `negative_backlash` of a crossed pair
  std::string message;                ///< one sentence
};

struct CauseMeaning {
  CollisionCause cause;
  const char* text;      ///< its name in results
  const char* sentence;  ///< the sentence of docs/spec.md
};

std::span<const CauseMeaning> collision_causes();

}  // namespace gearwright
