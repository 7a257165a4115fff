// The keys of [drawing]: the words of a title block, and the fits of bore and keyway. They are printed as
// given. No date or author is added.
#pragma once

#include <string>

#include "gearwright/catalogue/key.hpp"

namespace gearwright {

/// Words of the title block, and the fits of bore and keyway; empty if not given.
struct DrawingInput {
  std::string title, number, author, date, material, note;
  std::string heat_treatment, surface_texture, edges, general_tolerances;
  std::string bore_fit, keyway_fit;  ///< of ISO 286, "H7" and "JS9"

  bool given() const;
};

const KeyTable& drawing_keys();

}  // namespace gearwright
