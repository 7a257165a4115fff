// Computes the position of a measuring pin in a space of a rack, and the dimension over the pin.
//
//   D_M       diameter of the pin, mm
//   x_M       height of its axis above the datum line, mm
//   e_n       width of the space at the datum line in the normal section, p_n − s_n, mm
//   h_B       height from the back of the rack to the datum line, mm
//   h_a, h_f  addendum and dedendum of the rack, mm      α_n   pressure angle
//                                              theory: docs/theory/10-inspection.md
//
// The pin lies along the teeth, so its section perpendicular to the teeth is a circle, which
// touches both straight flanks.
#pragma once

#include <optional>

#include "gearwright/pair/rack_pair.hpp"

namespace gearwright {

struct RackPin {
  double diameter;   ///< D_M  mm
  double height;     ///< x_M  mm, of the axis above the datum line
  double contact;    ///< mm, height of the contacts above the datum line
  double dimension;  ///< M    mm, from the back of the rack over the pin
};

/// Returns the pin with this diameter. Returns none if it touches the root, touches the flanks
/// beyond the tip, or does not project beyond the tips.
///
/// Formula   x_M = (D_M/cos α_n − e_n)/(2 tan α_n), M = h_B + x_M + D_M/2; [T10.38]
/// Domain    diameter > 0 (contract)
/// Accuracy  closed form
/// Laws      (1) the distance of the axis from both flanks is D_M/2
///           (2) a thickness allowance E_sn changes M by E_sn/(2 tan α_n)
std::optional<RackPin> pin_on_rack(const RackGeometry& rack, double diameter);

/// Returns the pin with RackBar::pin_diameter if this diameter is given and can be measured.
/// Otherwise, returns the measurable size of DIN 3977 that is nearest to e_n/cos α_n, the diameter
/// of a pin that touches at the datum line. Returns none if no size can be measured.
std::optional<RackPin> usual_pin(const RackGeometry& rack);

}  // namespace gearwright
