// Draws the K-diagram of a flank. It shows the design profile and the design helix, and the band
// within which a measured trace must lie for the accuracy grade of the gear.
//
//   L   roll length, mm       z   axial position from the middle of the face, mm
//   deviations in µm, positive out of the material
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "gearwright/catalogue/unit_system.hpp"
#include "gearwright/curve/curve.hpp"

namespace gearwright {

/// One trace of the flank. It is either the profile in the middle of the face, or the helix in the
/// middle of the profile.
struct FlankTrace {
  std::vector<Vec2> design;          ///< points (L or z in mm, deviation in µm), sorted by L or z
  std::array<double, 2> evaluation;  ///< evaluation range, mm
  std::optional<double> tolerance;   ///< µm, F_αT or F_βT
};

struct KDiagram {
  std::string name;  ///< "Gear 1, both flanks", "Gear 1, left flank"
  FlankTrace profile, helix;
};

/// Draws the diagrams with their captions, side by side. The result is empty if there are none.
std::string k_figures(const std::vector<KDiagram>& diagrams, UnitSystem units = UnitSystem::mm);

}  // namespace gearwright
