// Interference of two mounted gears. Internal to pair/: completes a pair whose gears, mesh,
// distances and tip clearances are set.
#pragma once

#include "gearwright/pair/involute_pair.hpp"

namespace gearwright::detail {

/// Contact root diameters and form clearances; base_tangent, form_circle, or contact_lost.
void find_form_clearance(InvolutePair& pair);
/// Clearances of tips and roots, [T2.23]; `root`. On crossed axes with an internal gear, they are
/// least at an end of a face. [T4.37]
void find_tip_clearance(InvolutePair& pair);
/// Internal pairs: involute, trochoid and trimming interference. [T2.27], [T2.28]
void find_internal_margins(ParallelPair& pair);
/// Tip corners to fillets; `tip_to_fillet`. [T2.26]
void find_fillet_clearance(ParallelPair& pair);
/// Overlap of the outlines, strikes beyond the flanks and the free play of two gears whose flanks
/// have this play: half of it as a turn of gear 2, all of it along the normal, mm. [T2.29]…[T2.33]
/// `saddle`, mm, is the depth to which flanks overlap beside their line of action.
///
/// Domain    both gears with a tooth. On crossed axes, tips are compared with roots [T4.33] and, in
///           an internal gear, with flanks
void find_collisions(MountedGears& pair, double half_play, double normal_play, double saddle = 0.0);
/// find_collisions() for an involute pair. Leaves in `interference` the findings that explain an
/// overlap, and must be called last.
void find_overlap(InvolutePair& pair, double saddle);

}  // namespace gearwright::detail
