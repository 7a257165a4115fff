// Prepares foreign text, such as titles and file names, for sentences and terminals.
#pragma once

#include <cstddef>
#include <string>

namespace gearwright {

constexpr std::size_t kLongText =
    400;  ///< longest part of a title or a file name that is shown, in bytes

/// Escapes control characters (including those of ISO 6429 above 0x7F) and invalid UTF-8, so that a
/// terminal shows them instead of executing them. Text longer than `most` bytes is cut after the
/// character that reaches this length.
std::string printable(const std::string& text, std::size_t most = kLongText);

}  // namespace gearwright
