// The keys of a drive: [planetary], [[stage]] and the graph [drive].
#pragma once

#include "gearwright/catalogue/key.hpp"

namespace gearwright {

const KeyTable& planetary_keys();
const KeyTable& stage_keys();
/// The keys of a gear in the list `gears` of a stage. These are the keys of [gear1] that apply to a
/// drive.
const KeyTable& stage_gear_keys();
const KeyTable& drive_keys();
const KeyTable& drive_body_keys();
const KeyTable& drive_gear_keys();
const KeyTable& drive_mesh_keys();

// The keys of a [search] for whole drives. Such a search has the key `kind`.

const KeyTable& drive_search_keys();

}  // namespace gearwright
