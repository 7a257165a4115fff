// Computes one gear of a trial: the limits of its profile shift, and the values that depend only on
// the number of teeth, the helix angle and the rack. All lengths are in normal modules.
//
//   r, r_b    reference and base radius, negative for an internal gear (ISO 21771 signs), so that
//             |r_a| = |r + h_a + x + k| and the other formulas hold for external and internal gears
//   h_a, h_f  addendum and dedendum of the rack
//   h_F       depth of the straight edge of the rack
//   k         tip alteration; ≤ 0 if tips are shortened at tight centres, otherwise 0
//                                              theory: docs/theory/09-design-search.md, 9.1
#pragma once

#include <cmath>
#include <optional>
#include <vector>

#include "gearwright/design/search_problem.hpp"

namespace gearwright {

struct TrialGear {
  int teeth = 0;                   ///< z, signed
  double r = 0.0, r_b = 0.0;       ///< signed
  double addendum = 0.0;           ///< h_a
  double dedendum = 0.0;           ///< h_f
  double edge_depth = 0.0;         ///< h_F, for undercut and the clipped path
  double flank_depth = 0.0;        ///< depth of the rack's own straight edge, even if h_F is given;
                                   ///< for interference and form clearance
  double sin_transverse = 0.0;     ///< sin α_t
  double cos_base_helix = 1.0;     ///< cos β_b
  double tan_base_helix = 0.0;     ///< tan β_b, unsigned
  double min_tip_thickness = 0.0;  ///< lower limit of s_an
  double reference_half_angle = 0.0;  ///< s_t/d at x = 0, plus inv α_t for an external gear, minus
                                      ///< inv α_t for an internal gear
  double half_angle_per_shift = 0.0;  ///< 2 tan α_n/|z|
  double x_min = 0.0,
         x_max = 0.0;  ///< limits of x for k = 0; if x_min > x_max, no x is possible
  /// The greatest x at which the tip is thick enough, for k = 0. It is present only for an external
  /// gear whose tip is thick enough at x = 0 and too thin at a great x, which is the usual case.
  std::optional<double> thick_until{};
};

/// Returns the gear and the limits of its shift. The limits follow from undercut (external gears
/// only), from the tip thickness, from the condition that the tip is outside the base circle, and
/// from the problem.
///
/// Units     modules
TrialGear trial_gear(const SearchProblem& problem, int teeth, Angle helix, int rack, int which);

/// Returns the normal tip thickness s_an for the shift x and the tip alteration k, modules. If the
/// flanks intersect below the tip, s_an is negative. [T9.3]
///
/// Domain    |r + h_a + x + k| ≥ |r_b|
double tip_thickness(const TrialGear& gear, double x, double k = 0.0);

/// Returns the greatest x within the limits for the tip alteration k. If k < 0, the result may
/// exceed x_max, because a shortened tip is thicker. If no x is possible, it is less than `x_min`.
double max_shift(const SearchProblem& problem, const TrialGear& gear, double k);
/// Returns a lower bound of max_shift() without solving an equation.
double least_max_shift(const SearchProblem& problem, const TrialGear& gear, double k);

/// Greatest |x| of an internal gear for which trial_gear() computes the tip thickness. If the tip is
/// thick enough as far as this shift, x_min is this shift, which is not a limit of the gear.
inline double farthest_shift(int teeth) { return std::abs(static_cast<double>(teeth)) + 5.0; }

/// Stores the gears for all numbers of teeth with one helix angle and rack, because many trials use
/// the same gears.
class TrialGears {
 public:
  TrialGears(const SearchProblem& problem, int least, int greatest, Angle helix, int rack,
             int which);
  /// Domain    least ≤ teeth ≤ greatest (contract)
  const TrialGear& operator[](int teeth) const;

 private:
  int min_teeth_;
  std::vector<TrialGear> gears_;
};

}  // namespace gearwright
