// The keys of [drawing]: what a title block says beside the numbers. Words as given, nothing is made
// up: no date of today, no author of the machine.
#pragma once

#include <string>

#include "gearwright/catalogue/key.hpp"

namespace gearwright {

/// Empty: not given.
struct DrawingInput {
  std::string title, number, author, date, material, note;

  bool given() const {
    return !(title.empty() && number.empty() && author.empty() && date.empty() &&
             material.empty() && note.empty());
  }
};

const KeyTable& drawing_keys();

}  // namespace gearwright
