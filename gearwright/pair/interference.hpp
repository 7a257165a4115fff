// Finds interference of two mounted gears. The functions complete a pair whose gears, mesh and
// distances are already set. Internal to pair/.
#pragma once

#include "gearwright/pair/involute_pair.hpp"

namespace gearwright::detail {

/// Computes contact root diameters and form clearances. The function may add the findings
/// `base_tangent`, `form_circle` or `contact_lost_to_undercut`.
void find_form_clearance(InvolutePair& pair);
/// Computes the clearances between tips and roots. The function may add the findings
/// `no_tip_clearance` or `root`. In an internal pair on crossed axes, the clearances are least at
/// an end of a face. [T2.23], [T4.37]
void find_tip_clearance(InvolutePair& pair);
/// Computes the margins of an internal pair against involute, trochoid and trimming interference.
/// The function may add the finding `trochoid` or the warning `trimming`. [T2.27], [T2.28]
void find_internal_margins(ParallelPair& pair);
/// Computes the clearances between tip corners and fillets. The function may add the finding
/// `tip_to_fillet`. [T2.26]
void find_fillet_clearance(ParallelPair& pair);
/// Finds overlap of the outlines and contact beyond the flanks, and computes the free play.
/// `half_play` is half the play of the flanks as a rotation of gear 2. `normal_play` is the whole
/// play along the normal, mm. [T2.29]…[T2.33]
///
/// Domain    parallel axes, and both gears with a tooth
void find_collisions(MountedGears& pair, double half_play, double normal_play);
/// Calls find_collisions() for an involute pair. On crossed axes, tips are compared only with the
/// mating fillets [T4.33] and, if one gear is internal, with the mating flanks. Unless a tip
/// extends below a root circle, the function then removes all findings that do not explain an
/// overlap from `interference`, and adds a finding for each unexplained overlap. It is therefore
/// called last.
void find_overlap(ParallelPair& pair);
void find_overlap(CrossedPair& pair);

}  // namespace gearwright::detail
