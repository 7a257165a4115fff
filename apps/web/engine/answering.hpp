// Computes from the text of a spec the text that the program prints with --json, byte for byte,
// errors included. Files and folders, which a page does not need, are not available.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "gearwright/spec/spec.hpp"

namespace gearwright::web {

/// A text that was read; JSON if it begins with a brace, otherwise TOML.
SpecText spec_text(std::string text);

/// Reads it.   Errors  for more than kMaxSpec bytes; as read_spec
Result<JobSpec> read(const SpecText& text, SpecUse use = SpecUse::geometry);

/// {"error": …} with the keys that the spec has and the line, as the program prints it.
std::string refusal(const Error& error, const SpecText* text = nullptr,
                    const GivenKeys& given = {});

/// What `gearwright VERB SPEC --json` prints.
std::string answer(std::string_view verb, const std::string& text);

/// The same tree in the other language; none if it cannot be read.
Result<std::string> to_toml(const std::string& json);
Result<std::string> to_json_text(const std::string& toml);

}  // namespace gearwright::web
