// The causes of a collision as documents list them, each with its word in results and a sentence.
#pragma once

#include <span>

#include "gearwright/pair/collision.hpp"

namespace gearwright {

struct CauseMeaning {
  CollisionCause cause;
  const char* text;      ///< its word in results
  const char* sentence;  ///< of docs/spec.md
};

std::span<const CauseMeaning> collision_causes();

}  // namespace gearwright
