#include "gearwright/job/verify.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "gearwright/catalogue/spelling.hpp"
#include "gearwright/job/result_json.hpp"
#include "gearwright/job/verbs.hpp"
#include "gearwright/spec/parse_spec.hpp"
#include "gearwright/spec/table_reader.hpp"

namespace gearwright {

namespace {

struct Tolerance {
  double relative = 0.0;
  double absolute = 0.0;
};

// Returns the tolerance of a value in "tolerance": {"values": {path: absolute}}. If there is none,
// returns the tolerance of the case.
Tolerance tolerance_of(const Json& c, const std::string& path) {
  Tolerance tolerance;
  if (!c.contains("tolerance")) return tolerance;
  const Json& t = c["tolerance"];
  if (t.contains("values") && t["values"].contains(path))
    return {0.0, t["values"][path].get<double>()};
  return {t.value("relative", 0.0), t.value("absolute", 0.0)};
}

// Returns the value at a path such as "gears.0.base_diameter_mm", or null if there is none.
const Json* follow(const Json& root, const std::string& path) {
  Json::json_pointer place;
  std::istringstream words(path);
  for (std::string word; std::getline(words, word, '.');) place /= word;
  return root.contains(place) ? &root[place] : nullptr;
}

std::string compare(const std::string& path, const Json* got, const Json& want,
                    const Tolerance& tolerance) {
  if (!got)
    return fmt::format("{}: there is no such value, but {} is expected", path, json_text(want));
  if (want.is_number() && got->is_number()) {
    const double w = want.get<double>();
    const double g = got->get<double>();
    const double allowed = std::max(tolerance.relative * std::abs(w), tolerance.absolute);
    if (std::abs(g - w) <= allowed) return {};
    return fmt::format(
        "{}: the result is {}, but {} is expected; the difference is {:.3g}, and {:.3g} is allowed",
        path, g, w, g - w, allowed);
  }
  if (*got == want) return {};
  return fmt::format("{}: the result is {}, but {} is expected", path, json_text(*got),
                     json_text(want));
}

Error malformed(const std::string& id, const std::string& why) { return {id, "", why}; }

Result<CaseOutcome> run_case(const Json& c) {
  const std::string id = c.value("id", std::string("(case without id)"));
  if (!c.contains("spec") || !c["spec"].is_object())
    return malformed(id, "needs an object \"spec\"");
  if (!c.contains("expected") || !c["expected"].is_object() || c["expected"].empty()) {
    return malformed(id, "needs \"expected\" with at least one value");
  }
  if (!c.contains("source") || !c["source"].is_string())
    return malformed(id, "needs \"source\", which names the publication of the numbers");
  const std::string verb = c.value("verb", std::string("pair"));
  const Verb* const row = find_verb(verb);
  if (!row) return malformed(id, fmt::format("verb \"{}\": {}", verb, verb_names()));

  const auto spec = read_spec_tree(c["spec"], {}, row->use);
  const auto answered = spec ? answer_json(verb, *spec) : Result<Json>(spec.error());
  const Json result = answered ? *answered
                      : spec   ? error_json(spelled(answered.error(), spec->given))
                               : error_json(answered.error());
  CaseOutcome outcome{id, 0, {}};
  const bool wants_error =
      std::any_of(c["expected"].items().begin(), c["expected"].items().end(),
                  [](const auto& item) { return item.key().rfind("error", 0) == 0; });
  if (result.contains("error") && !wants_error) {
    outcome.differences.push_back(result["error"]["message"].get<std::string>());
  }
  for (const auto& [path, want] : c["expected"].items()) {
    ++outcome.values;
    std::string difference = compare(path, follow(result, path), want, tolerance_of(c, path));
    if (!difference.empty()) outcome.differences.push_back(std::move(difference));
  }
  return outcome;
}

Error unreadable(const std::string& why) {
  return {"", "", "the case file cannot be read: " + why};
}

Error unreadable(const nlohmann::json::exception& e) {
  const std::string what = e.what();  // "[json.exception.parse_error.101] parse error at line …"
  const std::size_t at = what.find("] ");
  return unreadable(printable(at == std::string::npos ? what : what.substr(at + 2), 200));
}

}  // namespace

Result<std::vector<CaseOutcome>> verify_cases(std::string_view json_text) {
  constexpr int kDeepest = 64;  // greatest depth of nesting; a real case has ten levels
  if (json_depth(json_text) > kDeepest)
    return unreadable(fmt::format("the file has more than {} nested levels", kDeepest));
  try {
    return run_cases(parse_json(json_text));
  } catch (const nlohmann::json::exception& e) {
    return unreadable(e);
  }
}

Result<std::vector<CaseOutcome>> run_cases(const Json& file) try {
  if (!file.is_object() || !file.contains("cases") || !file["cases"].is_array() ||
      file["cases"].empty()) {
    return Error{"cases", "",
                 "a case file must have the form {\"cases\": [...]} with at least one case"};
  }
  std::vector<CaseOutcome> outcomes;
  for (const Json& c : file["cases"]) {
    auto outcome = run_case(c);
    if (!outcome) return outcome.error();
    outcomes.push_back(std::move(outcome).take());
  }
  return outcomes;
} catch (const nlohmann::json::exception& e) {
  return unreadable(e);
}

}  // namespace gearwright
