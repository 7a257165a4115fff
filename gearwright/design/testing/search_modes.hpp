// Mountings that the vector code of the search treats differently.
#pragma once

#include <array>

namespace gearwright::testing::search {

struct Mode {
  const char* name;
  bool ring, tight;
};
inline constexpr std::array<Mode, 4> kModes{{{"external", false, false},
                                             {"ring", true, false},
                                             {"tight", false, true},
                                             {"tight_ring", true, true}}};

}  // namespace gearwright::testing::search
