#include "apps/common/speaking.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <nlohmann/json.hpp>

#include "gearwright/base/output_file.hpp"
#include "gearwright/base/printable.hpp"
#include "gearwright/job/result_json.hpp"

namespace gearwright::cli {

void print(const std::string& text) {
  if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size() || std::fflush(stdout) != 0) {
    throw IoError(std::string("cannot write to standard output: ") + std::strerror(errno));
  }
}

void print_json(const Json& j) { print(json_text(j, 2) + "\n"); }

int fail(const Error& error, bool json, const SpecText* text) {
  // Of an option no line of a file can tell.
  const bool of_text = text && !error.field.starts_with("--");
  const TextPlace nowhere{0, 0};
  const TextPlace place = of_text ? place_of_key(*text, error.field).value_or(nowhere) : nowhere;
  std::string where;
  if (of_text) where = printable(text->name) + ":";
  if (place.line > 0) where += fmt::format("{}:{}:", place.line, place.column);
  if (!where.empty()) where += " ";
  std::fprintf(stderr, "gearwright: %s%s\n", where.c_str(), error.message().c_str());
  if (json) {
    Json said = error_json(error);
    if (of_text) said["error"]["file"] = text->name;
    if (place.line > 0) {
      said["error"]["line"] = place.line;
      said["error"]["column"] = place.column;
    }
    print_json(said);
  }
  return 1;
}

int usage(const std::string& message) {
  std::fprintf(stderr, "gearwright: %s\n", message.c_str());
  return 2;
}

}  // namespace gearwright::cli
