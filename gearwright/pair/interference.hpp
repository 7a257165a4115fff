// Where two mounted gears get in each other's way. Internal to pair/: fills in a pair whose gears,
// mesh and distances are set.
#pragma once

#include "gearwright/pair/involute_pair.hpp"

namespace gearwright::detail {

/// Contact root diameters and form clearances; base_tangent, form_circle, or contact_lost.
void find_form_clearance(InvolutePair& pair);
/// Tips to roots on the centre line; `root`.
void find_tip_clearance(InvolutePair& pair);
/// Internal pairs: involute, trochoid and trimming interference. [T2.27], [T2.28]
void find_internal_margins(InvolutePair& pair);
/// Tip corners to fillets, parallel axes; `tip_to_fillet`. [T2.26]
void find_fillet_clearance(InvolutePair& pair);

}  // namespace gearwright::detail
