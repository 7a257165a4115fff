// The table of the causes of a collision, with the name of each in results and a sentence for
// documents.
#pragma once

#include <span>

#include "gearwright/pair/collision.hpp"

namespace gearwright {

struct CauseMeaning {
  CollisionCause cause;
  const char* text;      ///< its name in results
  const char* sentence;  ///< the sentence of docs/spec.md
};

std::span<const CauseMeaning> collision_causes();

}  // namespace gearwright
