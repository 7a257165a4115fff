// The keys of [drawing]: the texts of a title block, the surface textures, and the fits of bore and
// keyway. Drawings show these texts unchanged, except that the first word of a surface texture can
// select its symbol. The program adds no date and no author.
#pragma once

#include <string>

#include "gearwright/catalogue/key.hpp"

namespace gearwright {

/// The texts of [drawing]. A text that is not given is empty.
struct DrawingInput {
  std::string title, number, author, date, material, note;
  std::string heat_treatment, surface_texture, edges, general_tolerances;
  std::string flank_roughness, face_roughness, bore_roughness;  ///< "MRR Ra 0.8"
  std::string bore_fit, keyway_fit;                             ///< fits of ISO 286, "H7" and "JS9"

  bool given() const;
};

const KeyTable& drawing_keys();

}  // namespace gearwright
