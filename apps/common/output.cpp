#include "apps/common/output.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <nlohmann/json.hpp>

#include "gearwright/base/output_file.hpp"
#include "gearwright/base/printable.hpp"
#include "gearwright/job/result_json.hpp"

namespace gearwright::apps {

void print(const std::string& text) {
  if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size() || std::fflush(stdout) != 0) {
    throw IoError(std::string("cannot write to standard output: ") + std::strerror(errno));
  }
}

void print_json(const Json& j) { print(json_text(j, 2) + "\n"); }

std::optional<TextPlace> place_of(const Error& error, const SpecText& text) {
  if (error.field.starts_with("--")) return std::nullopt;
  return place_of_key(text, error.field);
}

Json refusal_json(const Error& error, const SpecText* text) {
  Json json = error_json(error);
  if (!text || error.field.starts_with("--")) return json;
  if (!text->name.empty()) json["error"]["file"] = text->name;
  if (const auto place = place_of(error, *text)) {
    json["error"]["line"] = place->line;
    json["error"]["column"] = place->column;
  }
  return json;
}

int fail(const Error& error, bool json, const SpecText* text) {
  std::string where;
  // An error that refers to an option has no line in the file.
  if (text && !error.field.starts_with("--")) {
    where = printable(text->name) + ":";
    const auto place = error.field.empty() ? std::nullopt : place_of(error, *text);
    if (place) where += fmt::format("{}:{}:", place->line, place->column);
    where += " ";
  }
  std::fprintf(stderr, "gearwright: %s%s\n", where.c_str(), error.message().c_str());
  if (json) print_json(refusal_json(error, text));
  return 1;
}

int usage(const std::string& message) {
  std::fprintf(stderr, "gearwright: %s\n", message.c_str());
  return 2;
}

int guarded(const std::function<int()>& work, bool json) {
  try {
    return work();
  } catch (const ContractViolation& e) {
    fail({"", "", e.what()}, json);
    return kViolated;
  }
}

}  // namespace gearwright::apps
