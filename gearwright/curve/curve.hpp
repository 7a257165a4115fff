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

#include <cmath>
#include <memory>
#include <numbers>
#include <string_view>
#include <type_traits>

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
  /// Point, tangent and curvature at t. Tangent and curvature do not depend on the speed |dW/dt|.
  /// The envelope of a curve is computed from these values only.
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

/// A complex number x + iy of any scalar type.
template <class T>
struct Plane {
  T x, y;
};

template <class T>
Plane<T> times(const Plane<T>& a, const Plane<T>& b) {
  return {a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x};
}

/// The jets of curves, as templates over the scalar T. T is double in the program and a number of 50
/// digits in the accuracy ledger, whose functions are found by the namespace of their arguments.
namespace jets {

using std::abs, std::atan2, std::cos, std::hypot, std::isinf, std::sin, std::sqrt;

/// w e^{i angle}
template <class T>
Plane<T> turned(const Plane<T>& w, const T& angle) {
  const T c = cos(angle), s = sin(angle);
  return {w.x * c - w.y * s, w.x * s + w.y * c};
}

/// π
template <class T>
T half_turn() {
  if constexpr (std::is_floating_point_v<T>)
    return std::numbers::pi_v<T>;
  else
    return atan2(T(0), T(-1));
}

/// The derivatives ℓ′ and ℓ″ of ℓ = ln W with respect to the parameter of a curve.
template <class T>
struct LogSlopes {
  Plane<T> d1, d2;
};

}  // namespace jets

/// A curve whose values are views of its jet. Self::jet(t) returns a value with the members
///
///     Plane<T> point()      T tangent_angle()      T curvature()
///
/// Each member computes only the terms that it needs. If the jet also has a member `T
/// polar_angle()`, polar_angle() returns its value instead of the argument of the point. The jet of
/// a flank in contact also has the members from which polar_jet() makes a PolarJet.
template <class Self>
class JetCurve : public Curve {
 public:
  Vec2 point(double t) const final { return vector(jet(t).point()); }
  CurvePoint at(double t) const final {
    const auto j = jet(t);
    return {vector(j.point()), j.tangent_angle(), j.curvature()};
  }
  double polar_angle(double t) const final {
    if constexpr (requires(const Self& s) { s.jet(t).polar_angle(); })
      return jet(t).polar_angle();
    else
      return Curve::polar_angle(t);
  }

 private:
  static Vec2 vector(const Plane<double>& p) { return {p.x, p.y}; }
  auto jet(double t) const { return static_cast<const Self&>(*this).jet(t); }
};

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
