// The text of a spec before it is understood: where it came from, and where in it a key stands.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "gearwright/base/result.hpp"

namespace gearwright {

enum class SpecFormat { toml, json };

constexpr std::size_t kMaxSpec = 4 << 20;  ///< bytes: no drawing has that many numbers

struct SpecText {
  std::string name;  ///< as it was asked for; "standard input" of "-"
  std::string text;
  SpecFormat format = SpecFormat::toml;
  std::filesystem::path folder{};  ///< where file names in it start; empty: the working directory
};

/// Reads a file; "-" is standard input. JSON when the name ends in .json; what comes through a pipe
/// or a device is JSON when it begins with a brace, as no TOML does.
///
/// Throws    IoError when it cannot be read
/// Errors    more than kMaxSpec bytes, which are refused unread
Result<SpecText> read_spec_text(const std::filesystem::path& path);

/// Counted from 1, columns in characters.
struct TextPlace {
  int line = 1, column = 1;
};

/// Where a key stands, "gear1.rack.arcs[2].radius"; of one that is absent its table. The text is one
/// that read_spec parsed. None if not even the table is there. An empty key is the place of a syntax
/// error of TOML.
std::optional<TextPlace> place_of_key(const SpecText& text, std::string_view key);

}  // namespace gearwright
