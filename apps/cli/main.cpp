// gearwright: the program. Parses the command line, calls the job room, prints.
//
// Exit status: 0 done; 1 the input is wrong or the gears are impossible; 2 the command line is
// wrong; 3 the outside world failed; 4 with --strict: the verdict is not green.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <csignal>
#include <exception>
#include <new>

#include "apps/cli/verbs.hpp"
#include "apps/common/search_verb.hpp"
#include "gearwright/base/output_file.hpp"
#include "gearwright/base/version.hpp"

namespace {

using gearwright::cli::Options;

constexpr const char* kIntroduction =
    "Gearwright: exact geometry, mesh and CAD files of cylindrical gears.\n\n"
    "  gearwright run pair.toml              everything: report.html, STEP, STL, 3MF, GLB, DXF, "
    "SVG\n"
    "  gearwright gear pair.toml             diameters, thicknesses, limits of each gear\n"
    "  gearwright pair pair.toml --json      the mounted pair, as JSON\n"
    "  gearwright contact pair.toml          transmission error and contact under [errors]\n"
    "  gearwright compensate pair.toml       corrections that cancel those errors\n"
    "  gearwright measure pair.toml          the calliper's settings\n"
    "  gearwright fit wish.toml              gears for a centre distance and a shaft angle\n"
    "  gearwright search wish.toml --out found  all designs within limits, ranked\n"
    "  gearwright outline pair.toml --gear 1 --points 200 --json\n"
    "  gearwright export pair.toml --step both.step --dxf pinion.dxf --gear 1\n"
    "  gearwright verify cases.json          published numbers against ours\n"
    "  gearwright schema spec                the JSON Schema of specs, for editors; or of "
    "results\n\n"
    "A spec is a TOML file, the least one:\n\n"
    "  [gear1]\n"
    "  teeth = 17\n"
    "  normal_module_mm = 2.5\n";

constexpr const char* kNotHere[] = {"identify"};

CLI::App* verb(CLI::App& app, Options& o, const char* name, const char* what, const char* example) {
  CLI::App* sub = app.add_subcommand(name, what);
  sub->footer(std::string("Example:\n  ") + example);
  sub->add_flag("--json", o.json, "Print one JSON object to stdout and nothing else");
  return sub;
}

// CLI11's own range lets nan pass.
CLI::Validator between(double lo, double hi) {
  return CLI::Validator(
      [lo, hi](const std::string& text) {
        double value = 0.0;
        const bool good = CLI::detail::lexical_cast(text, value) && value >= lo && value <= hi;
        return good ? std::string() : fmt::format("{} must lie between {} and {}", text, lo, hi);
      },
      fmt::format("{}...{}", lo, hi));
}

void spec_argument(CLI::App* sub, Options& o) {
  sub->add_option("SPEC", o.spec, "The spec file: TOML, or JSON if its name ends in .json")
      ->required();
}

void strict_flag(CLI::App* sub, Options& o) {
  sub->add_flag("--strict", o.strict, "Exit status 4 where the verdict is not green");
}

}  // namespace

int main(int argc, char** argv) {
  std::signal(SIGXFSZ, SIG_IGN);  // a file size limit is a full disk: write() says so
  Options o;
  CLI::App app(kIntroduction, "gearwright");
  app.set_version_flag("--version", std::string("gearwright ") + gearwright::kVersion);
  app.require_subcommand(1);
  const CLI::Range gears(1, 2);

  CLI::App* run = verb(app, o, "run", "Everything that applies to the spec, into a folder",
                       "gearwright run examples/helical_pair.toml --out helical");
  spec_argument(run, o);
  run->add_option("--out", o.out,
                  "Folder for the files; default: the spec's name without .toml, plus _out");

  strict_flag(run, o);

  CLI::App* gear =
      verb(app, o, "gear", "Geometry of each gear: diameters, thicknesses, limits, flags",
           "gearwright gear examples/helical_pair.toml --json");
  spec_argument(gear, o);

  gear->add_option("--as-rack", o.as_rack,
                   "MODULE,ANGLE: the same teeth as that rack describes them; one may be empty");

  CLI::App* outline =
      verb(app, o, "outline", "Points of the transverse tooth outline, per named arc",
           "gearwright outline examples/helical_pair.toml --gear 2 --points 100");
  spec_argument(outline, o);
  outline->add_option("--gear", o.gear, "Which gear, 1 or 2 (default 1)")->check(gears);
  outline->add_option("--points", o.points, "Points per arc, both ends included (default 50)")
      ->check(CLI::Range(2, 1000000));

  CLI::App* pair =
      verb(app, o, "pair", "The mounted pair: distances, angles, contact ratios, backlash, sliding",
           "gearwright pair examples/helical_pair.toml");
  spec_argument(pair, o);

  strict_flag(pair, o);

  CLI::App* contact = verb(app, o, "contact",
                           "Tooth contact under the spec's [errors]: transmission error, contact "
                           "points, edges, ellipses",
                           "gearwright contact examples/misaligned_pair.toml");
  spec_argument(contact, o);

  strict_flag(contact, o);

  CLI::App* compensate = verb(app, o, "compensate",
                              "Tool settings, leads and crowning that cancel the spec's [errors]",
                              "gearwright compensate examples/misaligned_pair.toml --take");
  spec_argument(compensate, o);
  compensate->add_flag("--take", o.spec_only, "Print the corrected spec and nothing else");

  strict_flag(compensate, o);

  CLI::App* measure = verb(app, o, "measure", "Chordal tooth thickness, the calliper's settings",
                           "gearwright measure examples/helical_pair.toml");
  spec_argument(measure, o);

  CLI::App* fit = verb(app, o, "fit",
                       "Gears for a place, or places for gears: what the spec leaves out is found",
                       "gearwright fit examples/crossed_fit.toml");
  spec_argument(fit, o);
  fit->add_option("--take", o.take, "Print the spec of this branch and nothing else")
      ->check(CLI::Range(1, 1000));

  gearwright::cli::SearchCommand search_command;
  CLI::App* search = gearwright::cli::add_search(app, search_command);

  CLI::App* files =
      verb(app, o, "export", "CAD files of one gear, or of both in place",
           "gearwright export examples/helical_pair.toml --step pair.step --glb pair.glb");
  spec_argument(files, o);
  files->add_option("--gear", o.gear, "Only this gear, in its own frame; absent: both in place")
      ->check(gears);
  files->add_option("--step", o.step, "STEP AP242 solid");
  files->add_option("--stl", o.stl, "STL mesh, binary");
  files->add_option("--glb", o.glb, "GLB (glTF 2.0) mesh");
  files->add_option("--3mf", o.threemf, "3MF mesh");
  files->add_option("--dxf", o.dxf, "DXF outline");
  files->add_option("--svg", o.svg, "SVG outline");
  files
      ->add_option("--mesh-tolerance", o.mesh_tolerance,
                   "mm between mesh and exact surface (default 0.005)")
      ->check(between(1e-5, 10.0));
  files
      ->add_option("--dxf-tolerance", o.drawing_tolerance,
                   "mm between DXF arcs and exact outline (default 0.001)")
      ->check(between(1e-7, 1.0));
  files->add_flag("--dxf-splines", o.drawing_splines,
                  "DXF as splines (within 1 nm) instead of arcs");

  CLI::App* verify =
      verb(app, o, "verify", "Runs case files of published numbers and says what differs",
           "gearwright verify tests/golden/external.json");
  verify->add_option("CASES", o.cases, "Case files")->required();

  CLI::App* schema =
      verb(app, o, "schema", "The JSON Schema of specs or of results, for editors and validators",
           "gearwright schema spec > spec.schema.json");
  schema->add_option("WHAT", o.schema, "spec or result")
      ->required()
      ->check(CLI::IsMember({"spec", "result"}));

  for (const char* name : kNotHere) {
    CLI::App* sub = app.add_subcommand(name, "Not in this version")->group("");
    sub->allow_extras();
  }

  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& e) {
    return app.exit(e) == 0 ? 0 : 2;
  }
  for (const char* name : kNotHere) {
    if (!app.got_subcommand(name)) continue;
    std::cerr << "gearwright: the verb " << name
              << " is not in this version; see gearwright --help\n";
    return 2;
  }
  using namespace gearwright::cli;
  try {
    if (*run) return run_verb(o);
    if (*gear) return gear_verb(o);
    if (*outline) return outline_verb(o);
    if (*pair) return pair_verb(o);
    if (*contact) return contact_verb(o);
    if (*compensate) return compensate_verb(o);
    if (*measure) return measure_verb(o);
    if (*fit) return fit_verb(o);
    if (*search) return run_search_verb(search_command);
    if (*files) return export_verb(o);
    if (*schema) return schema_verb(o);
    return verify_verb(o);
  } catch (const gearwright::IoError& e) {
    std::cerr << "gearwright: " << e.what() << "\n";
  } catch (const std::bad_alloc&) {
    std::cerr << "gearwright: out of memory; a narrower face, fewer teeth or a coarser tolerance "
                 "would help\n";
  } catch (const std::exception& e) {
    std::cerr << "gearwright: " << e.what() << "\n";
  }
  return 3;
}
