// The gap around a touch on a ridge, [T8.25] of docs/theory/08-contact.md. Internal to contact/.
#pragma once

#include "gearwright/contact/contact_point.hpp"

namespace gearwright::detail {

/// Domain    a touch whose active bound is a ridge (contract)
/// Accuracy  to the first order in the slopes, as [T8.3]
ContactRidge ridge_at(Transmission& transmission, const PairTouch& touch);

}  // namespace gearwright::detail
