// A flank cut with another lead angle: the pitch cylinder is unchanged, lead and section change.
//
//   λ = π/2 − |β|   lead angle        Δλ   its change, rad, as `cutter_lead1_deg`
//                                     theory: docs/theory/08-contact.md, [T8.14]
#pragma once

#include <optional>

#include "gearwright/gear/gear.hpp"

namespace gearwright {

/// The twist 1/p that a gear with the given twist and the pitch radius r has after the change.
/// Domain  Δλ = 0 where there is no lead to change (a spur gear), else 0 < λ + Δλ < π (contract)
double with_cutter_lead(double twist, double pitch_radius, double delta_lambda);

/// A flank arc as the same rack cuts it with its lead angle changed; ends at the same radii.
/// Domain  arcs that a rack cuts, unless Δλ = 0 (contract)
Arc recut(const Arc& arc, const Gear& gear, double delta_lambda);

/// The whole half tooth that the same rack then leaves, with root fillet and tip and with new ends.
/// None if the root was not cut by a rack (but by a pinion cutter, or if a circular fillet replaces
/// it), or if no tooth is left.
std::optional<Outline> recut_outline(const Gear& gear, double delta_lambda);

}  // namespace gearwright
