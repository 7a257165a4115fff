#include "apps/common/output.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <nlohmann/json.hpp>

#include "gearwright/base/output_file.hpp"
#include "gearwright/base/printable.hpp"
#include "gearwright/job/result_json.hpp"

namespace gearwright::apps {

void print(const std::string& text) {
  if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size() || std::fflush(stdout) != 0)
    throw IoError(std::string("cannot write to standard output: ") + std::strerror(errno));
}

void print_json(const Json& j) { print(json_text(j, 2) + "\n"); }

void print_spec(const Json& spec, bool json, const std::vector<std::string>& notes) {
  json ? print_json(spec) : print(toml_comment(notes) + toml_text(spec));
  for (std::size_t i = 1; json && i < notes.size(); ++i)
    std::fprintf(stderr, "gearwright: %s\n", notes[i].c_str());
}

Error no_such_spec(int take, std::size_t specs, const std::string& why_none) {
  return {"--take", std::to_string(take),
          specs > 0          ? fmt::format("must be 1 to {}", specs)
          : why_none.empty() ? "the spec has no such solution"
                             : "the spec has no such solution: " + why_none,
          FailureKind::option};
}

std::optional<Error> print_answer(const Answer& answer, bool json, bool csv,
                                  const std::optional<int>& take) {
  if (take) {
    const auto at = static_cast<std::size_t>(*take - 1);
    const DriveSpecs drive = answer.drive_specs ? answer.drive_specs() : DriveSpecs();
    const auto& specs = answer.drive_specs ? drive.meshes : answer.specs;
    const auto& notes = answer.drive_specs ? drive.notes : answer.notes;
    if (at >= specs.size()) return no_such_spec(*take, specs.size(), answer.why_none);
    print_spec(specs[at], json, at < notes.size() ? notes[at] : std::vector<std::string>());
  } else if (csv) {
    print(answer.csv());
  } else if (json) {
    print(answer_json_text(answer));
  } else {
    print(answer_text(answer));
  }
  return std::nullopt;
}

Json refusal_json(const Error& error, const SpecText* text) {
  Json json = error_json(error);
  if (!text || error.kind == FailureKind::option) return json;
  if (!text->name.empty()) json["error"]["file"] = text->name;
  if (const auto place = place_of_key(*text, error.field)) {
    json["error"]["line"] = place->line;
    json["error"]["column"] = place->column;
  }
  return json;
}

int fail(const Error& error, bool json, const SpecText* text) {
  std::string where;
  // An error that refers to an option has no line in the file.
  if (text && error.kind != FailureKind::option) {
    where = printable(text->name) + ":";
    if (const auto place = place_of_key(*text, error.field))
      where += fmt::format("{}:{}:", place->line, place->column);
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

void StatusLine::show(const std::function<std::string(double seconds)>& text) {
  const double now = std::chrono::duration<double>(Clock::now() - start_).count();
  if (now < (!shown_ ? 2.0 : *shown_ + (terminal_ ? 0.5 : 10.0))) return;
  std::fprintf(stderr, "%sgearwright: %s%s", terminal_ ? "\r" : "", text(now).c_str(),
               terminal_ ? "   " : "\n");
  std::fflush(stderr);
  shown_ = now;
}

void StatusLine::clear() {
  if (terminal_ && shown_) std::fprintf(stderr, "\r\033[K");
  shown_.reset();
}

int guarded(const std::function<int()>& work, bool json) {
  try {
    return work();
  } catch (const ContractViolation& e) {
    fail({"", "", e.what(), FailureKind::defect}, json);
    return kViolated;
  }
}

}  // namespace gearwright::apps
