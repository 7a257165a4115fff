// Computes where one flank touches another: the greatest T over the part D of flank 1 that lies
// inside flank 2, by Newton steps with all eight bounds of D.
//
//   s, z   place on flank 1, scaled to [−1, 1] inside
//                                    theory: docs/theory/08-contact.md, [T8.9]
//
// Bounds, in this order: s from below and above, z, then u and Z of flank 2.
#pragma once

#include <vector>

#include "gearwright/contact/feasible_step.hpp"
#include "gearwright/contact/gap_field.hpp"

namespace gearwright {

struct Touch {
  enum class Stop {
    converged,  ///< the last step was below 1e-7 of the patch and is taken into account
    no_room,    ///< D is empty
    too_long    ///< the steps did not end
  };
  Stop stop = Stop::no_room;
  double te = 0.0;          ///< T  rad
  double s = 0.0, z = 0.0;  ///< on flank 1
  double s2 = 0.0;          ///< on flank 2
  detail::ActiveSet active;
  std::array<double, 2> multiplier{};  ///< of the active bounds, rad per scaled bound
  bool flat = false;                   ///< T is flat along one direction to rounding: line contact
  int evaluations = 0;

  bool found() const { return stop == Stop::converged; }
};

/// Work done, for tests and benches.
struct TouchCount {
  long evaluations = 0;
  long searches = 0;
  long cold_starts = 0;
};

class TouchSearch {
 public:
  /// `mesh_azimuth`: 0 or π, where gear 1 meets gear 2; `reach`: distance from there, rad, within
  /// which points of gear 1 can lie inside gear 2. The caller owns the field, which must not move.
  TouchSearch(const GapField& field, double mesh_azimuth, double reach);

  /// Searches from a place, with the bounds that were active there.
  Touch from(double s, double z, double s2, const detail::ActiveSet& active) const;
  /// Searches from the best of a few places, otherwise from everywhere. This is sufficient if there
  /// is one maximum.
  Touch from_middle() const;
  /// Searches from everywhere: a grid, then every peak over the sections, and both end sections of
  /// D.
  Touch cold() const;
  /// Like cold(), but returns all local maxima, the greatest first. Flanks with a topography have a
  /// maximum for each crest, and every section is a start of its own.
  std::vector<Touch> every_maximum() const;

  /// True if a flank has a topography, so that T may have many maxima.
  bool uneven() const;

  const TouchCount& count() const { return count_; }
  const GapField& field() const { return field_; }
  /// Bound j at a point, scaled: ≥ 0 inside.
  double bound(const GapJet& at, double s, double z, int j) const;

 private:
  struct Scale {
    double s_mid, s_half, z_mid, z_half, u_width, Z_width;
  };
  void fill(const GapJet& at, double s, double z, detail::StepProblem& p) const;
  /// The interval of z in which flank 1 can be in mesh. Returns false if it is empty.
  bool window(double& z_lo, double& z_hi) const;
  bool within_a_turn(const Touch& t) const;
  /// Starts on uneven flanks: s, z and s2.
  std::vector<std::array<double, 3>> crests(double z_lo, double z_hi) const;

  const GapField& field_;
  double mesh_azimuth_, reach_;
  Scale scale_;
  mutable TouchCount count_;
};

}  // namespace gearwright
