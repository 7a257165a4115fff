#include "apps/web/engine/answering.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "apps/common/output.hpp"
#include "gearwright/catalogue/spelling.hpp"
#include "gearwright/job/verbs.hpp"
#include "gearwright/spec/inherit.hpp"
#include "gearwright/spec/json.hpp"
#include "gearwright/spec/parse_spec.hpp"
#include "gearwright/spec/table_reader.hpp"

namespace gearwright::web {

namespace {

Error too_long(std::size_t bytes) {
  return {"", "", fmt::format("the spec has {} bytes; at most {} are allowed", bytes, kMaxSpec)};
}

Result<Json> tree_of(const std::string& text, SpecFormat format) {
  if (text.size() > kMaxSpec) return too_long(text.size());
  return parse_spec(text, format);
}

// Returns the path of a null in a tree, or nothing if there is none. TOML has no null.
std::optional<std::string> null_in(const Json& tree, const std::string& path) {
  if (tree.is_null()) return path;
  if (!tree.is_structured()) return std::nullopt;
  for (const auto& [key, value] : tree.items()) {
    std::string here = key;
    if (tree.is_array()) here = fmt::format("{}[{}]", path, std::stoul(key) + 1);
    if (tree.is_object() && !path.empty()) here = path + "." + key;
    if (auto found = null_in(value, here)) return found;
  }
  return std::nullopt;
}

}  // namespace

SpecText spec_text(std::string text) {
  SpecText read{"", std::move(text)};
  const std::size_t first = read.text.find_first_not_of(" \t\r\n");
  if (first != std::string::npos && read.text[first] == '{') read.format = SpecFormat::json;
  return read;
}

Result<JobSpec> read(const SpecText& text, SpecUse use) {
  if (text.text.size() > kMaxSpec) return too_long(text.text.size());
  return read_spec(text, use);
}

std::string refusal(const Error& error, const SpecText* text, const GivenKeys& given) {
  return json_text(apps::refusal_json(spelled(error, given), text), 2) + "\n";
}

Answered answered(std::string_view verb, const std::string& given) {
  const SpecText text = spec_text(given);
  const Verb* const row = find_verb(verb);
  if (row == nullptr)
    return {refusal({"", std::string(verb), "is not a verb that returns JSON for a spec"})};
  const auto spec = read(text, row->use);
  if (!spec) return {refusal(spec.error(), &text)};
  auto answer = row->run(*spec, nullptr);
  if (!answer) return {refusal(answer.error(), &text, spec->given)};
  return {answer_json_text(*answer), std::move(answer).take()};
}

Result<std::string> to_toml(const std::string& json) {
  const auto tree = tree_of(json, SpecFormat::json);
  if (!tree) return tree.error();
  if (const auto path = null_in(*tree, ""))
    return Error{*path, "null", "is not a value of a spec; leave out the key"};
  return toml_text(*tree);
}

Result<std::string> metric(const std::string& given) {
  const SpecText text = spec_text(given);
  const auto tree = tree_of(text.text, text.format);
  if (!tree) return tree.error();
  try {
    GivenKeys keys;
    const Json metric = in_catalogue_units(*tree, keys);
    return keys.units == UnitSystem::mm ? given : toml_text(metric);
  } catch (const SpecError& e) {
    return e.error;
  }
}

Result<std::string> to_json_text(const std::string& toml) {
  const auto tree = tree_of(toml, SpecFormat::toml);
  if (!tree) return tree.error();
  return json_text(with_named_materials(*tree), 2) + "\n";
}

}  // namespace gearwright::web
