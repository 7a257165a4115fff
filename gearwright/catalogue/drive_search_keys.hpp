// The keys of [search] if it has the key `kind` and therefore searches for whole drives.
#pragma once

#include "gearwright/catalogue/key.hpp"

namespace gearwright {

const KeyTable& drive_search_keys();

}  // namespace gearwright
