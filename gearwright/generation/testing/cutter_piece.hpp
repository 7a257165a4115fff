// A piece of a pinion cutter's outline between two parameters, from its root side to its tip side.
#pragma once

#include <cmath>

#include "gearwright/base/numbers.hpp"
#include "gearwright/generation/circular_fillets.hpp"
#include "gearwright/generation/pinion_envelope.hpp"

namespace gearwright::testing {

struct CutterPiece {
  PinionMotion motion;
  CurvePtr curve;
  double root, tip;
  Meeting meeting = Meeting::ahead;

  // At a corner, the tangent has the direction from root to tip, although the angle of the normals
  // decreases.
  bool forward() const { return tip > root || curve_if<CornerFan>(*curve); }
  Walk walk() const { return forward() ? Walk::forward : Walk::backward; }
  PinionEnvelope envelope() const { return {motion, curve, walk(), meeting}; }
  double at(double u) const { return root + u * (tip - root); }
  // Unit tangent in the direction from root to tip.
  Vec2 tangent(double t) const {
    const double a = curve->at(t).tangent_angle + (forward() ? 0.0 : kPi);
    return {std::cos(a), std::sin(a)};
  }
};

}  // namespace gearwright::testing
