#include "apps/cli/verbs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <nlohmann/json.hpp>

#include "apps/cli/door.hpp"
#include "apps/common/speaking.hpp"
#include "apps/common/watch.hpp"
#include "gearwright/base/output_file.hpp"
#include "gearwright/catalogue/spec_schema.hpp"
#include "gearwright/job/compensate_text.hpp"
#include "gearwright/job/contact_text.hpp"
#include "gearwright/job/csv_answer.hpp"
#include "gearwright/job/files.hpp"
#include "gearwright/job/fit_answer.hpp"
#include "gearwright/job/judgement.hpp"
#include "gearwright/job/listing.hpp"
#include "gearwright/job/measures.hpp"
#include "gearwright/job/rating_text.hpp"
#include "gearwright/job/result_json.hpp"
#include "gearwright/job/result_schema.hpp"
#include "gearwright/job/verify.hpp"
#include "gearwright/job/workshop_drawing.hpp"
#include "gearwright/spec/toml_text.hpp"

namespace gearwright::cli {

namespace fs = std::filesystem;

namespace {

std::string read_text(const std::string& path) {
  if (fs::is_directory(path)) throw IoError("cannot read " + path + ": it is a folder");
  std::ifstream file(path, std::ios::binary);
  if (!file) throw IoError("cannot read " + path + ": " + std::strerror(errno));
  constexpr std::size_t kMaxBytes = 1 << 26;  // of a file of cases; a device may have no end
  std::string text;
  std::array<char, 1 << 16> part{};
  while (file.read(part.data(), part.size()), file.gcount() > 0) {
    text.append(part.data(), static_cast<std::size_t>(file.gcount()));
    if (text.size() > kMaxBytes)
      throw IoError(fmt::format("cannot read {}: it has more than {} bytes", path, kMaxBytes));
  }
  if (file.bad()) throw IoError("cannot read " + path + ": " + std::strerror(errno));
  return text;
}

std::string pair_listing_of(const SolvedJob& job) {
  return job.pair ? pair_listing(*job.pair) + pair_interval_listing(job) : std::string();
}

// Says on stderr what is being made, but only when it takes more than a second.
class SlowProgress {
 public:
  void operator()(std::string_view what) {
    if (std::chrono::steady_clock::now() - start_ > std::chrono::seconds(1)) {
      std::fprintf(stderr, "gearwright: making %.*s\n", static_cast<int>(what.size()), what.data());
    }
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

FileOptions file_options(const Options& o) {
  FileOptions options;
  options.step_schema = o.step_schema == "ap214" ? StepSchema::ap214 : StepSchema::ap242;
  options.progress = SlowProgress();
  options.mesh_tolerance_mm = o.mesh_tolerance;
  options.drawing_tolerance_mm = o.drawing_tolerance;
  options.drawing_splines = o.drawing_splines;
  return options;
}

// The words between commas; none where one of them is no part of a run.
std::optional<std::vector<std::string>> run_parts(const std::string& text) {
  std::vector<std::string> parts;
  for (std::size_t at = 0; at <= text.size();) {
    const std::size_t end = std::min(text.find(',', at), text.size());
    parts.push_back(text.substr(at, end - at));
    if (std::find(kRunParts.begin(), kRunParts.end(), parts.back()) == kRunParts.end())
      return std::nullopt;
    at = end + 1;
  }
  return parts;
}

// The first output that would overwrite another one, or the spec; empty when there is none.
std::string collision(const Options& o) {
  std::vector<fs::path> taken{fs::weakly_canonical(fs::absolute(o.spec))};
  for (const std::string* name :
       {&o.step, &o.stl, &o.glb, &o.threemf, &o.dxf, &o.svg, &o.drawing}) {
    if (name->empty()) continue;
    std::error_code error;
    const fs::path path = fs::weakly_canonical(fs::absolute(*name), error);
    const bool device = fs::exists(path, error) && !fs::is_regular_file(path, error);
    if (!device && std::find(taken.begin(), taken.end(), path) != taken.end()) return *name;
    taken.push_back(path);
  }
  return {};
}

// A work that may take long, with a line of how far it is.
template <class Work>
auto watched(const char* verb, const Work& work) {
  Watch watch(verb);
  return work(watch.headway());
}

}  // namespace

int gear_verb(const Options& o) {
  std::optional<RackQuestion> question;
  if (o.as_rack) {
    question = parse_rack_question(*o.as_rack);
    if (!question) {
      return usage(
          "--as-rack takes MODULE,ANGLE in mm and degrees (1 to 60), one of them may be empty: "
          "--as-rack 3,20 or --as-rack ,17.5");
    }
  }
  Door door(o);
  const auto job = door.solve(Scope::gears);
  if (!job) return door.fail(job.error());
  std::vector<ReferenceInput<double>> racks;
  for (std::size_t i = 0; question && i < job->gears.size(); ++i) {
    auto rack = gear_as_rack(job->gears[i], *question);
    if (!rack) {
      Error error = rack.error();
      error.rule = fmt::format("of gear {}: {}", i + 1, error.rule);
      return door.fail(error);
    }
    racks.push_back(*rack);
  }
  const Verdict verdict = judge(*job);
  if (o.csv) {
    print(quantities_csv(*job));
  } else if (o.json) {
    Json j = job_json(*job);
    for (std::size_t i = 0; i < racks.size(); ++i) j["gears"][i]["as_rack"] = rack_json(racks[i]);
    print_json(j);
  } else {
    print(gear_listing(*job) + (racks.empty() ? std::string() : rack_listing(racks)) +
          warning_listing(job->warnings) + verdict_listing(verdict));
  }
  return status(o, verdict);
}

int fit_verb(const Options& o) {
  Door door(o);
  const auto spec = door.read();
  if (!spec) return door.fail(spec.error());
  const auto answer = watched("fit", [&](Headway* h) { return answer_fit(*spec, h); });
  if (!answer) return door.fail(answer.error());
  if (o.take) {
    return take_spec(o, door, answer->specs,
                     answer->specs.empty()
                         ? "there is no branch: " + answer->fit.reason
                         : fmt::format("there are {} branches", answer->specs.size()));
  }
  if (o.json) {
    print_json(fit_json(*answer));
  } else {
    print(fit_listing(*answer));
  }
  return 0;
}

int pair_verb(const Options& o) {
  Door door(o);
  const auto job = door.solve(Scope::pair);
  if (!job) return door.fail(job.error());
  const Verdict verdict = judge(*job);
  if (o.csv) {
    print(quantities_csv(*job));
  } else if (o.json) {
    print_json(job_json(*job));
  } else {
    print(gear_listing(*job) + pair_listing_of(*job) + warning_listing(job->warnings) +
          verdict_listing(verdict));
  }
  return status(o, verdict);
}

int contact_verb(const Options& o) {
  Door door(o);
  auto solved = door.solve(Scope::pair);
  if (!solved) return door.fail(solved.error());
  SolvedJob job = std::move(solved).take();
  const auto answer = watched("contact", [&](Headway* h) { return answer_contact(job, h); });
  if (!answer) return door.fail(answer.error());
  const Verdict verdict = judge(job, &answer->driving);
  if (o.csv) {
    print(contact_csv(job, *answer));
  } else if (o.json) {
    print_json(contact_json(job, *answer));
  } else {
    print(contact_listing(job, *answer) + warning_listing(job.warnings) + verdict_listing(verdict));
  }
  return status(o, verdict);
}

int compensate_verb(const Options& o) {
  Door door(o);
  auto solved = door.solve(Scope::pair);
  if (!solved) return door.fail(solved.error());
  SolvedJob job = std::move(solved).take();
  const auto answer = watched("compensate", [&](Headway* h) { return answer_compensate(job, h); });
  if (!answer) return door.fail(answer.error());
  const Verdict& verdict = answer->verdict;
  if (o.spec_only) {
    if (o.json) {
      print_json(parse_json(answer->corrected));
    } else {
      print(toml_text(parse_json(answer->corrected)));
    }
  } else if (o.json) {
    print_json(compensate_json(job, *answer));
  } else {
    print(compensate_listing(job, *answer) + warning_listing(job.warnings) +
          verdict_listing(verdict));
  }
  return status(o, verdict);
}

int rate_verb(const Options& o) {
  Door door(o);
  auto solved = door.solve(Scope::pair);
  if (!solved) return door.fail(solved.error());
  SolvedJob job = std::move(solved).take();
  const auto answer = answer_rating(job);
  if (!answer) return door.fail(answer.error());
  const Verdict verdict = judge(job, nullptr, &*answer);
  if (o.csv) {
    print(rating_csv(*answer));
  } else if (o.json) {
    print_json(rating_json(job, *answer, verdict));
  } else {
    print(rating_listing(job, *answer) + warning_listing(job.warnings) + verdict_listing(verdict));
  }
  return status(o, verdict);
}

int outline_verb(const Options& o) {
  Door door(o);
  const auto job = door.solve(Scope::gears);
  if (!job) return door.fail(job.error());
  const int which = o.gear.value_or(1);
  if (which > static_cast<int>(job->gears.size())) {
    return door.fail({"gear2", "", "is missing from the spec, --gear 2 asks for its outline"});
  }
  const auto body = make_body(*job, which, false);
  if (!body) return door.fail(body.error());
  if (o.csv) {
    print(outline_csv(body->outline, o.points));
  } else if (o.json) {
    Json j = outline_json(body->outline, o.points);
    j["warnings"] = warnings_json(job->warnings);
    print_json(j);
  } else {
    print(outline_listing(body->outline, o.points));
  }
  return 0;
}

int run_verb(const Options& o) {
  if (o.out && o.out->empty()) return usage("--out needs the name of a folder");
  const bool nameless = o.spec == "-" || (fs::exists(o.spec) && !fs::is_regular_file(o.spec) &&
                                          !fs::is_directory(o.spec));
  if (!o.out && nameless) {
    return usage("the spec has no name to call the folder after: choose it with --out DIR");
  }
  FileOptions options = file_options(o);
  if (o.only) {
    const auto parts = run_parts(*o.only);
    if (!parts) {
      return usage(fmt::format("--only takes some of {}, with commas between: --only step,report",
                               fmt::join(kRunParts, ", ")));
    }
    options.only = *parts;
  }
  Door door(o);
  auto solved = door.solve(Scope::everything);
  if (!solved) return door.fail(solved.error());
  SolvedJob job = std::move(solved).take();
  fs::path out = o.out.value_or("");
  if (out.empty()) {
    out = fs::path(o.spec);
    if (out.extension() == ".toml" || out.extension() == ".json") out.replace_extension();
    out += "_out";
  }
  const auto made = watched("run", [&](Headway* h) {
    options.headway = h;
    return write_everything(job, out, options);
  });
  if (!made) return door.fail(made.error());
  if (o.json) {
    // As in result.json, with all the files.
    Json j = parse_json(made->result);
    j["files"] = files_json(made->files);
    print_json(j);
  } else {
    print(gear_listing(job) + pair_listing_of(job) + warning_listing(job.warnings) +
          file_listing(made->files) + verdict_listing(made->verdict));
  }
  return status(o, made->verdict);
}

int export_verb(const Options& o) {
  const std::vector<std::pair<FileKind, const std::string*>> wanted{
      {FileKind::step, &o.step},       {FileKind::stl, &o.stl}, {FileKind::glb, &o.glb},
      {FileKind::threemf, &o.threemf}, {FileKind::dxf, &o.dxf}, {FileKind::svg, &o.svg}};
  bool any = !o.drawing.empty();
  for (const auto& [kind, path] : wanted) any = any || !path->empty();
  if (!any)
    return usage(
        "export needs at least one of --step, --stl, --glb, --3mf, --dxf, --svg, --drawing with a "
        "file name");
  const auto format = sheet_format(o.drawing);
  if (!o.drawing.empty() && !format)
    return usage("--drawing takes a name that ends in .pdf, .svg or .dxf, and not " + o.drawing);
  if (const std::string name = collision(o); !name.empty()) {
    return usage(name + " is named twice, or is the spec itself");
  }
  Door door(o);
  // A drawing names the mating gear.
  const bool alone = o.gear && o.drawing.empty();
  const auto job = door.solve(alone ? Scope::gears : Scope::everything);
  if (!job) return door.fail(job.error());
  const int count = static_cast<int>(job->gears.size());
  if (o.gear && *o.gear > count) {
    return door.fail({"gear2", "", "is missing from the spec, --gear 2 asks for its files"});
  }
  std::vector<ToothedBody> bodies;
  std::vector<int> drawn;
  for (int which = 1; which <= count; ++which) {
    if (o.gear && *o.gear != which) continue;
    drawn.push_back(which);
    auto body = make_body(*job, which, !o.gear);
    if (!body) return door.fail(body.error());
    bodies.push_back(std::move(body).take());
  }
  std::vector<JobFile> files;
  const FileOptions options = file_options(o);
  for (const auto& [kind, path] : wanted) {
    if (path->empty()) continue;
    auto file = make_file(kind, bodies, *path, options);
    if (!file) return door.fail(file.error());
    files.push_back(std::move(file).take());
  }
  if (format) {
    const SheetSize size = o.sheet == "A3" ? SheetSize::a3 : SheetSize::a4;
    auto file = make_workshop_drawing(*job, drawn, *format, size, o.drawing, options);
    if (!file) return door.fail(file.error());
    files.push_back(std::move(file).take());
  }
  write_files(files);
  if (o.json) {
    print_json({{"files", files_json(files)}, {"warnings", warnings_json(job->warnings)}});
  } else {
    print(warning_listing(job->warnings) + file_listing(files));
  }
  return 0;
}

int verify_verb(const Options& o) {
  Json list = Json::array();
  std::string lines;
  int cases = 0;
  int values = 0;
  int bad = 0;
  for (const std::string& path : o.cases) {
    const auto outcomes = verify_cases(read_text(path));
    if (!outcomes) {
      Error error = outcomes.error();
      error.rule = fmt::format("{} (in {})", error.rule, path);
      return fail(error, o.json);
    }
    for (const CaseOutcome& c : *outcomes) {
      ++cases;
      values += c.values;
      bad += c.differences.empty() ? 0 : 1;
      for (const std::string& d : c.differences)
        lines += fmt::format("{}  {}: {}\n", path, c.id, d);
      list.push_back(
          {{"file", path}, {"id", c.id}, {"values", c.values}, {"differences", c.differences}});
    }
  }
  if (o.json) {
    print_json({{"cases", list}, {"held", cases - bad}, {"failed", bad}, {"values", values}});
  } else {
    print(lines + fmt::format("{} of {} cases hold ({} values)\n", cases - bad, cases, values));
  }
  if (bad > 0) std::fprintf(stderr, "gearwright: %d of %d cases differ\n", bad, cases);
  return bad == 0 ? 0 : 1;
}

int schema_verb(const Options& o) {
  print(o.schema == "spec" ? spec_schema() : result_schema().dump(2) + "\n");
  return 0;
}

}  // namespace gearwright::cli
