// The quantities of tooth contact, with positions, patterns and maps. A result contains them under
// `contact`.
#pragma once

#include "gearwright/catalogue/quantity.hpp"
#include "gearwright/contact/contact_view.hpp"

namespace gearwright {

const Quantities<ContactView>& contact_quantities();
const Quantities<ContactPoint>& position_quantities();

}  // namespace gearwright
