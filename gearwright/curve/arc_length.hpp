// Arc length of a curve: the length up to the parameter t, and the parameter at the length s.
//
//   W(t)   point of the curve, mm           s(t) = ∫ |W'| dt from t0, mm       L = s(t1)
//
// A Curve provides points but no speed |W'|, so the speed is computed from points. The range [t0,
// t1] is divided into panels. On each panel, W is interpolated at Chebyshev points (degree 16), the
// interpolant is differentiated, and the series of |W'| is integrated term by term (Trefethen,
// Approximation Theory and Approximation Practice, ch. 19, 21). A panel on which the series have
// not converged is halved.
//
// A spline through a curve usually needs fewer poles if its parameter is the arc length. For
// example, a quintic spline through the trochoid of a rounded cutter tip needs 13 poles instead of
// 25 for an error of 1e-6 mm. Only a curve with a cusp at its end needs more poles with the arc
// length than with t.
//
//   Laws  (1) parameter(0) = t0 and parameter(L) = t1, to the last bit
//         (2) parameter(length_to(t)) = t up to the rounding error of s divided by the speed
//         (3) exchanging t0 and t1 does not change the length
#pragma once

#include <array>
#include <vector>

#include "gearwright/curve/curve.hpp"

namespace gearwright {

class ArcLength {
 public:
  /// Domain    t0 ≠ t1 (contract); if t1 < t0, s also increases from 0 at t0 to L at t1
  /// Accuracy  |error of L| < 1e-13 (L + max|W|) for curves that are analytic on [t0, t1], even if
  ///           they have a cusp at an end. For other curves, at most 1024 panels are used, and
  ///           error_estimate() returns the remaining error
  ArcLength(const Curve& curve, double t0, double t1);

  double length() const { return length_; }  ///< L  mm

  /// The parameter t at the arc length s. If s lies outside [0, L], the nearer end is used.
  double parameter(double s) const;
  /// The arc length s at the parameter t. If t lies outside [t0, t1], the nearer end is used.
  double length_to(double t) const;
  /// Error estimate for L, mm. Each panel contributes the greatest of the last three coefficients
  /// of its speed, divided by the degree of the series.
  double error_estimate() const { return error_estimate_; }

  int panels() const { return static_cast<int>(panels_.size()); }

 private:
  static constexpr int kDegree = 16;
  using Series = std::array<double, kDegree + 2>;  // coefficients of Chebyshev polynomials

  struct Panel {
    double t_begin;
    double t_end;
    double s_begin;    ///< arc length before this panel, mm
    double s_end;      ///< arc length at the end of this panel, mm
    Series speed;      ///< |dW/dx| with x in [−1, 1] over the panel, mm
    Series travelled;  ///< integral of `speed` from x = −1, mm
  };

  void add(const Curve& curve, double t_begin, double t_end, double scale, int depth);
  static double value(const Series& series, double x);

  double t0_;
  double t1_;
  double length_ = 0.0;
  double error_estimate_ = 0.0;
  std::vector<Panel> panels_;
};

}  // namespace gearwright
