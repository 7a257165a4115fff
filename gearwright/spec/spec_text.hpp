// The text of a spec before it is parsed: its origin, and the position of a key in it.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "gearwright/base/result.hpp"

namespace gearwright {

enum class SpecFormat { toml, json };

constexpr std::size_t kMaxSpec = 4 << 20;  ///< bytes: more than any spec needs

struct SpecText {
  std::string name;  ///< as given by the user; "standard input" for "-"
  std::string text;
  SpecFormat format = SpecFormat::toml;
  std::filesystem::path folder{};  ///< base of relative file names in it; if empty, the working
                                   ///< directory
};

/// Reads a file; "-" is standard input. The format is JSON if the name ends in .json. Text from a
/// pipe or a device is JSON if it begins with a brace, which TOML never does. A file .rexs is
/// converted to TOML.
///
/// Throws    IoError if it cannot be read
/// Errors    a REXS file that is no spec (spec_of_rexs); more than kMaxSpec bytes, which are rejected unread
Result<SpecText> read_spec_text(const std::filesystem::path& path);

/// Counted from 1, columns in characters.
struct TextPlace {
  int line = 1, column = 1;
};

/// The position of a key, "gear1.rack.arcs[2].radius", or of its table if the key is absent. The
/// text must have been parsed by read_spec. None if the table is absent too. An empty key gives the
/// position of a syntax error of TOML.
std::optional<TextPlace> place_of_key(const SpecText& text, std::string_view key);

}  // namespace gearwright
