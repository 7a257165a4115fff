// Output of the programs: results on stdout, messages on stderr, a status for the shell.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "gearwright/base/result.hpp"
#include "gearwright/spec/json.hpp"
#include "gearwright/spec/spec_text.hpp"

namespace gearwright::apps {

/// Prints the whole text to stdout at once, so that a full disk is detected.   Throws  IoError
void print(const std::string& text);
/// Checks a file name for JSON. A file name may contain any bytes, but JSON contains only
/// characters.   Throws  IoError
void print_json(const Json& j);
/// Returns the position in the text of the spec to which the error refers. None for an option, or
/// if the table is not in the text.
std::optional<TextPlace> place_of(const Error& error, const SpecText& text);
/// Returns {"error": …} with the name of the spec, if it has one, and the line. The error must
/// already be expressed in keys.
Json refusal_json(const Error& error, const SpecText* text = nullptr);
/// Reports that the input is wrong or the gears are impossible, also as JSON if requested, and
/// returns status 1. An error of the library must be expressed in keys (catalogue/spelling.hpp)
/// beforehand. `text` is the spec in which the error occurred. Its name and the line are also
/// reported.
int fail(const Error& error, bool json, const SpecText* text = nullptr);
/// Reports a wrong command line and returns status 2.
int usage(const std::string& message);
/// The exit status of a defect of Gearwright itself (base/contract.hpp).
inline constexpr int kViolated = 5;
/// Returns the status of the work, or kViolated if the work violates a contract. The violation is
/// reported, also as JSON if requested.
int guarded(const std::function<int()>& work, bool json);

}  // namespace gearwright::apps
