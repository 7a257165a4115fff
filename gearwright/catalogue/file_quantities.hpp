// The quantities of files and outlines: `files` of `run` and `export`, `arcs` of `outline`.
#pragma once

#include <optional>
#include <string>

#include "gearwright/catalogue/quantity.hpp"
#include "gearwright/generation/outline.hpp"

namespace gearwright {

struct FileView {
  std::string file, what, note;
  std::optional<double> deviation;  ///< mm, from the exact surface or outline
};
const Quantities<FileView>& file_quantities();

struct ArcView {
  const Arc* arc;
  int points;  ///< both ends included
};
const Quantities<ArcView>& outline_quantities();

}  // namespace gearwright
