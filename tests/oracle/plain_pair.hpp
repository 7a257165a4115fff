// The parts of the plain search that depend on the geometry of a gear: radii, tooth thickness,
// centre distance, and the shifts within the limits of a single gear. The notation is explained in
// plain_search.hpp.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "tests/oracle/plain_search.hpp"

namespace gearwright::oracle::plain {

struct Interval {
  long double low, high;

  long double length() const { return high - low; }
  long double middle() const { return low + (high - low) / 2; }
  long double at(long double t) const { return t == 1 ? high : low + t * (high - low); }
};

/// A problem with two numbers of teeth, and derived values that do not depend on the shifts. `gear`
/// is 1 or 2.
struct Pair {
  /// Throws    std::invalid_argument with the reason if the problem or the pair is invalid
  Pair(const PlainProblem& problem, int z1, int z2);

  PlainProblem problem;
  int z1, z2;
  long double sigma;            ///< σ
  long double alpha_t;          ///< α_t
  long double r[2], r_b[2];     ///< reference and base radii
  long double u;                ///< |z_2|/z_1
  long double base_pitch;       ///< p_bt
  long double standard_centre;  ///< C_0  without shifts
  long double base_centre;      ///< r_b2 + σ r_b1, the least centre distance

  bool is_ring(int gear) const { return gear == 2 && z2 < 0; }
  long double tip_radius(int gear, long double x) const;
  long double root_radius(int gear, long double x) const;
  /// ρ of the flank at the tip. NaN if the tip is below the base circle.
  long double tip_curvature(int gear, long double x) const;
  /// ρ_F at the end of the flank that the straight edge of the cutter generates. It is < 0 if the
  /// gear is undercut, and not defined for an internal gear.
  long double form_curvature(int gear, long double x) const;
  /// s_an. NaN if the tip is below the base circle.
  long double tip_thickness(int gear, long double x) const;
  /// The lower limit of the shift, from undercut and `floor`; −∞ if there is none.
  long double min_shift(int gear) const;

  /// C as a function of S, extended or tight; NaN if there is none.
  long double centre_distance(long double sum) const;
  /// N; NaN below the sum of the base radii.
  long double tangent_length(long double sum) const;
  /// The values of S that give a range of centre distances. Absent if there are none.
  std::optional<Interval> shift_sums(Interval centres) const;
  /// The values of S for which the centre distance is not below the sum of the base radii.
  Interval shift_sum_domain() const;
};

PlainPoint look(const Pair& pair, long double x1, long double x2);

/// The intervals between the first and the last node on which f ≥ 0. f changes its sign at most
/// once between neighbours.   Accuracy  64 halvings of their distance
std::vector<Interval> where_not_negative(const std::function<long double(long double)>& f,
                                         const std::vector<long double>& nodes);

/// The shifts of a gear within the limits of undercut, tip thickness, `floor` and `ceil`.
struct Pieces {
  std::vector<Interval> held;  ///< in ascending order
  bool close_call = false;     ///< true if moving a limit by 1e-9 changes the number of intervals
};

Pieces shifts_1(const Pair& pair);
/// An internal gear may have no limits of its own. Then only the window is searched.
Pieces shifts_2(const Pair& pair, long double window_low, long double window_high);

}  // namespace gearwright::oracle::plain
