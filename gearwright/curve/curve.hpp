// A plane curve, the element of every outline: point, tangent and curvature at a parameter.
//
//   t    the curve's own parameter (roll angle of an involute, edge parameter of an envelope)
//   W    point as a complex number x + iy, mm
//                                                          theory: docs/theory/01-frames.md
//
// Curves are immutable and shared. An envelope contains the curve that generates it, so a pinion
// that is cut by a rack can itself be the cutter of a wheel. Code that has a closed form for one
// class of curves checks whether a curve belongs to this class.
#pragma once

#include <memory>
#include <string_view>

#include "gearwright/base/contract.hpp"
#include "gearwright/base/vector.hpp"

namespace gearwright {

struct CurvePoint {
  Vec2 point;            ///< mm
  double tangent_angle;  ///< rad, direction in which t grows; not limited to one turn
  double curvature;      ///< 1/mm, > 0 where the tangent turns counter-clockwise
};

class Curve {
 public:
  virtual ~Curve() = default;
  virtual Vec2 point(double t) const = 0;
  /// Point, tangent and curvature at t. They do not depend on the speed at which t runs along the
  /// curve, and the envelope of a curve requires nothing else.
  virtual CurvePoint at(double t) const = 0;

  /// arg W(t) [T1.1], rad, in (−π, π]. In a subclass that overrides this function, the result is
  /// continuous along the curve and may leave this range.
  virtual double polar_angle(double t) const;
  /// The parameter between t_lo and t_hi at which |W| = ρ. If ρ is outside the range of |W|, the
  /// nearer end is returned. A subclass may have a closed form.
  ///
  /// Domain  |W| increases from t_lo to t_hi
  virtual double parameter_at_radius(double rho, double t_lo, double t_hi) const;
  virtual bool radius_is_closed_form() const { return false; }
};

using CurvePtr = std::shared_ptr<const Curve>;

/// The curve as a pointer to the class Kind; null if the curve is of another class.
template <class Kind>
const Kind* curve_if(const Curve& curve) {
  return dynamic_cast<const Kind*>(&curve);
}

/// The curve as a reference to the class Kind.   Domain: the curve is of this class (contract)
template <class Kind>
const Kind& curve_as(const Curve& curve) {
  const Kind* known = curve_if<Kind>(curve);
  GW_EXPECTS(known != nullptr);
  return *known;
}

/// Calls `visit` with the curve as a pointer to the first of the listed classes to which it
/// belongs. If it belongs to none of them, `visit` gets a pointer to the base class Curve.
template <class Kind, class... Others, class Visitor>
auto visit_curve(const Curve& curve, const Visitor& visit) {
  if (const Kind* known = curve_if<Kind>(curve)) return visit(known);
  if constexpr (sizeof...(Others) > 0)
    return visit_curve<Others...>(curve, visit);
  else
    return visit(&curve);
}

// The five parts of the outline of half a tooth, from root to tip (ISO 21771). Each arc of a cutter
// generates one part.

enum class ArcName { root_land, root_fillet, flank, tip_fillet, tip_land };

std::string_view to_string(ArcName name);

}  // namespace gearwright
