// A gear cut by a pinion cutter: a finished gear, rolling with it at generating centre distance.
//
//   E    generating centre distance, mm
//   x    follows from E: cutter and gear mesh there without backlash
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

/// The reason why a cutter cannot cut a gear of that many teeth at any distance; empty if it can.
std::optional<Error> check_cutter(const Gear& cutter, int teeth);

/// The generating centre distance that gives the gear the profile shift x.
///
/// Errors    `profile_shift` where the cutter has no such place
Result<double> generating_distance(const Gear& cutter, int teeth, double profile_shift);

/// Makes the gear. Module, pressure angle and |β| are those of the cutter. An internal gear has the
/// hand of the cutter, and an external gear has the opposite hand.
///
/// Domain    `cutter` is an external involute gear that exists (contract)
/// Errors    `teeth`, `cut_by`, `tip_diameter`, `face_width`
Result<Gear> make_pinion_cut_gear(const Gear& cutter, const PinionCutSpec& spec);

}  // namespace gearwright
