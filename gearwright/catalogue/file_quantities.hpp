// The quantities of files and outlines. The results of `run` and `export` contain `files`, and the
// result of `outline` contains `arcs`.
#pragma once

#include <optional>
#include <string>

#include "gearwright/catalogue/drawing_keys.hpp"
#include "gearwright/catalogue/quantity.hpp"
#include "gearwright/generation/outline.hpp"

namespace gearwright {

struct FileView {
  std::string file, what, note;
  std::optional<double> deviation;  ///< mm; greatest distance from the exact surface or outline
};
const Quantities<FileView>& file_quantities();

struct ArcView {
  const Arc* arc;
  int points;  ///< number of points, including both ends
};
const Quantities<ArcView>& outline_quantities();

// The texts of the title block, from the table [drawing] of the spec. A result contains them under
// `drawing`.

const Quantities<DrawingInput>& drawing_quantities();

}  // namespace gearwright
