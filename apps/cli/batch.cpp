#include "apps/cli/batch.hpp"

#include <fmt/format.h>

#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>

#include "apps/common/output.hpp"
#include "gearwright/base/output_file.hpp"
#include "gearwright/base/parallel.hpp"
#include "gearwright/base/printable.hpp"
#include "gearwright/job/verbs.hpp"

namespace gearwright::apps {

namespace {

void write_line(const std::string& line) {
  if (std::fwrite(line.data(), 1, line.size(), stdout) != line.size() ||
      std::fputc('\n', stdout) == EOF)
    throw IoError(std::string("cannot write to standard output: ") + std::strerror(errno));
}

}  // namespace

int batch_verb(const Options& o) {
  std::vector<std::string> words = o.words;
  std::string verb;
  if (!words.empty() && find_verb(words.front()) != nullptr) {
    verb = words.front();
    words.erase(words.begin());
  }
  const std::string path = words.empty() ? "-" : words.front();
  const bool a_word = path.find_first_of("-./") == std::string::npos;
  if (words.size() > 1 || (a_word && !std::filesystem::exists(path)))
    return usage(fmt::format("batch accepts one of the verbs {}, but not {}", verb_names(),
                             printable(path, 60)));
  std::ifstream file;
  if (path != "-") {
    if (std::filesystem::is_directory(path))
      throw IoError("cannot read " + path + ": it is a folder");
    file.open(std::filesystem::path(path), std::ios::binary);
    if (!file) throw IoError("cannot read " + path + ": " + std::strerror(errno));
  }
  std::ios::sync_with_stdio(false);
  std::istream& in = path == "-" ? std::cin : file;
  long long failed = 0;
  long long first_failed = 0;
  long long lines = 0;
  std::atomic<long long> violations = 0;
  in_order([&](std::string& line) { return static_cast<bool>(std::getline(in, line)); },
           [&](const std::string& line) {
             BatchLine answer = batch_line(verb, line);
             if (answer.violated) ++violations;
             return std::move(answer.text);
           },
           [&](const std::string& answer) {
             ++lines;
             if (answer.starts_with("{\"error\":") && failed++ == 0) first_failed = lines;
             write_line(answer);
           },
           o.threads);
  if (in.bad()) throw IoError("cannot read " + path + ": " + std::strerror(errno));
  print("");
  if (failed > 0)
    std::fprintf(stderr, "gearwright: %lld of %lld specs have no answer, the first in line %lld\n",
                 failed, lines, first_failed);
  if (violations > 0)
    std::fprintf(stderr, "gearwright: a defect in Gearwright caused %lld of these failures\n",
                 violations.load());
  if (lines == 0)
    std::fprintf(stderr,
                 "gearwright: the input contains no spec; batch reads one JSON spec per line\n");
  return violations > 0 ? kViolated : failed > 0 ? 1 : 0;
}

}  // namespace gearwright::apps
