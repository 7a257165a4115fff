#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "gearwright/base/printable.hpp"
#include "gearwright/cad/drive_solids.hpp"
#include "gearwright/catalogue/drive_quantities.hpp"
#include "gearwright/job/drive_job.hpp"
#include "gearwright/job/result_json.hpp"
#include "gearwright/report/drive_report.hpp"
#include "gearwright/spec/parse_spec.hpp"

namespace gearwright {

namespace fs = std::filesystem;

namespace {

// Makes the solids and outlines of a drive. If a kind of file is not possible for the drive, it is
// omitted. If the user has named this kind, the result is an error with the reason instead.
Result<std::vector<JobFile>> shape_files(const DriveJob& job, const fs::path& folder,
                                         const FileOptions& options) {
  std::vector<JobFile> files;
  const bool named = !options.only.empty();
  if (named && options.wants("drawing"))
    return Error{"drive", "",
                 "has no drawing; to get drawings of the gears of mesh N, write this mesh as a "
                 "pair with the command `gearwright drive SPEC --take N`, and use the command "
                 "`gearwright run` with this pair"};
  std::vector<FileKind> kinds{FileKind::step, FileKind::glb, FileKind::threemf};
  if (named) kinds.push_back(FileKind::stl);
  if (named || (job.layout && job.layout->sections.size() == 1))
    kinds.insert(kinds.end(), {FileKind::dxf, FileKind::svg});
  std::erase_if(kinds, [&](FileKind kind) { return !options.wants(ending(kind).substr(1)); });
  if (kinds.empty()) return files;
  const auto bodies = drive_bodies(job);
  if (!bodies && named) return bodies.error();
  if (!bodies) return files;  // the report states the reason
  for (const FileKind kind : kinds) {
    auto file = make_drive_file(kind, job, *bodies, folder / ("drive" + std::string(ending(kind))),
                                options);
    if (!file) return file.error();
    files.push_back(std::move(file).take());
  }
  return files;
}

}  // namespace

Result<std::vector<ToothedBody>> drive_bodies(const DriveJob& job) {
  if (!job.layout) return job.layout_error;
  return drive_solids(job.drive, *job.layout);
}

Result<std::vector<ToothedBody>> drive_part(const DriveJob& job, const std::string& name) {
  auto bodies = drive_bodies(job);
  if (!bodies) return bodies.error();
  std::vector<std::string> names;
  for (const ToothedBody& body : *bodies) {
    if (body.same_as) continue;
    bool has_gear = body.name == name || body.name == name + " 1";
    for (const SolidGear& gear : body.gears()) has_gear = has_gear || gear.body->name == name;
    if (!has_gear) {
      names.push_back(body.name.ends_with(" 1") ? body.name.substr(0, body.name.size() - 2)
                                                : body.name);
      continue;
    }
    ToothedBody alone = body;
    alone.name = name;
    std::vector<ToothedBody> part = laid_out({std::move(alone)});
    SolidPose& pose = part.front().pose;
    const Vec3 aside(pose.origin().x(), pose.origin().y(), 0.0);
    pose = Pose<AssemblyFrame, AssemblyFrame>(-aside, Mat3::Identity()) * pose;
    return part;
  }
  return Error{"--gear", name,
               fmt::format("is not a part of the drive; its parts are {}", enumerated(names)),
               FailureKind::option};
}

Result<JobFile> make_drive_file(FileKind kind, const DriveJob& job,
                                const std::vector<ToothedBody>& bodies, const fs::path& path,
                                const FileOptions& options) {
  std::size_t planes = job.layout->sections.size();
  if (bodies.size() == 1) planes = bodies.front().gears().size();
  if (planes > 1 && (kind == FileKind::dxf || kind == FileKind::svg))
    return Error{"drive", "",
                 fmt::format("has gears in {} planes, but the outlines in a {} lie in one plane; "
                             "STEP, GLB and 3MF files contain the whole {}",
                             planes, kind == FileKind::dxf ? "DXF file" : "SVG file",
                             bodies.size() == 1 ? "part" : "drive")};
  return make_file(kind, kind == FileKind::threemf ? laid_out(bodies) : bodies, path, options);
}

Result<RunFiles> make_drive_files(const DriveJob& job, const fs::path& folder,
                                  const FileOptions& options) {
  begin_stage(options.progress, "making the files", 0);
  auto shapes = shape_files(job, folder, options);
  if (!shapes) return shapes.error();
  std::vector<JobFile> files = std::move(shapes).take();
  if (options.wants("report")) {
    DriveReportInput report;
    report.title = job.spec.title;
    report.drive = &job.drive;
    report.places = job.places ? &*job.places : nullptr;
    report.layout = job.layout ? &*job.layout : nullptr;
    report.why_no_layout = job.why_no_layout;
    report.verdict = job.verdict;
    report.files = report_files(files);
    report.spec_text = job.spec.text;
    report.units = job.spec.units();
    files.insert(files.begin(), {folder / "report.html", "report", std::nullopt,
                                 "one self-contained page", drive_report_html(report)});
  }
  Json result = titled_record(job.spec, "drive", drive_quantities().of(job.drive));
  result["warnings"] = warnings_json(job.drive.findings);
  result["verdict"] = verdict_json(job.verdict);
  result["files"] = files_json(files);
  if (options.wants("result"))
    files.insert(files.begin(), result_file(folder, job.spec.units(), result));
  return RunFiles{std::move(files), std::move(result), job.verdict};
}

Result<RunFiles> write_drive_files(const DriveJob& job, const fs::path& folder,
                                   const FileOptions& options) {
  auto made = make_drive_files(job, folder, options);
  if (made) write_run_into(folder, made->files, options);
  return made;
}

}  // namespace gearwright
