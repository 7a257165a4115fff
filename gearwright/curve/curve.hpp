// A plane curve, the element of every outline: point, tangent and curvature at a parameter.
//
//   t    the curve's own parameter (roll angle of an involute, edge parameter of an envelope)
//   W    point as a complex number x + iy, mm
//                                                          theory: docs/theory/01-frames.md
//
// Curves are immutable and shared. An envelope holds the curve that generates it, so a pinion cut
// by a rack can itself cut a wheel. Most code uses only the points of a curve; code with a closed
// form for one class of curves queries its class. This room names no class of a higher one.
#pragma once

#include <memory>

#include "gearwright/base/contract.hpp"
#include "gearwright/base/vector.hpp"

namespace gearwright {

struct CurvePoint {
  Vec2 point;            ///< mm
  double tangent_angle;  ///< rad, direction of growing t, not reduced to one turn
  double curvature;      ///< 1/mm, > 0 where the tangent turns counter-clockwise
};

class Curve {
 public:
  virtual ~Curve() = default;
  virtual Vec2 point(double t) const = 0;
  virtual CurvePoint at(double t) const = 0;

  /// arg W(t) [T1.1], rad; continuous along the curve if a subclass implements it, otherwise in
  /// (−π, π].
  virtual double polar_angle(double t) const;
  /// The parameter between t_lo and t_hi at which |W| = ρ; |W| grows from t_lo to t_hi, and ρ is
  /// moved into that range. Solved with a bracket unless a subclass has it in closed form.
  virtual double parameter_at_radius(double rho, double t_lo, double t_hi) const;
  virtual bool radius_is_closed_form() const { return false; }
};

using CurvePtr = std::shared_ptr<const Curve>;

/// The curve as one class; null if it is of another class.
template <class Kind>
const Kind* curve_if(const Curve& curve) {
  return dynamic_cast<const Kind*>(&curve);
}

/// The curve as a class that is known by construction.   Domain: it is of that class (contract)
template <class Kind>
const Kind& curve_as(const Curve& curve) {
  const Kind* known = curve_if<Kind>(curve);
  GW_EXPECTS(known != nullptr);
  return *known;
}

/// Calls `visit` with a pointer to the first of the classes that the curve has, and otherwise with
/// a pointer to the curve itself.
template <class Kind, class... Others, class Visitor>
auto visit_curve(const Curve& curve, const Visitor& visit) {
  if (const Kind* known = curve_if<Kind>(curve)) return visit(known);
  if constexpr (sizeof...(Others) > 0)
    return visit_curve<Others...>(curve, visit);
  else
    return visit(&curve);
}

}  // namespace gearwright
