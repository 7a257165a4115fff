// A flank cut with a changed lead angle. The pitch cylinder is unchanged, but the lead and the
// transverse section change.
//
//   λ = π/2 − |β|   lead angle      Δλ   change of λ, rad; the key `cutter_lead1_deg` is in degrees
//                                     theory: docs/theory/08-contact.md, [T8.14]
#pragma once

#include <optional>

#include "gearwright/gear/gear.hpp"

namespace gearwright {

/// The twist after a change of λ, rad/mm. `twist` is the twist before the change.
///
/// Domain    0 < λ + Δλ < π; Δλ = 0 for a spur gear (contract)
double with_cutter_lead(double twist, double pitch_radius, double delta_lambda);
/// Returns the arc that the gear's rack cuts with the changed lead angle. This arc replaces the
/// flank arc `arc`. Its ends have the same radii, or the nearest radii that the new curve reaches.
///
/// Domain    an arc that a rack cuts, unless Δλ = 0 (contract)
Arc recut(const Arc& arc, const Gear& gear, double delta_lambda);
/// Returns the whole half tooth that the gear's rack cuts with the changed lead angle, with root
/// fillet, tip and new ends of the flank. Returns none if no tooth is left, or if a pinion cutter
/// cut the gear. Also returns none if the root or the tip has a circular fillet, because no rack
/// cuts such a fillet.
std::optional<Outline> recut_outline(const Gear& gear, double delta_lambda);

}  // namespace gearwright
