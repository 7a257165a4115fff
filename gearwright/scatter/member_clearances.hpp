// Computes the clearances of tips and flanks of one member of the family.
//
//   a + ΔC   centre distance of the member        ΔE_sn   change of the tooth thickness
//   ρ_F      radius of curvature at the start of the usable flank
//                                    theory: docs/theory/14-scatter.md, [T14.31]
// Internal to scatter/.
#pragma once

#include <array>
#include <optional>

#include "gearwright/scatter/tolerance.hpp"

namespace gearwright {

/// Clearances of the tips and of the flanks of gear 1 and gear 2, mm.
struct MemberClearances {
  std::array<std::optional<double>, 2> tip, form;
};

/// Returns the clearances of a pair with this centre distance and these thicknesses. Tilts of the
/// axes do not change the clearances.
///
/// Formula   [T14.31]
/// None      if the nominal axes cross, if the teeth are not involutes, or if there is no working
///           pressure angle. With a changed thickness, also if the teeth are cut by a pinion
///           cutter, have a circular root fillet, or have a tip that the cutter determines. An
///           undercut tooth with a changed thickness has no form clearance
/// Laws      (1) the clearances are equal to those of a new pair with this centre distance and
///           these thicknesses
MemberClearances clearances_of(const ContactSetup& setup, const Deviation& deviation);

}  // namespace gearwright
