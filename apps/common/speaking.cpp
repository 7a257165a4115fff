#include "apps/common/speaking.hpp"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <nlohmann/json.hpp>

#include "gearwright/base/output_file.hpp"
#include "gearwright/job/result_json.hpp"

namespace gearwright::cli {

void print(const std::string& text) {
  if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size() || std::fflush(stdout) != 0) {
    throw IoError(std::string("cannot write to standard output: ") + std::strerror(errno));
  }
}

void print_json(const Json& j) { print(json_text(j, 2) + "\n"); }

int fail(const Error& error, bool json) {
  std::fprintf(stderr, "gearwright: %s\n", error.message().c_str());
  if (json) print_json(error_json(error));
  return 1;
}

int usage(const std::string& message) {
  std::fprintf(stderr, "gearwright: %s\n", message.c_str());
  return 2;
}

}  // namespace gearwright::cli
