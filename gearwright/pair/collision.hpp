// Where two finished outlines strike each other besides flank on flank, and what that means: the
// bodies overlap, or contact leaves the flanks while the gears still turn.
//
// A fact about outlines first [T2.29]…[T2.33]; the findings of interference.hpp, which go by the
// names of circles and corners, then only say why.
#pragma once

#include <optional>
#include <string>

#include "gearwright/pair/outline_gap.hpp"

namespace gearwright {

/// Which parts strike each other.
enum class CollisionCause {
  negative_backlash,  ///< the flanks themselves
  root,               ///< a tip below the mating gear's root circle
  tip_to_fillet,
  tip_corner,
  trochoid,
  tip_bulge,
  outline,      ///< parts without a name
  form_circle,  ///< of beyond_flank only, and the next
  base_tangent,
};
const char* to_string(CollisionCause cause);

/// Two parts of the pair's outlines that strike each other.
struct Collision {
  CollisionCause cause;
  int gear;      ///< whose root, or whose tip that stands out; 0: both alike
  double depth;  ///< mm along the common normal: of an overlap in the middle of the play, of
                 ///< a strike beyond the flank how much earlier than the flanks
  std::optional<OutlineTouch> touch;  ///< where; none: a named circle says it, not the outlines
  std::string message;                ///< one sentence
};

}  // namespace gearwright
