// Reads [errors], [contact] and [compensate]. Internal to spec/: throws SpecError.
#pragma once

#include "gearwright/spec/compensate_input.hpp"
#include "gearwright/spec/contact_input.hpp"
#include "gearwright/spec/table_reader.hpp"

namespace gearwright {

ErrorsInput read_errors(const Json& node);
ContactInput read_contact(const Json& node);
CompensateInput read_compensate(const Json& node);

/// What an error may be: the same limits wherever it is given.
void check_error(const TableReader& t, const std::string& key, std::size_t index, double value);

}  // namespace gearwright
