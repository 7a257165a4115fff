#include "apps/cli/command_line.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "apps/common/output.hpp"
#include "gearwright/base/printable.hpp"
#include "gearwright/base/version.hpp"
#include "gearwright/catalogue/key.hpp"
#include "gearwright/job/campaign.hpp"
#include "gearwright/job/files.hpp"
#include "gearwright/job/verbs.hpp"
#include "gearwright/spec/rexs_file.hpp"

namespace gearwright::apps {

namespace {

constexpr const char* kIntroduction =
    "Gearwright: exact geometry, mesh and CAD files of cylindrical gears.\n\n"
    "  gearwright run pair.toml              everything: report.html, STEP, STL, 3MF, GLB, DXF, "
    "SVG\n"
    "  gearwright pair pair.toml --json      one of the results below, as JSON\n"
    "  gearwright search wish.toml --out found  all designs within limits, ranked\n"
    "  gearwright outline pair.toml --gear 1 --points 200 --json\n"
    "  gearwright export pair.toml --step both.step --dxf pinion.dxf --gear 1\n"
    "  gearwright export pair.toml --drawing pair.pdf  the workshop drawing, a sheet for each "
    "gear\n"
    "  gearwright batch pair specs.jsonl     one spec per line, one answer per line\n"
    "  gearwright verify cases.json          comparison with published numbers\n"
    "  gearwright schema spec                JSON Schema of specs (or of results), for editors\n"
    "  gearwright completion bash            completion for bash, zsh or fish\n\n"
    "A spec is a TOML file. The smallest one is:\n\n"
    "  [gear1]\n"
    "  teeth = 17\n"
    "  normal_module_mm = 2.5\n";

constexpr std::size_t kLettersOff = 3;  // in a word of n letters, n/3 letters may be wrong, but at
                                        // least one

// Returns the version. For a lean build (cmake/gw_lean.cmake), the text also lists the functions
// that this build lacks.
std::string version_text() {
  return fmt::format("gearwright {}{}", kVersion,
                     refuse_folder() ? ", without the option --out of the verb search" : "");
}

// Checks a tolerance. The range check of CLI11 is not used, because it accepts NaN.
CLI::Validator between(const ToleranceRange& range) {
  return CLI::Validator(
      [range](const std::string& text) {
        double value = 0.0;
        const bool good = CLI::detail::lexical_cast(text, value) && value >= range.least &&
                          value <= range.greatest;
        return good ? std::string()
                    : fmt::format("{} must lie between {} and {}", text, range.least,
                                  range.greatest);
      },
      fmt::format("{}...{}", range.least, range.greatest));
}

void spec_argument(CLI::App* sub, Options& o) {
  sub->add_option("SPEC", o.spec,
                  "The spec file in TOML, in JSON if its name ends in .json, or in REXS if its "
                  "name ends in .rexs, .rexsj or .rexsz; - is standard input")
      ->required();
}

void csv_flag(CLI::App* sub, Options& o) {
  sub->add_flag("--csv", o.csv, "Print only a table for a spreadsheet (CSV)")->excludes("--json");
}

void sheet_option(CLI::App* sub, Options& o) {
  sub->add_option("--sheet", o.sheet,
                  "Sheet of the workshop drawing, A4 or A3 (default: A4, or A3 if the scale on A4 "
                  "would be smaller than 1:2)")
      ->check(CLI::IsMember({"A4", "A3"}));
}

void strict_flag(CLI::App* sub, Options& o) {
  sub->add_flag("--strict", o.strict, "Exit with status 4 if the verdict is not green");
}

}  // namespace

std::vector<const CLI::App*> verbs_of(const CLI::App& app) {
  return app.get_subcommands([](const CLI::App* sub) { return !sub->get_group().empty(); });
}

CommandLine::CommandLine() : app_(kIntroduction, "gearwright") {
  app_.set_version_flag("-V,--version", version_text());
  app_.require_subcommand(1);
  app_.allow_windows_style_options(false);  // a path may begin with a slash, also on Windows
  add_run();
  add_answering();
  add_files();
  add_others();
  for (CLI::App* sub : app_.get_subcommands({}))
    sub->set_version_flag("-V,--version", version_text());
}

CLI::App* CommandLine::verb(const char* name, const char* what, const char* example, Work work) {
  CLI::App* sub = app_.add_subcommand(name, what);
  work_[sub] = std::move(work);
  sub->footer(std::string("Example:\n  ") + example);
  return sub;
}

CLI::App* CommandLine::json_verb(const char* name, const char* what, const char* example,
                                 Work work) {
  CLI::App* sub = verb(name, what, example, std::move(work));
  sub->add_flag("--json", options_.json, "Print one JSON object to stdout and nothing else");
  return sub;
}

void CommandLine::add_run() {
  Options& o = options_;
  CLI::App* run = json_verb("run", "Write into a folder all files that can be made from this spec",
                            "gearwright run examples/helical_pair.toml --out helical",
                            [&o] { return run_verb(o); });
  spec_argument(run, o);
  run->add_option("--out", o.out,
                  "Folder for the files (default: the name of the spec without .toml, plus _out)");
  strict_flag(run, o);
  run->add_option(
      "--only", o.only,
      fmt::format("Write only these files, separated by commas: {}", fmt::join(kRunParts, ", ")));
  sheet_option(run, o);
}

void CommandLine::add_answering() {
  Options& o = options_;
  for (const Verb& row : verbs()) {
    CLI::App* sub =
        json_verb(row.name, row.meaning, row.example, [this, &row] { return answer(row); });
    spec_argument(sub, o);
    if (row.csv) csv_flag(sub, o);
    if (row.strict) strict_flag(sub, o);
    if (row.take == Verb::Take::flag)
      sub->add_flag_callback(
          "--take", [&o] { o.take = 1; }, row.take_meaning);
    if (row.take == Verb::Take::number)
      sub->add_option("--take", o.take, row.take_meaning)->check(CLI::Range(1, kMostTaken));
  }
  app_.get_subcommand("gear")->add_option(
      "--as-rack", o.as_rack,
      "Describe the same teeth by another rack with the given module and pressure angle, "
      "MODULE,ANGLE; one of the two values may be empty");
  add_study_options(app_.get_subcommand("scatter"), study_);
  CLI::App* search = app_.get_subcommand("search");
  add_search_options(search, search_);
  // The verb of the table searches in memory. The program can also search in a folder.
  work_[search] = [this, &o] {
    search_.spec = o.spec;
    search_.json = o.json;
    search_.take = o.take;
    return run_search_verb(search_);
  };
  CLI::App* drive = app_.get_subcommand("drive");
  drive->add_flag_callback(
      "--expand", [&o] { o.expand = true; },
      "Translate the spec into the graph form, [drive], and print only this graph");
  drive
      ->add_option("--harmonics", o.harmonics,
                   "Number of harmonics of the phases and of the transmission error (default 3)")
      ->check(CLI::Range(1, 31));
  CLI::App* measure = app_.get_subcommand("measure");
  CLI::Option* points =
      measure->add_option("--points", o.grid,
                          "Print nominal points and normals of the flanks for a measuring machine "
                          "(CSV); 9x5 prints 9 points along the profile times 5 along the face");
  measure
      ->add_option("--fillet-points", o.fillet_points,
                   "With --points, also print this number of points along each root fillet, at the "
                   "same positions along the face")
      ->needs(points)
      ->check(CLI::Range(2, 1000));

  CLI::App* outline =
      json_verb("outline", "Points of the transverse tooth outline, per named arc",
                "gearwright outline examples/helical_pair.toml --gear 2 --points 100",
                [&o] { return outline_verb(o); });
  spec_argument(outline, o);
  csv_flag(outline, o);
  outline->add_option("--gear", o.gear, "Number of the gear, 1 or 2 (default 1)")
      ->check(CLI::Range(1, 2));
  outline->add_option("--points", o.points, "Points per arc, both ends included (default 50)")
      ->check(CLI::Range(2, 1000000));
}

void CommandLine::add_files() {
  Options& o = options_;
  CLI::App* files =
      json_verb("export", "CAD files of one gear, or of both gears in place",
                "gearwright export examples/helical_pair.toml --step pair.step --glb pair.glb",
                [&o] { return export_verb(o); });
  spec_argument(files, o);
  files
      ->add_option("--gear", o.part,
                   "Export only this gear, 1 or 2, in its own frame. For a drive, give the name of "
                   "a part, such as planet; the file contains this part lying on its face. Without "
                   "this option, all gears are exported "
                   "in place")
      ->check(CLI::Validator(
          [](const std::string& name) {
            return name.empty() ? std::string("must be 1, 2 or the name of a gear") : std::string();
          },
          "GEAR"));
  files->add_option("--step", o.step, "STEP solid");
  files->add_option("--stl", o.stl, "STL mesh, binary");
  files->add_option("--glb", o.glb, "GLB (glTF 2.0) mesh");
  files->add_option("--3mf", o.threemf, "3MF mesh");
  files->add_option("--dxf", o.dxf, "DXF outline");
  files->add_option("--svg", o.svg, "SVG outline");
  files->add_option("--drawing", o.drawing,
                    "Workshop drawing with the gear data, one sheet for each gear or rack: .pdf, "
                    ".svg or .dxf");
  files->add_option("--rexs", o.rexs,
                    "REXS 1.7 file (exchange format for gear units) of a pair or a drive: .rexs, "
                    ".rexsj for JSON, or .rexsz for a ZIP archive");
  sheet_option(files, o);
  files
      ->add_option("--step-schema", o.step_schema,
                   "Schema of the STEP file: ap242 (default), or ap214 for older systems")
      ->check(CLI::IsMember({"ap242", "ap214"}));
  files
      ->add_option("--mesh-tolerance", o.files.mesh_tolerance_mm,
                   "Greatest distance, in mm, of the mesh from the exact surface (default 0.005)")
      ->check(between(kMeshTolerances));
  files
      ->add_option("--dxf-tolerance", o.files.drawing_tolerance_mm,
                   "Greatest distance, in mm, of the arcs in DXF files and drawings from the exact "
                   "outline (default 0.001)")
      ->check(between(kDrawingTolerances));
  files->add_flag("--dxf-splines", o.files.drawing_splines,
                  "Write splines (exact within 1 nm) instead of arcs to DXF files");
}

void CommandLine::add_others() {
  Options& o = options_;
  CLI::App* batch =
      verb("batch",
           "Read one spec per line (JSON) and write one answer per line, in order, "
           "on all cores",
           "gearwright batch pair specs.jsonl > answers.jsonl", [&o] { return batch_verb(o); });
  batch
      ->add_option(
          "VERB", o.words,
          fmt::format("One of the verbs {} (default: the verb pair for two gears, the verb gear "
                      "for a single gear), then a file (default: -, standard input)",
                      verb_names()))
      ->expected(0, 2);
  batch
      ->add_option("--threads", o.threads,
                   "Number of threads (default: as many as the machine has)")
      ->check(CLI::Range(1, 1024));

  CLI::App* import =
      verb("import", "Print a REXS file as a spec; every verb also reads REXS files directly",
           "gearwright import gearbox.rexs > gearbox.toml", [&o] { return import_verb(o); });
  spec_argument(import, o);

  CLI::App* verify =
      json_verb("verify",
                "Compare results with case files of published numbers and list "
                "differences",
                "gearwright verify tests/golden/external.json", [&o] { return verify_verb(o); });
  verify->add_option("CASES", o.cases, "Case files")->required();

  CLI::App* schema =
      json_verb("schema", "The JSON Schema of specs or of results, for editors and validators",
                "gearwright schema spec > spec.schema.json", [&o] { return schema_verb(o); });
  schema->add_option("WHAT", o.schema, "spec or result")
      ->required()
      ->check(CLI::IsMember({"spec", "result"}));

  CLI::App* shell = verb("completion", "Completion of verbs, options and files for a shell",
                         "source <(gearwright completion bash)",
                         [this] { return print(completion(options_.shell, app_)), 0; });
  shell->add_option("SHELL", o.shell, "bash, zsh or fish")
      ->required()
      ->check(CLI::IsMember({"bash", "zsh", "fish"}));
  verb("manual", "The manual page for the command man, with verbs, options and the keys of a spec",
       "gearwright manual > gearwright.1; man ./gearwright.1",
       [this] { return print(manual_page(app_)), 0; });
}

int CommandLine::unknown_verb(const std::string& word) const {
  if (word.ends_with(".toml") || word.ends_with(".json") || is_rexs(word))
    return usage(fmt::format(
        "there is no verb {0}; give a verb before the spec, for example gearwright run {0}",
        printable(word, 60)));
  std::string best;
  std::string all;
  std::size_t least = std::max<std::size_t>(2, word.size() / kLettersOff + 1);
  for (const CLI::App* sub : verbs_of(app_)) {
    const std::string& name = sub->get_name();
    all += (all.empty() ? "" : ", ") + name;
    const bool begins = word.size() > 1 && name.starts_with(word);
    // If the first two letters of both words agree, one wrong letter is not counted.
    const bool alike = word.size() > 2 && name.starts_with(word.substr(0, 2));
    const std::size_t off = begins ? 1 : edit_distance(word.substr(0, 80), name) - alike;
    if (off >= least) continue;
    least = off;
    best = name;
  }
  return usage(fmt::format(
      "there is no verb {}; {} (the command `gearwright --help` describes each verb)",
      printable(word, 60), best.empty() ? "verbs: " + all : "did you mean " + best + "?"));
}

int CommandLine::unknown_option(const std::string& word) const {
  const CLI::App* const sub = app_.get_subcommands().front();
  std::vector<std::string> known;
  for (const CLI::Option* option : sub->get_options())
    for (const std::string& name : option->get_lnames()) known.push_back("--" + name);
  const std::string given = word.substr(0, word.find('='));
  return usage(fmt::format(
      "{0} has no option {1}{2} (the command `gearwright {0} --help` lists the options)",
      sub->get_name(), printable(given, 60), did_you_mean(given, known)));
}

std::optional<int> CommandLine::answer_at_once(const std::vector<std::string>& words) const {
  if (words.empty() || words[0].starts_with('-')) return std::nullopt;
  const bool help = words[0] == "help";
  if (help && words.size() == 1) {
    print(app_.help());
    return 0;
  }
  const std::string& word = words[help ? 1 : 0];
  const auto named = app_.get_subcommands([&](const CLI::App* s) { return s->get_name() == word; });
  const CLI::App* verb = named.empty() ? nullptr : named.front();
  if (help && word.starts_with('-')) return std::nullopt;
  if (!verb) return unknown_verb(word);
  if (!help) return std::nullopt;
  print(verb->help("gearwright"));
  return 0;
}

int CommandLine::answer(const Verb& row) const {
  const Options& o = options_;
  if (o.as_rack) return gear_as_rack(o);
  if (o.grid) return nominal_points(o);
  return row.use == SpecUse::scatter ? scatter(row) : answering_verb(row, o);
}

int CommandLine::scatter(const Verb& row) const {
  StudyCommand study = study_;
  study.json = options_.json;
  study.csv = options_.csv;
  const auto text = read_spec_text(options_.spec);
  if (!text) return fail(text.error(), study.json);
  const auto spec = read_spec(*text);
  const bool designs = spec && spec->search && !spec->gears[0];
  if (!study.given() && !designs) return answering_verb(row, options_, &*text);
  if (options_.take)
    return usage(
        "--take is only for one pair; the command `gearwright search SPEC --take N` prints the "
        "spec of a design");
  return run_study_verb(study, *text);
}

int CommandLine::run(std::vector<std::string> words) {
  if (const auto status = answer_at_once(words)) return *status;
  try {
    std::reverse(words.begin(), words.end());  // CLI11 requires the reverse order
    app_.parse(std::move(words));
  } catch (const CLI::ExtrasError& e) {
    for (const std::string& word : app_.remaining(true))
      if (word.starts_with("--") && !app_.get_subcommands().empty()) return unknown_option(word);
    return app_.exit(e) == 0 ? 0 : 2;
  } catch (const CLI::ParseError& e) {
    return app_.exit(e) == 0 ? 0 : 2;
  }
  return guarded(work_.at(app_.get_subcommands().front()), options_.json);
}

}  // namespace gearwright::apps
