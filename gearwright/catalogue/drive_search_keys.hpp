// The keys of a [search] for whole drives, which has the key `kind`.
#pragma once

#include "gearwright/catalogue/key.hpp"

namespace gearwright {

const KeyTable& drive_search_keys();

}  // namespace gearwright
