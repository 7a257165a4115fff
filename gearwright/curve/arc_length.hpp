// Arc length of a curve: the length up to the parameter t, and the parameter at the length s.
//
//   W(t)   point of the curve, mm           s(t) = ∫ |W'| dt from t0, mm       L = s(t1)
//
// A Curve provides points but no speed, so the speed is computed from points. On panels of [t0,
// t1], which are halved until the series converges, W is interpolated at Chebyshev points (degree
// 16), differentiated, and |W'| is integrated term by term (Trefethen, Approximation Theory and
// Approximation Practice, ch. 19, 21).
//
// Arc length reduces the number of poles: the trochoid of a rounded cutter tip is parametrised by
// the angle of a rack normal, which concentrates its speed at one end. A quintic with uniform knots
// and an error of 1e-6 mm needs 25 poles there, and 13 by arc length (20 teeth, module 2). For a
// curve with a cusp at its end the opposite is true.
//
//   Laws  (1) parameter(0) = t0 and parameter(L) = t1, bit for bit
//         (2) parameter(length_to(t)) = t up to rounding divided by the speed
//         (3) walking the curve backwards gives the same length
#pragma once

#include <array>
#include <vector>

#include "gearwright/curve/curve.hpp"

namespace gearwright {

class ArcLength {
 public:
  /// Domain    t0 ≠ t1 (contract); if t1 < t0, the curve is walked backwards and s still grows from 0
  /// Accuracy  |error of L| < 1e-13 (L + max|W|) for curves analytic on [t0, t1], cusps at an end
  ///           included; otherwise error_estimate() returns the remaining error. At most 1024
  ///           panels.
  ArcLength(const Curve& curve, double t0, double t1);

  double length() const { return length_; }  ///< L  mm

  /// t at the distance s from the start; an s outside [0, L] is moved to the nearer end.
  double parameter(double s) const;

  /// s at t; a t outside [t0, t1] is moved to the nearer end.
  double length_to(double t) const;

  /// mm: the first neglected terms of all panels, summed.
  double error_estimate() const { return error_estimate_; }

  int panels() const { return static_cast<int>(panels_.size()); }

 private:
  static constexpr int kDegree = 16;
  using Series = std::array<double, kDegree + 2>;  // coefficients of Chebyshev polynomials

  struct Panel {
    double t_begin;
    double t_end;
    double s_begin;    ///< arc length before this panel, mm
    double s_end;      ///< arc length to its end, mm
    Series speed;      ///< |dW/dx|, x in [−1, 1] over the panel, mm
    Series travelled;  ///< its integral from x = −1, mm
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
