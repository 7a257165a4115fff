// Output of the programs: results on stdout, messages on stderr, and an exit status.
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
/// Prints the JSON to stdout. Bytes that are not valid UTF-8, for example in a file name, become
/// U+FFFD.   Throws  IoError
void print_json(const Json& j);
/// Returns the position in the spec to which the error refers. There is none for an error of an option, or
/// if the table is not in the text.
std::optional<TextPlace> place_of(const Error& error, const SpecText& text);
/// Returns {"error": …}, with the name of the spec, if it has one, and the line and column. The error must
/// already be expressed in keys.
Json refusal_json(const Error& error, const SpecText* text = nullptr);
/// Reports that the input is wrong or that the gears are impossible, and returns status 1. The report is also
/// printed as JSON if requested. An error of the library must already be expressed in keys
/// (catalogue/spelling.hpp). `text` is the spec in which the error occurred. Its name and the line are also
/// reported.
int fail(const Error& error, bool json, const SpecText* text = nullptr);
/// Reports a wrong command line and returns status 2.
int usage(const std::string& message);
/// The exit status of a defect of Gearwright itself (base/contract.hpp).
inline constexpr int kViolated = 5;
/// Returns the status of the work, or kViolated if the work violates a contract. The violation is
/// reported, and also printed as JSON if requested.
int guarded(const std::function<int()>& work, bool json);

}  // namespace gearwright::apps
