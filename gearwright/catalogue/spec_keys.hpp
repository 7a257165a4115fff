// The tables of a spec file.
#pragma once

#include "gearwright/catalogue/key.hpp"

namespace gearwright {

/// What stands in the file itself: title, [gear1], [gear2], [pair] and so on.
const KeyTable& spec_keys();

/// Every table that spec_keys() leads to, itself first, each once.
std::vector<const KeyTable*> all_key_tables();

}  // namespace gearwright
