// The quantities of tooth contact under `contact`, with positions, patterns and maps.
#pragma once

#include "gearwright/catalogue/quantity.hpp"
#include "gearwright/contact/contact_view.hpp"

namespace gearwright {

const Quantities<ContactView>& contact_quantities();
const Quantities<ContactPoint>& position_quantities();

}  // namespace gearwright
