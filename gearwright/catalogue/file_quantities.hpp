// The quantities of files and outlines: `files` in a result of `run` and `export`, and `arcs` in a
// result of `outline`.
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

// The title block as a result: `drawing` contains the texts of the table [drawing] of the spec.

const Quantities<DrawingInput>& drawing_quantities();

}  // namespace gearwright
