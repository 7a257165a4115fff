// The keys of [drawing]: the words of a title block. They are printed as given. No date or author
// is added.
#pragma once

#include <string>

#include "gearwright/catalogue/key.hpp"

namespace gearwright {

/// Words of the title block; empty if not given.
struct DrawingInput {
  std::string title, number, author, date, material, note;

  bool given() const {
    return !(title.empty() && number.empty() && author.empty() && date.empty() &&
             material.empty() && note.empty());
  }
};

const KeyTable& drawing_keys();

}  // namespace gearwright
