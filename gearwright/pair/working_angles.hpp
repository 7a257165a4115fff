// Computes α_n, the only unknown of the common rack of a pair of gears, from one condition.
//
//   Σ given (crossed axes)     closed form                                             [T4.13]
//   a given (parallel axes)    closed form, because Σ is 0 for every α_n               [T4.12]
//   no backlash, least a       one involute equation, with X = 0                       [T4.15]
//   a given (crossed axes)     no α_n, or one on each side of the least a              [T4.16]
//   contact ratio ≥ 1          an interval of α_n                                      [T4.23]
//
//   g, o   the gear with the greater |β_b|, and the other gear
//   α      α_tg, the transverse pressure angle of g     C, S   cos β_b, sin β_b
//   σ      +1 for an external pair, −1 for an internal pair
//   Q, K, X, u, τ   as in pair/common_rack.hpp     L   distance of the base tangent points along n
//                                              theory: docs/theory/04-conjugate-action.md
//
// The equations are solved for α instead of α_n. All quantities are smooth functions of α over 0 <
// α ≤ π/2, even where β_g is 90°. As functions of α_n, they are not smooth there.
#pragma once

#include <cmath>
#include <optional>
#include <vector>

#include "gearwright/math/root.hpp"
#include "gearwright/pair/common_rack.hpp"

namespace gearwright {

/// Returns the gear g. If α_n increases, the helix angle of g reaches 90° before the helix angle of
/// the other gear.
template <class T>
int limiting_gear(const BasePair<T>& gears) {
  using std::abs;
  return abs(gears[1].helix_angle) > abs(gears[0].helix_angle) ? 1 : 0;
}

/// Returns the angles of the rack with which gear g has the transverse pressure angle α.
///
/// Formula   sin α_n = C_g sin α, u_g = C_g cos α, u_o² = u_g² + S_g² − S_o², C = cos β_b; [T4.14]
template <class T>
RackAngles<T> angles_at_transverse(const BasePair<T>& gears, const T& sin_alpha,
                                   const T& cos_alpha) {
  using std::cos;
  using std::sin;
  using std::sqrt;
  const int g = limiting_gear(gears);
  const T c_g = cos(gears[g].helix_angle);
  const T s_g = sin(gears[g].helix_angle);
  const T s_o = sin(gears[1 - g].helix_angle);
  RackAngles<T> a;
  a.sin_alpha = c_g * sin_alpha;
  a.u[g] = c_g * cos_alpha;
  a.cos_alpha = sqrt(a.u[g] * a.u[g] + s_g * s_g);
  // If |β_b| is equal for both gears, u is also equal, and no square root is needed.
  const T rest = (s_g - s_o) * (s_g + s_o);
  a.u[1 - g] = rest == T(0) ? a.u[g] : T(sqrt(a.u[g] * a.u[g] + rest));
  return a;
}

template <class T>
RackAngles<T> angles_at_transverse(const BasePair<T>& gears, const T& alpha) {
  using std::cos;
  using std::sin;
  return angles_at_transverse(gears, T(sin(alpha)), T(cos(alpha)));
}

/// The rack between gears on parallel axes at the centre distance a: cos α_t = (r_b2 + σ r_b1)/a.
/// [T4.12], [T2.14]
///
/// Domain    a > base_radius_sum > 0 (contract); |β_b1| = |β_b2| to rounding
template <class T>
RackAngles<T> angles_at_parallel_distance(const BasePair<T>& gears, const T& a) {
  using std::sqrt;
  const T sum = base_radius_sum(gears);
  GW_EXPECTS(sum > T(0) && a > sum);
  return angles_at_transverse(gears, T(sqrt((a - sum) * (a + sum)) / a), T(sum / a));
}

/// The range of shaft angles that a crossed pair can have, rad. The ends have the same sign and do
/// not belong to the range.
template <class T>
struct ShaftAngleRange {
  T from;  ///< β_b1 + σ β_b2, the limit for α_n → 0
  T to;    ///< angle at which β_g reaches 90°
  bool contains(const T& sigma) const {
    return from < to ? from < sigma && sigma < to : to < sigma && sigma < from;
  }
};

/// Returns the range of shaft angles of two gears. If from = to, the range is empty, and the axes
/// can only be parallel.
///
/// Formula   cos Σ_max = −σ S_o/S_g; [T4.13]
template <class T>
ShaftAngleRange<T> shaft_angle_range(const BasePair<T>& gears) {
  using std::acos;
  using std::sin;
  const int g = limiting_gear(gears);
  const auto beta = adding_helix_angles(gears);
  const T least = beta[0] + beta[1];
  if (least == T(0)) return {least, least};
  const T greatest = acos(T(-sin(beta[1 - g]) / sin(beta[g])));
  return {least, least > T(0) ? greatest : T(-greatest)};
}

/// Returns the only rack with which both gears roll on crossed axes at the shaft angle Σ.
///
/// Formula   u_1 = (S_2 + S_1 cos Σ)/sin Σ, u_2 likewise,
///           cos² α_n = (S_1² + S_2² + 2 S_1 S_2 cos Σ)/sin² Σ,
///           sin² α_n = (cos(β_b1 + β_b2) − cos Σ)(cos Σ + cos(β_b1 − β_b2))/sin² Σ,
///           with σ S_2 in place of S_2 and σ β_b2 in place of β_b2; [T4.13]. The code uses
///           products, so that no digits cancel on nearly parallel axes
/// Domain    shaft_angle_range contains Σ (contract)
template <class T>
RackAngles<T> angles_at_shaft_angle(const BasePair<T>& gears, const T& sigma) {
  using std::abs;
  using std::cos;
  using std::sin;
  using std::sqrt;
  GW_EXPECTS(shaft_angle_range(gears).contains(sigma));
  const auto [b1, b2] = adding_helix_angles(gears);
  const T s1 = sin(b1);
  const T s2 = sin(b2);
  const T sum = T(2) * sin((b1 + b2) / T(2)) * cos((b1 - b2) / T(2));  // S_1 + S_2
  const T half = sin(sigma / T(2));
  const T versed = T(2) * half * half;  // 1 − cos Σ
  const T sine = sin(sigma);
  RackAngles<T> a;
  a.u = {(sum - s1 * versed) / sine, (sum - s2 * versed) / sine};
  a.cos_alpha = sqrt(sum * sum - T(2) * s1 * s2 * versed) / abs(sine);
  const T below = T(2) * sin((sigma + b1 + b2) / T(2)) * sin((sigma - b1 - b2) / T(2));
  const T above = T(2) * cos((sigma + b1 - b2) / T(2)) * cos((sigma - b1 + b2) / T(2));
  a.sin_alpha = sqrt(below * above) / abs(sine);
  return a;
}

namespace detail {

/// Returns the α at which both gears of an internal pair have the same number z/u³ of virtual teeth
/// in the normal section. At a greater α, Q decreases, and L at X = 0 is negative. [T4.38]
///
/// Domain    the pinion has the greater |β_b|
template <class T>
T transverse_angle_of_equal_virtual_teeth(const BasePair<T>& gears) {
  using std::acos;
  using std::cos;
  using std::pow;
  using std::sin;
  using std::sqrt;
  const T q = pow(T(-gears[1].teeth) / T(gears[0].teeth), T(2) / T(3)) - T(1);
  const T s_1 = sin(gears[0].helix_angle);
  const T s_2 = sin(gears[1].helix_angle);
  const T u_1 = sqrt((s_1 - s_2) * (s_1 + s_2) / q);
  const T c_1 = cos(gears[0].helix_angle);
  return u_1 < c_1 ? T(acos(u_1 / c_1)) : T(0);
}

}  // namespace detail

/// Returns the α at which X = 0. On crossed axes, this is the α of the least centre distance. On
/// parallel axes, it is the α of the backlash-free position. Returns none if the teeth are too
/// thin, or, in an internal pair, too thick.
///
/// Formula   Q(α) = 0; [T4.15], [T5.17]. If |β_b| is equal for both gears, inv α = K/Σ τ d_b cos
///           β_b without iteration; [T2.20]. For internal pairs, the result is the root at which Q
///           increases; [T4.38]
/// Accuracy  ledger rows `least_distance.*`
template <class T>
std::optional<T> transverse_angle_at_min_distance(const BasePair<T>& gears) {
  using std::cos;
  using std::sin;
  const T excess = base_excess(gears);
  std::array<T, 2> weight;  // τ d_b cos β_b
  for (int i : {0, 1})
    weight[i] = side_of(gears[i]) * T(2) * gears[i].radius * cos(gears[i].helix_angle);
  const int g = limiting_gear(gears);
  const T low = excess / (weight[0] + weight[1]);
  if (!(low > T(0))) return std::nullopt;
  const T c_g = cos(gears[g].helix_angle);
  const T k = c_g / cos(gears[1 - g].helix_angle);
  if (k == T(1)) return inverse_involute(low);
  const auto f = [&](const T& alpha) {
    const auto a = angles_at_transverse(gears, alpha);
    Slope<T> s{excess, T(0)};
    for (int i : {0, 1}) {
      using std::atan2;
      const T t = a.sin_alpha / a.u[i];
      s.value -= weight[i] * involute(T(atan2(a.sin_alpha, a.u[i])));
      s.derivative -= weight[i] * t * t * a.u[g] / a.u[i];
    }
    return s;
  };
  T lo = inverse_involute(low);
  T hi = lo;
  T start = lo;
  if (side_of(gears) > T(0)) {
    hi = inverse_involute(T(excess / weight[g]));
    start = inverse_involute(T(excess / (weight[g] + weight[1 - g] * k * k * k)));
  } else if (g == 1) {
    lo = inverse_involute(T(excess / weight[1]));  // the root for the internal gear alone
  } else {
    const auto turn = detail::transverse_angle_of_equal_virtual_teeth(gears);
    if (!(lo < turn) || !(f(turn).value > T(0))) return std::nullopt;
    hi = turn;
  }
  if (start < lo) start = lo;
  if (start > hi) start = hi;
  const auto root = newton_in_bracket<T>(f, lo, hi, start, side_of(gears) < T(0));
  GW_ENSURES(root.found());
  return root.x;
}

/// Returns the α at which the pitch radii of an external pair add up to the centre distance `a`, so
/// that X = 0. If the teeth have no backlash at this α, `a` is the least centre distance of the
/// pair. Returns none if `a` does not exceed the sum of the base radii.
///
/// Formula   Σ r_b cos β_b/u = a; [T4.29]
template <class T>
std::optional<T> transverse_angle_at_pitch_sum(const BasePair<T>& gears, const T& a) {
  using std::acos;
  using std::atan;
  using std::cos;
  if (!(a > base_radius_sum(gears))) return std::nullopt;
  const int g = limiting_gear(gears);
  const auto f = [&](const T& alpha) {
    const auto angles = angles_at_transverse(gears, alpha);
    Slope<T> s{-a, T(0)};
    for (int i : {0, 1}) {
      const T r = gears[i].radius * cos(gears[i].helix_angle) / angles.u[i];
      s.value += r;
      s.derivative += r * angles.sin_alpha * angles.u[g] / (angles.u[i] * angles.u[i]);
    }
    return s;
  };
  // At this α, the pitch radius of gear g is equal to a, so the sum of both radii exceeds a.
  const T hi = acos(gears[g].radius / a);
  const auto root = newton_in_bracket<T>(f, T(0), hi, T(hi / T(2)), true);
  if (!root.found()) return std::nullopt;
  return root.x;
}

namespace detail {

/// The contributions of a gear to the centre distance and to the length of the line of action:
/// α/sin α and (α − sin α cos α)/sin² α.
template <class T>
struct ArcShares {
  T distance, line;
};
template <class T>
ArcShares<T> arc_shares(const T& sin_t, const T& cos_t) {
  using std::atan2;
  const T alpha = atan2(sin_t, cos_t);
  return {alpha / sin_t, (alpha - sin_t * cos_t) / (sin_t * sin_t)};
}

/// a(α) and L(α) of the backlash-free pair, with their derivatives with respect to α. [T4.11],
/// [T4.22]
template <class T>
struct DistanceAndLine {
  Slope<T> a;
  Slope<T> line;
};

template <class T>
DistanceAndLine<T> distance_and_line(const BasePair<T>& gears, const T& alpha) {
  using std::cos;
  using std::sin;
  const int g = limiting_gear(gears);
  const T k = base_excess(gears);
  const T side = side_of(gears);
  const auto angles = angles_at_transverse(gears, alpha);
  const T s = angles.sin_alpha;
  DistanceAndLine<T> d{{k / (T(2) * s), T(0)},
                       {k / (T(2) * s * s), -k * angles.u[g] / (s * s * s)}};
  T q = k;
  for (int i : {0, 1}) {
    const T c = cos(gears[i].helix_angle);
    const T r = side_of(gears[i]) * gears[i].radius;
    const T sin_t = s / c;
    const T cos_t = angles.u[i] / c;
    const auto share = arc_shares(sin_t, cos_t);
    const T slope = angles.u[i] == angles.u[g] ? T(1) : T(angles.u[g] / angles.u[i]);
    d.a.value += r * share.distance;
    d.line.value += r / c * share.line;
    d.line.derivative += r / c * T(2) * (T(1) - cos_t * share.line / sin_t) * slope;
    if (cos_t > T(0)) q -= T(2) * r * c * (sin_t / cos_t - share.distance * sin_t);
  }
  d.a.derivative = -q * angles.u[g] / (T(2) * s * s);
  for (T* of_external : {&d.a.value, &d.a.derivative, &d.line.value, &d.line.derivative})
    *of_external *= side;
  return d;
}

}  // namespace detail

/// An interval of α. `limit` is true if `hi` is the end of the domain, α = π/2.
template <class T>
struct AngleInterval {
  T lo, hi;
  bool limit = false;
};

/// Returns the α at which the backlash-free distance of a crossed pair is a, in ascending order. If
/// a exceeds the least distance, there are two such α. If the greater α exceeds π/2, it is not
/// returned. If a is less than the least distance, there is no such α. If K ≤ 0, a(α) has no
/// minimum, and at most one α is returned.
///
/// Domain    external pair
template <class T>
std::vector<T> transverse_angles_at_distance(const BasePair<T>& gears, const T& a) {
  using std::asin;
  using std::atan;
  using std::cos;
  using std::sin;
  const T half_pi = atan(T(1)) * T(2);
  const auto f = [&](const T& alpha) {
    Slope<T> s = detail::distance_and_line(gears, alpha).a;
    s.value -= a;
    return s;
  };
  std::vector<T> found;
  const auto least = transverse_angle_at_min_distance(gears);
  T from(0);
  if (least) {
    from = *least;
    if (!(f(from).value < T(0))) return found;
    // At the lower end `lo`, the term K/(2 sin α_n) equals a, so the sum of all terms exceeds a.
    const T c_g = cos(gears[limiting_gear(gears)].helix_angle);
    T lo = asin(base_excess(gears) / (T(2) * c_g * a));
    if (lo > from) lo = from;
    found.push_back(newton_in_bracket<T>(f, lo, from, T((lo + from) / T(2)), false).x);
  }
  if (f(half_pi).value > T(0)) {
    found.push_back(newton_in_bracket<T>(f, from, half_pi, T((from + half_pi) / T(2)), true).x);
  }
  return found;
}

/// Returns the interval of α in which the backlash-free pair has 0 ≤ L ≤ `longest`. If `longest` is
/// the length that the tips permit minus one base pitch, the contact ratio is at least 1 in this
/// interval. L is convex in α_n, so there is only one interval. Returns none if L exceeds `longest`
/// at every α.
///
/// Formula   L = Σ r_b/cos β_b · (α_t − sin α_t cos α_t)/sin² α_t + K/(2 sin² α_n); [T4.22]
/// Domain    external pairs
template <class T>
std::optional<AngleInterval<T>> transverse_angles_with_line_within(const BasePair<T>& gears,
                                                                   const T& longest) {
  using std::atan;
  const T half_pi = atan(T(1)) * T(2);
  const T tiny = T(1e-9);  // rad; α_n = 0 does not describe a rack
  const auto above = [&](const T& limit) {
    return [&gears, limit](const T& alpha) {
      Slope<T> s = detail::distance_and_line(gears, alpha).line;
      s.value -= limit;
      return s;
    };
  };
  const auto f = above(longest);
  AngleInterval<T> found{tiny, half_pi, false};
  T bottom(0);
  if (base_excess(gears) > T(0)) {
    // Bisection with the derivative of L finds the α with the least L. Newton's method then finds
    // the ends of the interval on both sides of this α.
    T lo = tiny;
    T hi = half_pi;
    const T narrow(
        1e-12);  // rad; L hardly changes near its minimum, so any near point is sufficient
    for (int i = 0; i < 60 && hi - lo > narrow; ++i) {
      const T middle = (lo + hi) / T(2);
      const auto s = f(middle);
      if (s.value < T(0)) {  // any point with L < longest is sufficient
        lo = hi = middle;
      } else {
        (s.derivative < T(0) ? lo : hi) = middle;
      }
    }
    bottom = (lo + hi) / T(2);
    if (f(bottom).value > T(0)) return std::nullopt;
    found.lo = newton_in_bracket<T>(f, tiny, bottom, T(bottom * T(0.7)), false).x;
  } else {
    const auto zero = above(T(0));
    if (zero(tiny).value < T(0))
      found.lo = newton_in_bracket<T>(zero, tiny, half_pi, T(0.3), true).x;
    bottom = found.lo;
  }
  if (f(half_pi).value > T(0)) {
    found.hi = newton_in_bracket<T>(f, bottom, half_pi, T((bottom + half_pi) / T(2)), true).x;
  } else {
    found.limit = true;
  }
  return found;
}

}  // namespace gearwright
