// Computes the point at which two flanks touch. D is the part of flank 1 that lies opposite flank
// 2. The flanks touch at the point of D at which T (gap_field.hpp) is greatest. Newton steps within
// the eight bounds of D lead to this point.
//
//   s, z   point of flank 1, scaled to [−1, 1] internally
//   u, Z   ln ρ and height of the same point in the frame of gear 2 (gap_field.hpp)
//                                    theory: docs/theory/08-contact.md, [T8.9]
//
// The order of the bounds is s, z on flank 1, and u, Z on flank 2, each with the lower bound first.
#pragma once

#include <vector>

#include "gearwright/contact/feasible_step.hpp"
#include "gearwright/contact/gap_field.hpp"

namespace gearwright {

struct Touch {
  enum class Stop {
    converged,  ///< the last step, included in the result, was below 1e-7 of half the patch
    no_room,    ///< D is empty
    too_long    ///< the steps did not converge
  };
  Stop stop = Stop::no_room;
  double te = 0.0;          ///< T  rad
  double s = 0.0, z = 0.0;  ///< the touch on flank 1
  double s2 = 0.0;          ///< parameter of the touch on flank 2
  detail::ActiveSet active;
  std::array<double, 2> multiplier{};  ///< multipliers of the active bounds, rad per scaled bound
  bool flat = false;  ///< true if T is constant in one direction within rounding (line contact)
  int evaluations = 0;
  /// GapField::arm(), mm, and dT/dφ1, rad/rad; both 0 unless LaneSearch found the touch.
  double arm = 0.0, slope = 0.0;

  bool found() const { return stop == Stop::converged; }
};

/// Numbers of evaluations and searches, for tests and benchmarks.
struct TouchCount {
  long evaluations = 0;
  long searches = 0;
  long cold_starts = 0;
};

class TouchSearch {
 public:
  /// `mesh_azimuth` is the azimuth of the mesh on gear 1, 0 or π. `reach` is the greatest angle
  /// from this azimuth, rad, at which points of gear 1 can lie in the annulus of gear 2. The field
  /// must outlive this object.
  TouchSearch(const GapField& field, double mesh_azimuth, double reach);

  /// Searches from the point (s, z) of flank 1, opposite s2 on flank 2. `active` contains the
  /// bounds that are active at this point.
  Touch from(double s, double z, double s2, const detail::ActiveSet& active) const;
  /// Searches from the best of nine points. If this search fails, cold() is used. The result has
  /// the greatest T if T has only one maximum.
  Touch from_middle() const;
  /// Returns the first result of every_maximum(), which has the greatest T. If every_maximum() is
  /// empty, the result is not found().
  Touch cold() const;
  /// Returns all local maxima of the whole flank, the greatest first. The searches start from every
  /// peak of a grid and from the end sections of D. Uneven flanks have a maximum for each crest, so
  /// their searches start from maxima over the profile at several heights.
  std::vector<Touch> every_maximum() const;

  /// True if a flank has a topography or form waves, so that T may have many maxima.
  bool uneven() const;

  const TouchCount& count() const { return count_; }
  const GapField& field() const { return field_; }
  /// Returns the scaled value of bound j at a point. The value is ≥ 0 inside.
  double bound(const GapJet& at, double s, double z, int j) const;

 private:
  struct Scale {
    double s_mid, s_half, z_mid, z_half, u_width, Z_width;
  };
  void fill(const GapJet& at, double s, double z, detail::StepProblem& p) const;
  /// Computes the interval of z in which flank 1 can be in mesh. Returns false if the interval is
  /// empty.
  bool window(double& z_lo, double& z_hi) const;
  bool within_a_turn(const Touch& t) const;
  /// The points (s, z, s2) from which searches on uneven flanks start.
  std::vector<std::array<double, 3>> crests(double z_lo, double z_hi) const;

  const GapField& field_;
  double mesh_azimuth_, reach_;
  Scale scale_;
  mutable TouchCount count_;
};

}  // namespace gearwright
