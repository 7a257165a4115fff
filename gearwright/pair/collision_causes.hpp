// The table of the causes of a collision: the name of each in results, and a sentence about it.
#pragma once

#include <span>

#include "gearwright/pair/collision.hpp"

namespace gearwright {

struct CauseMeaning {
  CollisionCause cause;
  const char* text;      ///< its name in results
  const char* sentence;  ///< of docs/spec.md
};

std::span<const CauseMeaning> collision_causes();

}  // namespace gearwright
