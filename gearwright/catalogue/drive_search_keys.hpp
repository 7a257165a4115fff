// The keys of [search] with `kind`: a search for whole drives.
#pragma once

#include "gearwright/catalogue/key.hpp"

namespace gearwright {

const KeyTable& drive_search_keys();

}  // namespace gearwright
