// A gear cut by a pinion cutter. The cutter is a gear that rolls with the workpiece at the generating
// centre distance.
//
//   E    generating centre distance, mm
//   x    profile shift with which cutter and gear mesh at E without backlash
//                                              theory: docs/theory/06-few-teeth.md
#pragma once

#include "gearwright/gear/gear.hpp"

namespace gearwright {

struct PinionCutSpec {
  int teeth = 0;                       ///< z, negative for an internal gear
  double distance = 0.0;               ///< E  mm
  double face_width = 0.0;             ///< b  mm
  std::optional<double> tip_diameter;  ///< d_a  mm; by default determined by the cutter's root
};

/// The reason why a cutter cannot cut a gear with this number of teeth at any distance; empty if it can.
std::optional<Error> check_cutter(const Gear& cutter, int teeth);

/// The generating centre distance that gives the gear the profile shift x.
///
/// Errors    `profile_shift` if there is no such distance
Result<double> generating_distance(const Gear& cutter, int teeth, double profile_shift);

/// Makes the gear. The gear has the module, the pressure angle and |β| of the cutter. An internal
/// gear has the same hand as the cutter, and an external gear has the opposite hand.
///
/// Domain    `cutter` is an external involute gear that exists (contract)
/// Errors    `teeth`, `cut_by`, `tip_diameter`, `face_width`
Result<Gear> make_pinion_cut_gear(const Gear& cutter, const PinionCutSpec& spec);

}  // namespace gearwright
