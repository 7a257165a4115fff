// Reads the text of a spec with its origin before parsing, and finds the positions of its keys.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "gearwright/base/result.hpp"

namespace gearwright {

enum class SpecFormat { toml, json };

constexpr std::size_t kMaxSpec = 4 << 20;  ///< bytes, more than any spec needs

struct SpecText {
  std::string name;  ///< name given by the user; "standard input" for "-"
  std::string text;
  SpecFormat format = SpecFormat::toml;
  std::filesystem::path folder{};  ///< base of relative file names; if empty, the working directory
};

/// Reads a file. The path "-" is standard input. The format is JSON if the name ends in .json. Text
/// from a pipe or a device is JSON if it begins with a brace, which cannot begin a TOML text. A
/// REXS file (spec/rexs_file.hpp) is converted to TOML.
///
/// Throws    IoError if the file cannot be read
/// Errors    a REXS file that cannot be read or converted to a spec (spec_of_rexs); UTF-16 text;
///           more than kMaxSpec bytes, which are not read
Result<SpecText> read_spec_text(const std::filesystem::path& path);

/// A position counted from 1, with columns in characters.
struct TextPlace {
  int line = 1, column = 1;
};

/// Returns the position of a key, for example "gear1.rack.arcs[2].radius". If the key is absent,
/// returns the position of the last table on its path that the text contains, or none if there is
/// no such table. If the text has a syntax error, returns the position of this error for every key,
/// even for an empty one. If a table of a JSON text contains the key twice, returns the second
/// position.
std::optional<TextPlace> place_of_key(const SpecText& text, std::string_view key);

// Sets one key of a spec's TOML text. Comments, order and blanks remain unchanged, unless the key
// cannot be set in place. In this rare case, the whole text is written anew, without comments.

/// `path` has the form that errors use, for example "gear1.rack.dedendum". `value` is JSON text.
/// Null removes the key. If the key is alone on a line, the whole line is removed.
///
/// An absent key is added at the end of its table. An absent table is added at the end of the text.
/// Keys of an inline table { … } are set inside the braces.
///
/// Errors    a text that is not TOML; a value that is not JSON; a path through a value that is not
///           a table
Result<std::string> with_key(std::string_view toml, std::string_view path, std::string_view value);

}  // namespace gearwright
