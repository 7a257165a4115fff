// Computes the output of `gearwright … --json` for the text of a spec, byte for byte, including
// errors. Verbs that need files or folders are not available in a page.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "gearwright/job/verbs.hpp"

namespace gearwright::web {

/// Returns the text of a spec. It is JSON if it begins with a brace, otherwise TOML.
SpecText spec_text(std::string text);

/// Reads the spec.   Errors  a text of more than kMaxSpec bytes; the errors of read_spec
Result<JobSpec> read(const SpecText& text, SpecUse use = SpecUse::geometry);

/// The words for the page in the error that rejects a spec in inch. The page rejects such a
/// spec, because it has its own switch between mm and inch.
inline constexpr std::string_view kInPage =
    "an interactive session, such as the page, which has its own switch for lengths in inch";

/// Returns the JSON {"error": …} that the command-line program prints for this error. It names the
/// keys that the spec contains and, if `text` is given, the line and column of the wrong key.
std::string refusal(const Error& error, const SpecText* text = nullptr,
                    const GivenKeys& given = {});

/// The output of `gearwright VERB SPEC --json` with the result of the verb. There is no result if
/// the verb fails.
struct Answered {
  std::string json;
  std::optional<Answer> answer = {};
};
Answered answered(std::string_view verb, const std::string& text);

/// Returns the same spec in mm. A spec in mm is returned unchanged. Any other spec becomes TOML
/// without comments.
Result<std::string> metric(const std::string& text);

/// Converts JSON to TOML, or TOML to JSON. In the JSON, a material that was only a name becomes a
/// table with this name. Returns an error if the text cannot be read, or if the JSON contains null.
Result<std::string> to_toml(const std::string& json);
Result<std::string> to_json_text(const std::string& toml);

}  // namespace gearwright::web
