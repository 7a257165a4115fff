// Computes the strength and the mass of a design. The pair is rated by ISO 6336 with the functions
// that the verb `rate` uses.
//
//   S_H, S_F   safety factors of flank and root of each gear, at the shifts of the design
//
// The rating uses values of a mounted pair. If the path of contact lies on the involute parts of
// the flanks, all these values have a closed form. For an internal gear, the closed form also uses
// data of its cutter (RingCuts). If there is no closed form, for example because of undercut, the
// gears are cut and mounted, which takes a hundred times as long.
//                                              theory: docs/theory/09-design-search.md, 9.7
#pragma once

#include <limits>
#include <map>
#include <mutex>
#include <optional>
#include <tuple>

#include "gearwright/design/design_row.hpp"
#include "gearwright/design/search_problem.hpp"

namespace gearwright {

/// Returns the pair of a design in the form that the rating requires. The pair is computed from
/// closed forms if possible, and otherwise from mounted gears.
///
/// Errors    those of make_gear, mount and rated_pair
/// Accuracy  both methods agree to 1e-12 (design/design_strength_test.cpp)
Result<RatedPair> pair_of_design(const ShiftGraph& graph, const DesignRow& row);
/// The pair of a design, computed from gears that are cut and mounted.
Result<RatedPair> mounted_design(const ShiftGraph& graph, const DesignRow& row);
/// Returns the row with its safety factors. The face width is the smallest one of the band that
/// gives sufficient safety factors. If none gives sufficient safety factors, the face width is the
/// greatest one of the band. If drawings are checked, the row also contains the verdict on the
/// drawing.
DesignRow rated(const ShiftGraph& graph, DesignRow row);
/// The first limit that the row violates: a safety factor that is too low or has no value, or the
/// verdict. Absent if the row meets all limits.
std::optional<Limit> short_of(const SearchProblem& problem, const DesignRow& row);
/// The smallest of S_H/S_Hmin and S_F/S_Fmin of both gears. A limit that is not given counts as 1.
/// Absent if the row has no safety factors.
std::optional<double> least_safety(const SearchProblem& problem, const DesignRow& row);
/// The body of a gear for its mass, with the density in kg/mm³ and lengths in mm.
struct GearBody {
  double density, face_width;
  int teeth;  ///< < 0 for an internal gear
  double tip_diameter, root_diameter, normal_module;

  /// Mass, kg. An external gear is a full cylinder of the mean diameter (d_a + d_f)/2, as for the
  /// reduced mass of ISO 6336-1. An internal gear extends from the mean diameter to 2.5 m_n outside
  /// its root circle. [T9.12]
  double mass() const;
};
/// Mass of the bodies of both gears, kg.
double mass_of(const ShiftGraph& graph, const DesignRow& row);

// Stores the pinion cutters chosen for the internal gears of a search.
//
// The strength of an internal gear depends on the number of teeth of its cutter. Its path of
// contact depends on the radius at which its fillet begins. Both values are known only after a
// tooth has been generated, which takes as long as a hundred ratings. If the radius is measured in
// modules, both values are equal for all wheels with the same number of teeth, rack, helix angle
// and profile shift.
//                                              theory: docs/theory/09-design-search.md, 9.7

/// The cutter of an internal gear, and the start of its fillets. If every cutter would remove a
/// part of the flanks, there is no cutter, and the start of the fillets is unknown.
struct RingCut {
  int cutter_teeth = 0;                                          ///< z_0; 0 without a cutter
  double form_radius = std::numeric_limits<double>::infinity();  ///< d_Ff/2, modules
};

class RingCuts {
 public:
  /// The cut that cut_by_default() chooses for the wheel of `trial` with the profile shift `shift`.
  /// Absent if the gear cannot exist. Thread-safe.
  std::optional<RingCut> of(const SearchProblem& problem, const Trial& trial, double shift);

  /// The number of stored cuts, as a measure of the work.
  std::size_t size() const;

 private:
  using Key = std::tuple<int, double, Angle, Angle, double, double, double>;
  mutable std::mutex mutex_;
  std::map<Key, std::optional<RingCut>> cuts_;
};

}  // namespace gearwright
