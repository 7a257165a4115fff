// Reads [errors], [contact] and [compensate]. Internal to spec/: throws SpecError.
#pragma once

#include "gearwright/catalogue/compensate_keys.hpp"
#include "gearwright/catalogue/contact_keys.hpp"
#include "gearwright/spec/table_reader.hpp"

namespace gearwright {

ErrorsInput read_errors(const Json& node);
ContactInput read_contact(const Json& node);
CompensateInput read_compensate(const Json& node);

}  // namespace gearwright
