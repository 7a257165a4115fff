// Checks the input of an oracle. An error is a sentence.
#pragma once

#include <stdexcept>

namespace gearwright::oracle {

/// Throws   std::invalid_argument
inline void require(bool holds, const char* sentence) {
  if (!holds) throw std::invalid_argument(sentence);
}

}  // namespace gearwright::oracle
