// The bore of a gear's body and its keyway, for the files that machines read.
#pragma once

namespace gearwright {

struct Bore {
  double diameter;            ///< mm
  double keyway_width = 0.0;  ///< mm, 0: no keyway
  double keyway_depth = 0.0;  ///< mm, into the hub from the bore, along +y of the gear frame
};

}  // namespace gearwright
