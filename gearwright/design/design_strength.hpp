// Computes the strength and the mass of a design. The pair is rated according to ISO 6336, with the
// functions of the verb `rate`.
//
//   S_H, S_F   safety factors of flank and root of each gear, at the shifts of the design
//
// The rating needs values of a mounted pair. If the path of contact lies on the involute parts of
// the flanks, all these values have a closed form. For an internal gear, the closed form also needs
// data of the cutter (RingCuts). If there is no closed form, for example because of undercut, the
// gears are cut and mounted. This takes a hundred times as long.
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
/// Returns the row with its safety factors. The face width is the smallest one of the band with
/// sufficient safety factors. If there is no such width, the greatest width of the band is used. If
/// drawings are checked, the row also contains the verdict on the drawing. If pair_of_design()
/// returns an error, the row is returned unchanged.
DesignRow rated(const ShiftGraph& graph, DesignRow row);
/// Returns the first limit that the row violates: a safety factor that is too low or has no value,
/// or the verdict. The result is absent if the row meets all limits.
std::optional<Limit> short_of(const SearchProblem& problem, const DesignRow& row);
/// Returns the smallest of S_H/S_Hmin and S_F/S_Fmin of both gears. A limit that is not given is 1.
/// The result is absent if the row has no safety factors.
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

// RingCuts stores the pinion cutters chosen for the internal gears of a search.
//
// The strength of an internal gear depends on the number of teeth and the tip rounding of its
// cutter, and its path of contact depends on the radius at which its fillet begins. These values are
// known only after a tooth has been generated, which takes as long as a hundred ratings. In modules,
// they depend only on the number of teeth, the rack, the helix angle and the profile shift.
// One stored result therefore serves all wheels that have the same values of these four quantities.
//                                              theory: docs/theory/09-design-search.md, 9.7

/// The cutter of an internal gear, and the start of its fillets. If every cutter would remove a
/// part of the flanks, there is no cutter, and the start of the fillets is infinite.
struct RingCut {
  int cutter_teeth = 0;                                           ///< z_0; 0 without a cutter
  double form_radius = std::numeric_limits<double>::infinity();   ///< d_Ff/2, modules
  double tip_rounding = std::numeric_limits<double>::infinity();  ///< ρ_a0, modules
};

class RingCuts {
 public:
  /// Returns the cut that cut_by_default() chooses for the wheel of `trial` with the profile shift
  /// `shift`. The result is absent if the gear cannot exist. Thread-safe.
  std::optional<RingCut> of(const SearchProblem& problem, const Trial& trial, double shift);

  /// Returns the number of stored cuts, which is a measure of the work.
  std::size_t size() const;

 private:
  using Key = std::tuple<int, double, Angle, Angle, double, double, double>;
  mutable std::mutex mutex_;
  std::map<Key, std::optional<RingCut>> cuts_;
};

}  // namespace gearwright
