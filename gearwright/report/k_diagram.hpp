// The K-diagram of a flank: profile and helix as modified, and the band within which a measured
// trace of this accuracy grade must lie.
//
//   L   roll length, mm       z   height from the middle of the face, mm      deviations in µm, up is
//                                                                             out of the material
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "gearwright/curve/curve.hpp"

namespace gearwright {

/// One trace, either the profile in the middle of the face or the helix in the middle of the
/// profile.
struct FlankTrace {
  std::vector<Vec2> design;          ///< mm, µm; in the order of the first number
  std::array<double, 2> evaluation;  ///< mm
  std::optional<double> tolerance;   ///< µm, F_αT or F_βT
};

struct KDiagram {
  std::string name;  ///< "Gear 1, both flanks", "Gear 1, left flank"
  FlankTrace profile, helix;
};

/// Pictures side by side, with their captions. Empty if there are none.
std::string k_figures(const std::vector<KDiagram>& diagrams);

}  // namespace gearwright
