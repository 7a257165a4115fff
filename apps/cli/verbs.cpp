#include "apps/cli/verbs.hpp"

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "apps/common/output.hpp"
#include "apps/common/watch.hpp"
#include "gearwright/base/output_file.hpp"
#include "gearwright/base/parallel.hpp"
#include "gearwright/base/printable.hpp"
#include "gearwright/catalogue/key.hpp"
#include "gearwright/catalogue/spec_schema.hpp"
#include "gearwright/drive/drive.hpp"
#include "gearwright/job/csv_answer.hpp"
#include "gearwright/job/judgement.hpp"
#include "gearwright/job/listing.hpp"
#include "gearwright/job/measures.hpp"
#include "gearwright/job/result_json.hpp"
#include "gearwright/job/verify.hpp"
#include "gearwright/spec/parse_spec.hpp"

namespace gearwright::apps {

namespace fs = std::filesystem;

namespace {

std::ifstream opened(const std::string& path) {
  if (fs::is_directory(path)) throw IoError("cannot read " + path + ": it is a folder");
  std::ifstream file(fs::path{path}, std::ios::binary);
  if (!file) throw IoError("cannot read " + path + ": " + std::strerror(errno));
  return file;
}

std::string read_text(const std::string& path) {
  std::ifstream file = opened(path);
  // The size of a case file is limited, because a device file may be endless.
  constexpr std::size_t kMaxBytes = 1 << 26;
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

}  // namespace

int answering_verb(const Verb& verb, const Options& o, const SpecText* text) {
  Door door(o, text);
  auto read = door.read(verb.use);
  if (!read) return door.fail(read.error());
  JobSpec spec = std::move(read).take();
  if (o.harmonics && spec.drive) {
    DriveInput drive = *spec.drive;
    drive.harmonics = *o.harmonics;
    spec.drive = std::make_shared<const DriveInput>(std::move(drive));
  }
  const auto answer = verb.lasts
                          ? watched(verb.name, [&](Progress* h) { return verb.run(spec, h); })
                          : verb.run(spec, nullptr);
  if (!answer) return door.fail(answer.error());
  if (o.expand)
    print_spec(answer->drive_specs().expanded, o.json);
  else if (const auto error = print_answer(*answer, o.json, o.csv, o.take))
    return door.fail(*error);
  return answer->verdict ? status(o, *answer->verdict) : 0;
}

int gear_as_rack(const Options& o) {
  const auto question = parse_wanted_rack(*o.as_rack);
  if (!question) {
    return usage(
        "--as-rack takes MODULE,ANGLE, a module in mm and an angle from 1 to 60 degrees, for "
        "example --as-rack 3,20; one of the two may be empty, for example --as-rack ,17.5");
  }
  Door door(o);
  const auto job = door.solve(Scope::gears);
  if (!job) return door.fail(job.error());
  std::vector<ReferenceInput<double>> racks;
  for (std::size_t i = 0; i < job->gears.size(); ++i) {
    auto rack = gear_as_rack(job->gears[i], *question);
    if (!rack) {
      Error error = rack.error();
      error.rule = fmt::format("is not possible for gear {}: {}", i + 1, error.rule);
      return door.fail(error);
    }
    racks.push_back(*rack);
  }
  const UnitSystem units = job->spec.units();
  const Verdict verdict = judge(*job);
  if (o.csv) {
    print(quantities_csv(*job));
  } else if (o.json) {
    Json j = job_json(*job, verdict);
    for (std::size_t i = 0; i < racks.size(); ++i) j["gears"][i]["as_rack"] = rack_json(racks[i]);
    print_json(in_units(units, j));
  } else {
    print(gear_listing(*job) + rack_listing(racks, units) + warning_listing(job->warnings, units) +
          verdict_listing(verdict, units));
  }
  return status(o, verdict);
}

int nominal_points(const Options& o) {
  const auto grid = parse_grid(*o.grid);
  if (!grid)
    return usage(
        "--points takes two numbers from 2 to 1000, along the profile and along the face, for "
        "example 9x5");
  Door door(o);
  const auto job = door.solve(Scope::gears);
  if (!job) return door.fail(job.error());
  const auto points = nominal_csv(*job, *grid, o.fillet_points);
  if (!points) return door.fail(points.error());
  print(*points);
  return 0;
}

int outline_verb(const Options& o) {
  Door door(o);
  const auto spec = door.read();
  if (!spec) return door.fail(spec.error());
  const auto job = solve_any(*spec, Scope::gears);
  if (!job) return door.fail(job.error());
  const int which = o.gear.value_or(1);
  if (which > job->parts())
    return door.fail(absent_input("gear2", " from the spec; --gear 2 needs a second gear"));
  const auto body = make_body(*job, which);
  if (!body) return door.fail(body.error());
  if (o.csv) {
    print(outline_csv(body->outline, o.points, spec->units()));
  } else if (o.json) {
    Json j = outline_json(body->outline, o.points);
    j["warnings"] = warnings_json(job->warnings);
    print_json(in_units(spec->units(), j));
  } else {
    print(outline_listing(body->outline, o.points, spec->units()));
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
    print(lines + fmt::format("{} of {} cases agree ({} values)\n", cases - bad, cases, values));
  }
  if (bad > 0) std::fprintf(stderr, "gearwright: %d of %d cases differ\n", bad, cases);
  return bad == 0 ? 0 : 1;
}

int schema_verb(const Options& o) {
  print(o.schema == "spec" ? spec_schema() : result_schema().dump(2) + "\n");
  return 0;
}

Result<JobSpec> Door::read(SpecUse use) {
  if (!text_) {
    auto text = read_spec_text(options_.spec);
    if (!text) return text.error();
    text_ = std::move(text).take();
  }
  auto spec = read_spec(*text_, use);
  if (spec) given_ = spec->given;
  return spec;
}

Result<SolvedJob> Door::solve(Scope scope, SpecUse use) {
  const auto spec = read(use);
  if (!spec) return spec.error();
  return gearwright::solve(*spec, scope);
}

int Door::fail(const Error& error) const {
  return apps::fail(given_ ? spelled(error, *given_) : error, options_.json,
                    text_ ? &*text_ : nullptr);
}

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
  if (words.size() > 1 || (a_word && !fs::exists(path))) {
    std::vector<std::string> known;
    for (const Verb& each : verbs()) known.emplace_back(each.name);
    return usage(
        fmt::format("the command `gearwright batch` accepts one of the verbs {}, but not {}{}",
                    verb_names(), printable(path, 60), did_you_mean(path, known)));
  }
  std::ifstream file;
  if (path != "-") file = opened(path);
  std::ios::sync_with_stdio(false);
  std::istream& in = path == "-" ? std::cin : file;
  long long failed = 0;
  long long first_failed = 0;
  long long lines = 0;
  long long violations = 0;
  in_order([&](std::string& line) { return static_cast<bool>(std::getline(in, line)); },
           [&](const std::string& line) {
             return [&, answer = batch_line(verb, line)] {
               using Outcome = BatchLine::Outcome;
               ++lines;
               if (answer.outcome != Outcome::answered && failed++ == 0) first_failed = lines;
               if (answer.outcome == Outcome::violated) ++violations;
               write_line(answer.text);
             };
           },
           o.threads);
  if (in.bad()) throw IoError("cannot read " + path + ": " + std::strerror(errno));
  print("");
  if (failed > 0)
    std::fprintf(
        stderr,
        "gearwright: %lld of %lld specs have no answer; the first of them is in line %lld\n",
        failed, lines, first_failed);
  if (violations > 0)
    std::fprintf(stderr, "gearwright: a defect in Gearwright caused %lld of these failures\n",
                 violations);
  if (lines == 0)
    std::fprintf(stderr,
                 "gearwright: the input contains no spec; the command `gearwright batch` reads one "
                 "JSON spec per line\n");
  return violations > 0 ? kViolated : failed > 0 ? 1 : 0;
}

}  // namespace gearwright::apps
