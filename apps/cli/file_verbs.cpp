// Runs the verbs `run`, `export` and `import`. `run` writes the result, the report and further
// files of a spec (kRunParts), or only the parts after --only. `export` writes the requested files,
// and `import` prints a REXS file as a spec.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "apps/cli/verbs.hpp"
#include "apps/common/output.hpp"
#include "apps/common/watch.hpp"
#include "gearwright/base/lists.hpp"
#include "gearwright/base/printable.hpp"
#include "gearwright/catalogue/key.hpp"
#include "gearwright/job/drive_answer.hpp"
#include "gearwright/job/drive_job.hpp"
#include "gearwright/job/files.hpp"
#include "gearwright/job/listing.hpp"
#include "gearwright/job/result_json.hpp"
#include "gearwright/job/rexs_export.hpp"
#include "gearwright/job/workshop_drawing.hpp"
#include "gearwright/spec/parse_spec.hpp"
#include "gearwright/spec/rexs_file.hpp"

namespace gearwright::apps {

namespace fs = std::filesystem;

namespace {

// Reports each file on stderr when its computation starts, but only after the first second of work.
class SlowProgress {
 public:
  void operator()(std::string_view what) {
    if (std::chrono::steady_clock::now() - start_ > std::chrono::seconds(1))
      std::fprintf(stderr, "gearwright: making %.*s\n", static_cast<int>(what.size()), what.data());
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

FileOptions file_options(const Options& o) {
  FileOptions options = o.files;
  options.step_schema = o.step_schema == "ap214" ? StepSchema::ap214 : StepSchema::ap242;
  options.on_file = SlowProgress();
  if (!o.sheet.empty()) options.sheet = o.sheet == "A3" ? SheetSize::a3 : SheetSize::a4;
  return options;
}

// Returns the first output that would overwrite another output or the spec, or an empty text if
// there is none.
std::string collision(const Options& o) {
  std::vector<fs::path> taken{fs::weakly_canonical(fs::absolute(o.spec))};
  for (const std::string* name :
       {&o.step, &o.stl, &o.glb, &o.threemf, &o.dxf, &o.svg, &o.drawing, &o.rexs}) {
    if (name->empty()) continue;
    std::error_code error;
    const fs::path path = fs::weakly_canonical(fs::absolute(*name), error);
    const bool device = fs::exists(path, error) && !fs::is_regular_file(path, error);
    if (!add_once(taken, path) && !device) return *name;
  }
  return {};
}

int end_run(const Options& o, UnitSystem units, const RunFiles& made, const std::string& listing,
            const std::vector<Warning>& warnings) {
  if (o.json) {
    // The output is the content of result.json, except that `files` lists all files.
    Json j = made.result;
    j["files"] = files_json(made.files);
    print_json(in_units(units, j));
  } else {
    print(listing + warning_listing(warnings, units) + file_listing(made.files, units) +
          verdict_listing(made.verdict, units));
  }
  return status(o, made.verdict);
}

int run_drive(const Options& o, const Door& door, const JobSpec& spec, const fs::path& out,
              FileOptions options) {
  std::optional<DriveJob> job;
  const auto made = watched("run", [&](Progress* h) -> Result<RunFiles> {
    options.progress = h;
    auto solved = solve_whole_drive(spec, {.contact = Wanted::yes}, h);
    if (!solved) return solved.error();
    job = std::move(solved).take();
    return write_drive_files(*job, out, options);
  });
  if (!made) return door.fail(made.error());
  return end_run(o, spec.units(), *made, drive_listing(job->drive, spec.units()),
                 job->drive.findings);
}

using WantedFiles = std::vector<std::pair<FileKind, const std::string*>>;

struct Exported {
  std::vector<JobFile> files{};
  std::vector<Warning> warnings{};
  /// Appends the file and returns none, or returns its error.
  std::optional<Error> add(Result<JobFile> file) {
    if (!file) return file.error();
    files.push_back(std::move(file).take());
    return std::nullopt;
  }
};

// Makes the requested files of a drive, or of the part that --gear names.
Result<Exported> export_drive(const Options& o, const JobSpec& spec, const WantedFiles& wanted) {
  const auto job = solve_drive(spec);
  if (!job) return job.error();
  Exported made{{}, job->drive.findings};
  const FileOptions options = file_options(o);
  std::optional<Result<std::vector<ToothedBody>>> bodies;
  for (const auto& [kind, path] : wanted) {
    if (path->empty()) continue;
    if (!bodies) bodies = o.part.empty() ? drive_bodies(*job) : drive_part(*job, o.part);
    if (!*bodies) return bodies->error();
    if (auto error = made.add(make_drive_file(kind, *job, **bodies, *path, options))) return *error;
  }
  if (!o.rexs.empty())
    if (auto error = made.add(make_rexs(*job, o.rexs))) return *error;
  return made;
}

// Makes the requested files of a pair, or of the gear `gear`.
Result<Exported> export_pair(const Options& o, const JobSpec& spec, const WantedFiles& wanted,
                             const std::optional<int>& gear) {
  // A drawing contains data of the mating gear, so the pair must be solved.
  const bool alone = gear && o.drawing.empty();
  const auto job = solve_any(spec, alone ? Scope::gears : Scope::everything);
  if (!job) return job.error();
  const int count = job->parts();
  if (gear && *gear > count)
    return absent_input("gear2", " from the spec; --gear 2 needs a second gear");
  std::vector<ToothedBody> bodies;
  std::vector<int> drawn;
  for (int which = 1; which <= count; ++which) {
    if (gear && *gear != which) continue;
    drawn.push_back(which);
    auto body = make_body(*job, which);
    if (!body) return body.error();
    bodies.push_back(std::move(body).take());
    if (!gear) bodies.back().pose = pose_of(*job, which);
  }
  Exported made{{}, job->warnings};
  const FileOptions options = file_options(o);
  for (const auto& [kind, path] : wanted)
    if (!path->empty())
      if (auto error = made.add(make_file(kind, bodies, *path, options))) return *error;
  if (const auto format = sheet_format(o.drawing); format)
    if (auto error = made.add(make_workshop_drawing(*job, drawn, *format, o.drawing, options)))
      return *error;
  if (!o.rexs.empty())
    if (auto error = made.add(make_rexs(*job, o.rexs))) return *error;
  return made;
}

}  // namespace

int run_verb(const Options& o) {
  if (o.out && o.out->empty()) return usage("--out needs the name of a folder");
  const bool nameless = o.spec == "-" || (fs::exists(o.spec) && !fs::is_regular_file(o.spec) &&
                                          !fs::is_directory(o.spec));
  if (!o.out && nameless) {
    return usage(
        "the default folder has the name of the spec file, but this spec is not a file; give a "
        "folder with --out DIR");
  }
  FileOptions options = file_options(o);
  if (o.only) {
    const auto parts = split(*o.only, ',');
    options.only.assign(parts.begin(), parts.end());
    const std::vector<std::string> known(kRunParts.begin(), kRunParts.end());
    for (const std::string& part : options.only) {
      if (is_in(part, known)) continue;
      return usage(fmt::format(
          "--only takes one or more of {}, separated by commas, for example --only step,report{}",
          fmt::join(known, ", "), did_you_mean(part, known)));
    }
  }
  Door door(o);
  auto spec = door.read(SpecUse::run);
  if (!spec) return door.fail(spec.error());
  fs::path out = o.out.value_or("");
  if (out.empty()) {
    out = fs::path(o.spec);
    if (out.extension() == ".toml" || out.extension() == ".json" || is_rexs(out))
      out.replace_extension();
    out += "_out";
  }
  if (spec->drive && options.sheet)
    return usage("--sheet is not available for a drive, because a drive has no workshop drawing");
  if (spec->drive) return run_drive(o, door, *spec, out, options);
  std::optional<SolvedJob> job;
  const auto made = watched("run", [&](Progress* h) -> Result<RunFiles> {
    options.progress = h;
    auto solved = solve_any(*spec, Scope::everything);
    if (!solved) return solved.error();
    job = std::move(solved).take();
    return write_everything(*job, out, options);
  });
  if (!made) return door.fail(made.error());
  return end_run(o, spec->units(), *made, gear_listing(*job) + pair_listing(*job), job->warnings);
}

namespace {

// Returns a message about the first file whose name ends like the files of another option. The text
// is empty if there is no such file.
std::string foreign_ending(const WantedFiles& wanted) {
  for (const auto& [kind, path] : wanted) {
    for (const auto& [other, unused] : wanted) {
      if (other != kind && path->ends_with(ending(other)))
        return fmt::format("--{} does not write the format of {}; use --{}", ending(kind).substr(1),
                           *path, ending(other).substr(1));
    }
  }
  return "";
}

}  // namespace

int export_verb(const Options& o) {
  const WantedFiles wanted{{FileKind::step, &o.step}, {FileKind::stl, &o.stl},
                           {FileKind::glb, &o.glb},   {FileKind::threemf, &o.threemf},
                           {FileKind::dxf, &o.dxf},   {FileKind::svg, &o.svg}};
  bool any = !o.drawing.empty() || !o.rexs.empty();
  for (const auto& [kind, path] : wanted) any = any || !path->empty();
  if (!any)
    return usage(
        "the command `gearwright export` needs at least one of the options --step, --stl, --glb, "
        "--3mf, --dxf, --svg, --drawing and --rexs, with a file name");
  std::optional<int> gear;
  if (o.part == "1" || o.part == "2") gear = o.part == "1" ? 1 : 2;
  if (gear && !o.rexs.empty()) return usage("--rexs writes both gears of a pair; leave out --gear");
  if (!o.drawing.empty() && !sheet_format(o.drawing))
    return usage("--drawing needs a file name that ends in .pdf, .svg or .dxf, not " + o.drawing);
  if (const std::string message = foreign_ending(wanted); !message.empty()) return usage(message);
  if (const std::string name = collision(o); !name.empty())
    return usage(name + " is the name of two output files or of the spec");
  Door door(o);
  const auto spec = door.read();
  if (!spec) return door.fail(spec.error());
  const bool drive = spec->drive != nullptr;
  if (drive && !o.drawing.empty())
    return usage(
        "--drawing is not available for a drive; this option writes the drawing of a gear or a "
        "pair");
  if (drive && !o.part.empty() && !o.rexs.empty())
    return usage("--rexs writes the whole drive; leave out --gear");
  if (!drive && !o.part.empty() && !gear)
    return usage("for a pair, --gear must be 1 or 2; only the parts of a drive have names");
  const auto made = watched("export", [&](Progress* progress) {
    progress->begin("making the files", 0);
    auto files = drive ? export_drive(o, *spec, wanted) : export_pair(o, *spec, wanted, gear);
    if (!files) return files;
    progress->begin_writing();
    write_files(files->files);
    return files;
  });
  if (!made) return door.fail(made.error());
  const UnitSystem units = spec->units();
  if (o.json) {
    print_json(in_units(
        units, {{"files", files_json(made->files)}, {"warnings", warnings_json(made->warnings)}}));
  } else {
    print(warning_listing(made->warnings, units) + file_listing(made->files, units));
  }
  return 0;
}

int import_verb(const Options& o) {
  const Door door(o);
  const auto text = read_spec_text(o.spec);
  if (!text) return door.fail(text.error());
  print(text->text);
  return 0;
}

}  // namespace gearwright::apps
