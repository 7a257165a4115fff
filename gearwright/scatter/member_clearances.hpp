// Computes the clearances of tips and flanks of one member of the family.
//
//   a + ΔC   centre distance of the member        ΔE_sn   change of the tooth thickness
//   ρ_F      radius of curvature at the start of the usable flank
//                                    theory: docs/theory/14-scatter.md, [T14.31]
// Internal to scatter/.
#pragma once

#include <array>

#include "gearwright/scatter/tolerance.hpp"

namespace gearwright {

/// Clearances of the tips and of the flanks of gear 1 and gear 2, mm. NaN marks an absent number.
struct MemberClearances {
  std::array<double, 2> tip, form;
};

/// The clearances of a pair with this centre distance and these thicknesses. Tilted axes do not
/// change them.
///
/// Formula   [T14.31]
/// NaN       if the axes of the drawing cross, for teeth that are not involutes, and without a
///           working pressure angle. If the thickness changes, also NaN for teeth that a pinion
///           cutter has cut, with a circular root fillet, or whose tip the cutter determines; the
///           form clearance also if the tooth is undercut
/// Laws      (1) they are those of a pair made anew with this centre distance and these thicknesses
MemberClearances clearances_of(const ContactSetup& setup, const Deviation& deviation);

}  // namespace gearwright
