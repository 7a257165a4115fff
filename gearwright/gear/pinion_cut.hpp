// Makes gears that are cut by a pinion cutter. The cutter is a gear that rolls with the workpiece
// at the generating centre distance.
//
//   E    generating centre distance, mm
//   x    profile shift with which cutter and gear mesh at E without backlash
//                                              theory: docs/theory/06-few-teeth.md
#pragma once

#include "gearwright/gear/gear.hpp"

namespace gearwright {

struct PinionCutSpec {
  int teeth = 0;                          ///< z, negative for an internal gear
  double distance = 0.0;                  ///< E  mm
  double face_width = 0.0;                ///< b  mm
  std::optional<double> tip_diameter{};   ///< d_a  mm; by default determined by the cutter's root
  double thickness_allowance = 0.0;       ///< E_sn  mm
  std::optional<double> profile_shift{};  ///< x; set if E was computed from this x and the
                                          ///< allowance
};

/// Returns the reason why the cutter cannot cut a gear with this number of teeth at any distance.
/// Returns none if such a distance exists.
std::optional<Error> check_cutter(const Gear& cutter, int teeth);

/// Returns E_sn/(2 m_n tan α_n), the part of x_E that a thickness allowance E_sn, mm, causes.
double shift_of_allowance(const Gear& cutter, double allowance);

/// Returns the generating centre distance that gives the gear the profile shift x.
///
/// Errors    `profile_shift` if there is no such distance; as check_cutter()
Result<double> generating_distance(const Gear& cutter, int teeth, double profile_shift);

/// Makes the gear. The gear has the module, the pressure angle and |β| of the cutter. An internal
/// gear has the same hand as the cutter, and an external gear has the opposite hand.
///
/// Domain    `cutter` is an external involute gear that exists (contract)
/// Errors    `teeth`, `cut_by` or `tip_diameter` if the cutter cannot cut this gear; as
///           check_limits()
Result<Gear> make_pinion_cut_gear(const Gear& cutter, const PinionCutSpec& spec);

/// The material that a pinion cutter removes from the tip of an internal gear beyond the generated
/// flank.
struct InfeedCut {
  double arc;  ///< mm, at the tip form circle, from each flank; ≤ 0 if the cutter trims nothing
  double distance;  ///< e  mm, centre distance at which the cutter trims
};
/// Returns the trimming in radial infeed, where the rolling cutter approaches the generating
/// distance from the axis of the gear.
///
/// Formula   [T6.18], greatest value over all points of the cutter above its root fillet
/// Domain    both teeth have an outline, the ring is internal (contract)
/// None      if the ring has no flank, or if no point of the cutter has a limiting position before
///           the cutter reaches E
std::optional<InfeedCut> infeed_cut(const GeneratedTooth& cutter, const GeneratedTooth& ring,
                                    double distance);

// The default pinion cutter of an internal gear, which is used if the drawing names no cutter.
//
// A drawing of an internal gear gives tip, root and thickness of the teeth. It seldom gives the
// cutter, which determines the root fillet. The default cutter has no profile shift. Its tip
// reaches the root circle of the internal gear and is rounded like the basic rack of the internal
// gear.
//                            theory: docs/theory/06-few-teeth.md, 6.5

/// Returns the internal gear with a tooth that a cutter of |z|/2 teeth has cut. If this cutter
/// would remove part of the flank, a cutter with another tip rounding or number of teeth is used.
/// The warnings are made anew, and all other data of the gear are unchanged. Returns none if none
/// of the cutters that are tried leaves the whole flank up to the tip.
///
/// Domain    `ring` is an internal gear without a tooth (contract)
std::optional<Gear> cut_by_default(const Gear& ring);

/// Makes the gear. The tooth of an internal gear is cut by the default cutter, if there is one.
///
/// Errors    as make_gear()
Result<Gear> make_gear_with_default_cutter(const CylindricalSpec& spec);

}  // namespace gearwright
