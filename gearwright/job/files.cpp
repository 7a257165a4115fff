#include "gearwright/job/files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <nlohmann/json.hpp>

#include "gearwright/base/lists.hpp"
#include "gearwright/base/output_file.hpp"
#include "gearwright/base/subject.hpp"
#include "gearwright/cad/drive_solids.hpp"
#include "gearwright/cad/dxf.hpp"
#include "gearwright/cad/mesh_files.hpp"
#include "gearwright/cad/svg_outline.hpp"
#include "gearwright/cad/walls.hpp"
#include "gearwright/catalogue/spelling.hpp"
#include "gearwright/job/contact_answer.hpp"
#include "gearwright/job/contact_report.hpp"
#include "gearwright/job/csv_answer.hpp"
#include "gearwright/job/judgement.hpp"
#include "gearwright/job/load_answer.hpp"
#include "gearwright/job/measures.hpp"
#include "gearwright/job/propose_answer.hpp"
#include "gearwright/job/result_json.hpp"
#include "gearwright/job/run_parts.hpp"
#include "gearwright/job/workshop_drawing.hpp"
#include "gearwright/report/report.hpp"
#include "gearwright/spec/parse_spec.hpp"

namespace gearwright {

namespace fs = std::filesystem;

namespace {

// Returns a note for a file. The note names flank modifications that the file omits, and gears that
// belong to one body but are separate solids in the file.
std::string deviations(const std::vector<ToothedBody>& bodies) {
  std::string note;
  for (const ToothedBody& body : bodies) {
    if (body.same_as) continue;
    for (const SolidGear& gear : body.gears())
      if (const auto& [name, why] = std::tie(gear.body->name, gear.body->unmodified); !why.empty())
        note +=
            fmt::format("; {} is written without its flank modifications, because {}", name, why);
    if (!body.separate.empty()) note += "; " + body.separate;
  }
  return note;
}

// Returns a note about flank modifications for a drawing. Drawings show the teeth as cut.
std::string drawn_as_cut(const std::vector<ToothedBody>& bodies) {
  for (const ToothedBody& body : bodies)
    if (body.modified || !body.unmodified.empty()) return "; without flank modifications";
  return "";
}

Result<JobFile> make_mesh(FileKind kind, const std::vector<ToothedBody>& bodies,
                          const fs::path& path, const FileOptions& options) {
  std::vector<MeshPart> parts;
  std::size_t triangles = 0;
  for (const ToothedBody& body : bodies) {
    if (body.same_as) {
      triangles += parts[*body.same_as].mesh.triangles.size();
      parts.push_back({body.name, {}, body.pose, body.colour, body.same_as});
      continue;
    }
    auto mesh = tessellate(body, {.chord_tolerance_mm = options.mesh_tolerance_mm});
    if (!mesh) return of_body(mesh.error(), body.name);
    triangles += mesh->triangles.size();
    parts.push_back({body.name, std::move(mesh).take(), body.pose, body.colour});
  }
  const char* what = kind == FileKind::stl ? "STL" : kind == FileKind::glb ? "GLB" : "3MF";
  std::string bytes = kind == FileKind::stl   ? stl_bytes(parts)
                      : kind == FileKind::glb ? glb_bytes(parts)
                                              : threemf_bytes(parts);
  return JobFile{path, what, options.mesh_tolerance_mm,
                 fmt::format("{} triangles", triangles) + deviations(bodies), std::move(bytes)};
}

Result<JobFile> make_solid(const std::vector<ToothedBody>& bodies, const fs::path& path,
                           const FileOptions& options) {
  auto made = step_document(bodies, path.filename().string(), {options.step_schema});
  if (!made) {
    for (const ToothedBody& body : bodies)
      for (const SolidGear& gear : body.gears()) {
        if (gear.body->rack) continue;
        if (const auto walls = make_walls(*gear.body); !walls)
          return of_body(walls.error(), gear.body->name);
      }
    return made.error();
  }
  StepDocument document = std::move(made).take();
  return JobFile{path, fmt::format("STEP, {}", to_string(options.step_schema)),
                 document.report.max_deviation_mm,
                 fmt::format("{} faces", document.report.face_count) + deviations(bodies),
                 std::move(document.text)};
}

Result<JobFile> make_drawing(FileKind kind, const std::vector<ToothedBody>& bodies,
                             const fs::path& path, const FileOptions& options) {
  for (const ToothedBody& body : bodies) {
    if (body.pose.axis(2).z() == 1.0) continue;
    return Error{"pair.shaft_angle", "",
                 "gears on crossed axes have no common plane section; write a file for each gear, "
                 "on the command line with --gear 1 and with --gear 2"};
  }
  const auto style =
      options.drawing_splines ? ContourOptions::Style::splines : ContourOptions::Style::biarcs;
  std::optional<double> tolerance;
  if (!options.drawing_splines) tolerance = options.drawing_tolerance_mm;
  auto made = kind == FileKind::svg ? svg_drawing(bodies) : dxf_drawing(bodies, {style, tolerance});
  if (!made) return of_body(made.error(), bodies.front().name);
  Drawing drawing = std::move(made).take();
  const char* what = kind == FileKind::svg     ? "SVG outline"
                     : options.drawing_splines ? "DXF, splines"
                                               : "DXF, arcs";
  return JobFile{path, what, drawing.deviation_mm,
                 fmt::format("{} segments", drawing.segments) + drawn_as_cut(bodies),
                 std::move(drawing.text)};
}

// Returns an error if the spec requests results that are not available for these gears. For a rack
// and its pinion, load, rating, corrections and scatter are not available. For double-helical
// gears, only corrections are not available.
std::optional<Error> beyond(const SolvedJob& job) {
  const bool halves = job.halves[0] && job.pair, rack = job.rack.has_value();
  if (!rack && !halves) return std::nullopt;
  const JobSpec& spec = job.spec;
  const std::pair<const char*, bool> parts[] = {{"load", spec.load.given && rack},
                                                {"rating", spec.rating.given && rack},
                                                {"compensate", spec.compensate.given},
                                                {"scatter", spec.scatter.given && rack}};
  for (const auto& [table, given] : parts) {
    if (!given) continue;
    if (halves)
      return Error{table, "",
                   "is not supported for double-helical gears; without this table, the command "
                   "`gearwright run` writes the report and the files"};
    return Error{table, "",
                 "needs two gears, but gear 2 is a rack; without this table, the command "
                 "`gearwright run` writes the report and the files. For `gearwright load` and "
                 "`gearwright rate`, a gear 2 with teeth = 200 can replace a rack"};
  }
  return std::nullopt;
}

}  // namespace

std::vector<ReportFile> report_files(const std::vector<JobFile>& files) {
  std::vector<ReportFile> rows;
  for (const JobFile& f : files) {
    std::string note = f.note;
    if (f.deviation_mm)
      note += fmt::format("; within {:.3g} µm of the exact surface", f.printed_deviation_um());
    rows.push_back({f.path.filename().string(), f.what, note});
  }
  return rows;
}

bool FileOptions::wants(std::string_view part) const { return only.empty() || is_in(part, only); }

std::string_view ending(FileKind kind) {
  switch (kind) {
    case FileKind::step: return ".step";
    case FileKind::stl: return ".stl";
    case FileKind::glb: return ".glb";
    case FileKind::threemf: return ".3mf";
    case FileKind::dxf: return ".dxf";
    case FileKind::svg: return ".svg";
  }
  contract_failed("postcondition", "known file kind", __FILE__, __LINE__);
}

Error of_body(Error error, const std::string& name) {
  const GearMember of = subject_of(error.field).member;
  const bool of_spec =
      of == GearMember::teeth || of == GearMember::bore || of == GearMember::keyway;
  if (of_spec) return within(name, std::move(error));
  return {name, "", error.rule};
}

Result<ToothedBody> make_body(const SolvedJob& job, int which) {
  const std::string name = gear_field(which);
  if (which == 2 && job.rack) return rack_body(job.rack->rack, name);
  const Gear& gear = job.gear(which);
  if (!gear.tooth) {
    return absent_input(name + ".cut_by",
                        "; a pinion cutter generates the outline of an internal gear; give the "
                        "number of teeth of the cutter, or \"gear1\" for the mating gear");
  }
  if (!gear.exists()) return within(name, gear.why_not());
  auto made = body_as_made(gear, name, job.halves[which - 1], which,
                           job.completed.gear(which).modifications);
  if (!made) return within(name, made.error());
  return made;
}

SolidPose pose_of(const SolvedJob& job, int which) {
  const auto in = [which](const auto& pair) {
    return which == 1 ? in_assembly(pair.pose_1()) : in_assembly(pair.pose_2());
  };
  return job.rack ? in(*job.rack) : job.pair ? in(*job.pair) : SolidPose();
}

Result<JobFile> make_file(FileKind kind, const std::vector<ToothedBody>& bodies,
                          const fs::path& path, const FileOptions& options) {
  GW_EXPECTS(!bodies.empty());
  if (options.on_file) options.on_file(path.filename().string());
  if (kind == FileKind::dxf || kind == FileKind::svg)
    return make_drawing(kind, bodies, path, options);
  const auto make = [&](const std::vector<ToothedBody>& these) {
    return kind == FileKind::step ? make_solid(these, path, options)
                                  : make_mesh(kind, these, path, options);
  };
  auto made = make(bodies);
  if (made) return made;
  // The modified flanks may need too many faces for a file. The file then contains the teeth as
  // cut.
  std::vector<ToothedBody> as_cut = bodies;
  bool modified = false;
  const auto cut = [&](ToothedBody& gear) {
    if (!gear.modified) return;
    modified = true;
    gear.modified = nullptr;
    gear.unmodified = made.error().rule;
  };
  for (ToothedBody& body : as_cut) {
    cut(body);
    for (ToothedBody& gear : body.above) cut(gear);
  }
  if (!modified) return made;
  auto plain = make(as_cut);
  return plain ? std::move(plain) : std::move(made);
}

JobFile result_file(const fs::path& folder, UnitSystem units, const Json& result) {
  return {folder / "result.json", "result", std::nullopt, "all numbers, as JSON",
          json_text(in_units(units, result), 2) + "\n"};
}

void write_files(const std::vector<JobFile>& files) {
  for (const JobFile& f : files) write_file(f.path, f.bytes);
}

namespace {

// Makes solids, meshes, outlines and the drawing. A gear without an outline causes a warning.
Result<std::vector<JobFile>> shape_files(SolvedJob& job, const fs::path& folder,
                                         const FileOptions& options) {
  std::vector<JobFile> made;
  std::vector<ToothedBody> mounted;  // mounted gears that have an outline
  const auto make = [&](FileKind kind, const std::vector<ToothedBody>& bodies,
                        const std::string& name) -> std::optional<Error> {
    if (!options.wants(ending(kind).substr(1))) return std::nullopt;
    auto file = make_file(kind, bodies, folder / (name + std::string(ending(kind))), options);
    if (!file) return file.error();
    made.push_back(std::move(file).take());
    return std::nullopt;
  };
  std::vector<int> drawn;
  for (int which = 1; which <= job.parts(); ++which) {
    const auto body = make_body(job, which);
    if (!body) {
      job.warnings.push_back(
          {WarningCode::no_outline, spelled(body.error(), job.spec.given).message(), which});
      continue;
    }
    drawn.push_back(which);
    for (FileKind kind :
         {FileKind::stl, FileKind::threemf, FileKind::dxf, FileKind::svg, FileKind::step})
      if (auto error = make(kind, {*body}, gear_field(which))) return *std::move(error);
    if (!job.mounted()) continue;
    mounted.push_back(*body);
    mounted.back().pose = pose_of(job, which);
  }
  if (mounted.size() == 2)
    for (FileKind kind : {FileKind::step, FileKind::glb})
      if (auto error = make(kind, mounted, "pair")) return *std::move(error);
  if (!drawn.empty() && options.wants("drawing")) {
    auto file =
        make_workshop_drawing(job, drawn, SheetFormat::pdf, folder / "drawing.pdf", options);
    if (!file) return file.error();
    made.push_back(std::move(file).take());
  }
  return made;
}

}  // namespace

Result<RunFiles> make_everything(SolvedJob& job, const fs::path& folder,
                                 const FileOptions& options) {
  if (auto error = beyond(job)) return *error;
  if (auto error = missing_error(SpecUse::run, job.spec)) return *error;
  const auto contact = contact_part(job, options.progress);
  if (!contact) return contact.error();
  const auto load = load_part(job, options.progress);
  if (!load) return load.error();
  const auto proposed =
      options.wants("report") ? propose_part(job, options.progress) : std::nullopt;
  const auto compensation = compensation_part(job, options.progress);
  if (!compensation) return compensation.error();
  const auto scatter = scatter_part(job, options.progress);
  if (!scatter) return scatter.error();
  std::optional<ScatterView> scatter_shown;
  std::optional<PatternDensity> density;  // computed for a figure of the report, if the results do
                                          // not contain it
  if (*scatter) {
    scatter_shown = scatter_view(job, **scatter);
    if (!scatter_shown->density && !job.halves[0] && options.wants("report"))
      density = density_of(job, **scatter, options.progress);
    if (density) scatter_shown->density = &*density;
  }
  const auto rating = rating_part(job, options.progress);
  if (!rating) return rating.error();
  const RatingAnswer* const rated = *rating ? &**rating : nullptr;
  begin_stage(options.progress, "making the files", 0);
  auto shapes = shape_files(job, folder, options);
  if (!shapes) return shapes.error();
  std::vector<JobFile> files = std::move(shapes).take();

  ReportInput report;
  report.title = job.spec.title;
  report.drawing = job.spec.drawing;
  for (const Gear& g : job.gears) report.gears.push_back(&g);
  report.halves = job.halves;
  report.pair = job.pair;
  if (job.rack) report.rack = &*job.rack;
  if (job.pair && job.ends) {
    RecordLimits limits = pair_limits(job);
    report.pair_ends = {std::move(limits.upper), std::move(limits.lower)};
  }
  for (int which = 1; options.wants("report") && which <= job.parts() && !job.rack; ++which)
    if (const auto body = make_body(job, which))
      if (const auto mass = mass_of(job, which, *body)) report.masses.push_back(*mass);
  report.measures = measure_records(job);
  report.measure_ends = measure_end_records(job);
  report.k_diagrams = k_diagrams(job);
  if (*contact) report.contact = &contact.value()->report;
  report.verdict = judge(job, {*contact ? &contact.value()->answer.judged() : nullptr, rated,
                               load.value().has_value()});
  if (*load && load.value()->report) report.load = &*load.value()->report;
  if (proposed) report.propose = &*proposed;
  if (*compensation) report.compensate = &**compensation;
  if (scatter_shown) report.scatter = &*scatter_shown;
  report.rating = rated;
  report.files = report_files(files);
  report.spec_text = job.spec.text;
  report.units = job.spec.units();
  std::vector<JobFile> all;
  if (options.wants("report")) {
    all.push_back({folder / "report.html", "report", std::nullopt, "one self-contained page",
                   report_html(report)});
  }
  std::move(files.begin(), files.end(), std::back_inserter(all));
  Json result = job_json(job, report.verdict);
  const auto add = [&](const auto& analysis, const auto& found) {
    result[analysis.table().name] = to_json(analysis.record(job, found));
  };
  if (*contact) add(kContactAnalysis, contact.value()->answer);
  if (*load) add(kLoadAnalysis, load.value()->answer);
  if (*compensation) add(kCompensateAnalysis, **compensation);
  if (scatter_shown) result["scatter"] = to_json(scatter_quantities().of(*scatter_shown));
  if (rated) add(kRatingAnalysis, *rated);
  result["files"] = files_json(all);
  if (options.wants("result"))
    all.insert(all.begin(), result_file(folder, job.spec.units(), result));
  return RunFiles{std::move(all), std::move(result), std::move(report.verdict)};
}

Result<RunFiles> write_everything(SolvedJob& job, const fs::path& folder,
                                  const FileOptions& options) {
  auto made = make_everything(job, folder, options);
  if (!made) return made;
  write_run_into(folder, made->files, options);
  return made;
}

}  // namespace gearwright
