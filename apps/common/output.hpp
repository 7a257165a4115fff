// Output of the programs: results on stdout, sentences on stderr, a status for the shell.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "gearwright/base/result.hpp"
#include "gearwright/spec/json.hpp"
#include "gearwright/spec/spec_text.hpp"

namespace gearwright::apps {

/// Prints all of stdout at once, so that a full disk is detected.   Throws  IoError
void print(const std::string& text);
/// Names of files may contain any bytes, but JSON contains characters only.   Throws  IoError
void print_json(const Json& j);
/// The place in the spec's text to which the error refers; none for an option, or if its table is
/// not in the text.
std::optional<TextPlace> place_of(const Error& error, const SpecText& text);
/// {"error": …} with the name of the spec, if it has one, and the line. The error must already be
/// spelled in keys.
Json refusal_json(const Error& error, const SpecText* text = nullptr);
/// Reports that the input is wrong or the gears are impossible, also as JSON if requested; returns
/// status 1. An error of the library must be spelled in keys (catalogue/spelling.hpp) before.
/// `text` is the spec of the error, whose name and line are reported too.
int fail(const Error& error, bool json, const SpecText* text = nullptr);
/// Reports a wrong command line; returns status 2.
int usage(const std::string& message);
/// The exit status of a defect of Gearwright itself (base/contract.hpp).
inline constexpr int kViolated = 5;
/// Returns the status of the work, or kViolated if it violates a contract, which is reported, also
/// as JSON if requested.
int guarded(const std::function<int()>& work, bool json);

}  // namespace gearwright::apps
