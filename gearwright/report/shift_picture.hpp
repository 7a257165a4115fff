// One tooth at several profile shifts: the root that the rack cuts, and a circular one instead.
//
//   x    profile shift         x_E  the same with the thickness allowance
//                                              theory: docs/theory/06-few-teeth.md
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "gearwright/gear/gear.hpp"

namespace gearwright {

/// The tooth at one shift.
struct ShiftedTooth {
  double shift;                 ///< x
  bool own;                     ///< the gear's own shift
  Gear rack_cut;                ///< without circular fillets; may not exist
  std::optional<Gear> rounded;  ///< with the circular root fillet, where one fits
};

/// Whether shifting is the question: at most 8 teeth, cut by a rack, with a circular root fillet or
/// undercut.
bool shift_is_worth_a_picture(const Gear& gear);

/// The gear at x = 0.3, 0.5, 0.7, 0.9, 1.0 and its own shift, by growing x, with tips as the rack
/// has them. The root fillet is the gear's, else begins at the undercut limit; with it goes the
/// gear's tip fillet where one fits.
///
/// Domain    shift_is_worth_a_picture (contract)
std::vector<ShiftedTooth> shifted_teeth(const Gear& gear);

/// The figures, drawn to one scale; empty where they say nothing.
std::string shift_figures(const Gear& gear, const std::string& shape, const std::string& name);

}  // namespace gearwright
