// Divides the envelope of an arc into monotone pieces. The arc of gear A generates the envelope
// when A rolls with gear B. Along a piece, the distance of the envelope from the axis of B either
// only increases or only decreases. Internal to pair/, for outline_gap. [T2.31]
//
//   u      parameter of the arc, 0 … 1
//   |D|    distance of a point of the envelope from the axis of B
//   |s|    arm of the arc's normal about the axis of A     r_w   pitch radius of A
//
// If |s| > r_w, the normal never passes through the pitch point, and there is no envelope. At
// points where |s| = r_w, both branches of the envelope meet. Near such a point, |D| varies with
// the square root of the distance from the point.
//
//   Laws  (1) |D| is monotone between two nodes, unless the second node begins a piece
//         (2) every piece ends at an end of the arc or of the envelope
//         Both laws require that |s| and |D| have at most one extremum within an eighth of the arc
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include "gearwright/base/contract.hpp"

namespace gearwright::detail {

/// Returns the zero of f to within `near`, by false position with occasional halving. f has
/// different signs at lo and hi and need not be smooth. At the returned argument, the sign of f
/// differs from the sign of `against`.
template <class F>
double zero_between(const F& f, double lo, double f_lo, double hi, double f_hi, double near,
                    double against) {
  const bool lo_is_against = f_lo * against > 0.0;
  for (int i = 0; hi - lo > near; ++i) {
    double t = lo - f_lo * (hi - lo) / (f_hi - f_lo);
    t = i % 3 == 2 ? 0.5 * (lo + hi) : std::clamp(t, lo + 0.1 * near, hi - 0.1 * near);
    const double value = f(t);
    if (value == 0.0) return t;
    if ((value < 0.0) == (f_lo < 0.0)) {
      lo = t;
      f_lo = value;
      f_hi *= 0.5;
    } else {
      hi = t;
      f_hi = value;
      f_lo *= 0.5;
    }
  }
  return lo_is_against ? hi : lo;
}

/// The envelope at a parameter. Only the signs of the slopes along u are used.
struct EnvelopePlace {
  double inside, inside_slope;  ///< r_w − |s|, mm; < 0 if there is no envelope
  double radius, radius_slope;  ///< |D|, mm; if there is no envelope, computed with |s| = r_w
};

struct EnvelopeNode {
  double u, radius;
  bool begins;  ///< true if the node begins a piece and is not connected to the preceding node
};

class EnvelopeNodes {
 public:
  /// `at` returns the EnvelopePlace at a parameter.
  template <class At>
  explicit EnvelopeNodes(const At& at) {
    EnvelopePlace before = at(0.0);
    for (int i = 0; i < kSteps; ++i) {
      const double u_1 = static_cast<double>(i) / kSteps;
      const double u_2 = static_cast<double>(i + 1) / kSteps;
      const EnvelopePlace after = at(u_2);
      if (turn(before.inside_slope, after.inside_slope)) {
        const double u = zero_between([&](double t) { return at(t).inside_slope; }, u_1,
                                      before.inside_slope, u_2, after.inside_slope, kTurning, 0.0);
        const EnvelopePlace middle = at(u);
        reach(at, u_1, before, u, middle);
        reach(at, u, middle, u_2, after);
      } else {
        reach(at, u_1, before, u_2, after);
      }
      before = after;
    }
  }

  const EnvelopeNode* begin() const { return nodes_.data(); }
  const EnvelopeNode* end() const { return nodes_.data() + count_; }

 private:
  static constexpr int kSteps = 8;
  static constexpr double kTurning = 1e-6;  // accuracy of the u at which |s| or |D| is stationary
  static constexpr double kEnding = 1e-14;  // accuracy of the u at which an envelope ends; high,
                                            // because |D| varies with the square root of the
                                            // distance from the end

  static bool turn(double one, double two) { return (one < 0.0) != (two < 0.0); }

  // Adds the nodes of a part of the arc along which |s| is monotone.
  template <class At>
  void reach(const At& at, double u_1, const EnvelopePlace& one, double u_2,
             const EnvelopePlace& two) {
    const bool is_1 = one.inside >= 0.0;
    const bool is_2 = two.inside >= 0.0;
    if (!is_1 && !is_2) {
      joined_ = false;
      return;
    }
    if (is_1 && is_2) return run(at, u_1, one, u_2, two);
    const double end = zero_between([&](double t) { return at(t).inside; }, u_1, one.inside, u_2,
                                    two.inside, kEnding, -1.0);
    is_1 ? run(at, u_1, one, end, at(end)) : run(at, end, at(end), u_2, two);
    joined_ = is_2;
  }

  // Adds the nodes of a part of the arc that has an envelope throughout.
  template <class At>
  void run(const At& at, double u_1, const EnvelopePlace& one, double u_2,
           const EnvelopePlace& two) {
    if (!joined_) add({u_1, one.radius, true});
    joined_ = true;
    if (turn(one.radius_slope, two.radius_slope)) {
      const double u = zero_between([&](double t) { return at(t).radius_slope; }, u_1,
                                    one.radius_slope, u_2, two.radius_slope, kTurning, 0.0);
      add({u, at(u).radius, false});
    }
    add({u_2, two.radius, false});
  }

  void add(const EnvelopeNode& node) {
    GW_EXPECTS(count_ < nodes_.size());
    nodes_[count_++] = node;
  }

  std::array<EnvelopeNode, 6 * kSteps> nodes_;  // a step has at most two parts with three nodes
                                                // each
  std::size_t count_ = 0;
  bool joined_ = false;
};

}  // namespace gearwright::detail
