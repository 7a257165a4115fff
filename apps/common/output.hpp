// How a program of ours speaks: results on stdout, sentences on stderr, a status for the shell.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "gearwright/base/result.hpp"
#include "gearwright/spec/json.hpp"
#include "gearwright/spec/spec_text.hpp"

namespace gearwright::apps {

/// All of stdout in one piece, so that a full disk behind it is seen.   Throws  IoError
void print(const std::string& text);
/// Names of files may be any bytes; JSON takes characters only.   Throws  IoError
void print_json(const Json& j);
/// Where a spec's text has what the error is about; none of an option, or where not even its table
/// is there.
std::optional<TextPlace> place_of(const Error& error, const SpecText& text);
/// {"error": …} with the spec's name, if it has one, and the line. Spelled before.
Json refusal_json(const Error& error, const SpecText* text = nullptr);
/// The input is wrong or the gears are impossible: says so, as JSON too if asked; status 1. What
/// the library says is spelled (catalogue/spelling.hpp) before, what is read from a file is not.
/// `text`: the spec that the error is about, whose name and line are told too.
int fail(const Error& error, bool json, const SpecText* text = nullptr);
/// The command line is wrong: status 2.
int usage(const std::string& message);
/// The exit status of a mistake in Gearwright itself (base/contract.hpp).
inline constexpr int kViolated = 5;
/// The status of the work; kViolated where it breaks a contract, which is said, as JSON too if asked.
int guarded(const std::function<int()>& work, bool json);

}  // namespace gearwright::apps
