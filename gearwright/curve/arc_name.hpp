// The five parts of half a tooth from root to tip (ISO 21771). Each arc of a cutter generates one part.
#pragma once

#include <string_view>

namespace gearwright {

enum class ArcName { root_land, root_fillet, flank, tip_fillet, tip_land };

std::string_view to_string(ArcName name);

}  // namespace gearwright
