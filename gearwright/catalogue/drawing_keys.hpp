// The keys of [drawing]: the texts of a title block, the surface textures, and the fits of bore and
// keyway. Drawings show them as given, and no date or author is added.
#pragma once

#include <string>

#include "gearwright/catalogue/key.hpp"

namespace gearwright {

/// A text is empty if it is not given.
struct DrawingInput {
  std::string title, number, author, date, material, note;
  std::string heat_treatment, surface_texture, edges, general_tolerances;
  std::string flank_roughness, face_roughness, bore_roughness;  ///< "MRR Ra 0.8"
  std::string bore_fit, keyway_fit;                             ///< fits of ISO 286, "H7" and "JS9"

  bool given() const;
};

const KeyTable& drawing_keys();

}  // namespace gearwright
