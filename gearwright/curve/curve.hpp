// A plane curve, the stuff of every outline: a point, a tangent and a curvature at a parameter.
//
//   t    the curve's own parameter (roll angle of an involute, edge parameter of an envelope)
//   W    point as a complex number x + iy, mm
//                                                          theory: docs/theory/01-frames.md
//
// Curves are immutable and shared: an envelope holds the curve that generates it, so that a pinion
// cut by a rack can cut a wheel in its turn. Most of the house knows no more of a curve than its
// points; who has a closed form for one kind of curve asks for its kind.
#pragma once

#include <memory>
#include <variant>

#include "gearwright/base/contract.hpp"
#include "gearwright/base/vector.hpp"

namespace gearwright {

struct CurvePoint {
  Vec2 point;            ///< mm
  double tangent_angle;  ///< rad, direction of growing t, not reduced to one turn
  double curvature;      ///< 1/mm, > 0 where the tangent turns counter-clockwise
};

class Curve;
class AxisCircle;      // curve/basic_curves.hpp
class Involute;        // curve/basic_curves.hpp
class OffsetCircle;    // curve/basic_curves.hpp
class RackTrochoid;    // generation/rack_envelope.hpp
class CornerFan;       // generation/pinion_envelope.hpp
class PinionEnvelope;  // generation/pinion_envelope.hpp

/// A curve as one of the kinds that somebody knows a closed form of; `const Curve*`: none of them.
using CurveKind =
    std::variant<const Curve*, const AxisCircle*, const Involute*, const OffsetCircle*,
                 const RackTrochoid*, const CornerFan*, const PinionEnvelope*>;

class Curve {
 public:
  virtual ~Curve() = default;
  virtual CurveKind kind() const { return this; }
  virtual Vec2 point(double t) const = 0;
  virtual CurvePoint at(double t) const = 0;

  /// arg W(t) [T1.1], rad; continuous along the curve where a subclass knows how, else in (−π, π].
  virtual double polar_angle(double t) const;
  /// The parameter between t_lo and t_hi at which |W| = ρ; |W| grows from t_lo to t_hi, and ρ is
  /// moved into that range. Solved with a bracket unless a subclass has it in closed form.
  virtual double parameter_at_radius(double rho, double t_lo, double t_hi) const;
  virtual bool radius_is_closed_form() const { return false; }
};

using CurvePtr = std::shared_ptr<const Curve>;

/// The curve as one kind; null: it is another.
template <class Kind>
const Kind* curve_if(const Curve& curve) {
  const CurveKind kind = curve.kind();
  const auto* known = std::get_if<const Kind*>(&kind);
  return known ? *known : nullptr;
}

/// The curve as the kind that it is by construction.   Domain: it is of that kind (contract)
template <class Kind>
const Kind& curve_as(const Curve& curve) {
  const Kind* known = curve_if<Kind>(curve);
  GW_EXPECTS(known != nullptr);
  return *known;
}

}  // namespace gearwright
