// The backlash of any pair, of involutes or circular arcs, in its four forms.
#pragma once

#include <array>
#include <optional>

#include "gearwright/pair/pair.hpp"

namespace gearwright {

struct PairBacklash {
  double normal_base;                        ///< j_bn  mm, along the common normal
  double normal;                             ///< j_n   mm
  std::array<double, 2> circumferential;     ///< j_wt  mm, at the working pitch circles
  std::array<Angle, 2> rotation;             ///< j_φ   of each gear, with the other one held
  std::optional<std::array<Angle, 2>> free;  ///< the part of the rotation without collisions
};

/// The backlash of a pair; none for arcs without a point of contact.
std::optional<PairBacklash> backlash_of(const Pair& pair);

}  // namespace gearwright
