// Makes the files of a session, with the same bytes as the files of the program.
#include <nlohmann/json.hpp>
#include <optional>

#include "apps/web/engine/answering.hpp"
#include "apps/web/engine/session.hpp"
#include "gearwright/job/drive_job.hpp"
#include "gearwright/job/workshop_drawing.hpp"
#include "gearwright/spec/json.hpp"
#include "gearwright/spec/parse_spec.hpp"

namespace gearwright::web {

namespace {

std::optional<FileKind> kind_of(std::string_view word) {
  for (const FileKind kind : {FileKind::step, FileKind::stl, FileKind::glb, FileKind::threemf,
                              FileKind::dxf, FileKind::svg})
    if (ending(kind).substr(1) == word) return kind;
  return std::nullopt;
}

Result<Json> drive_file(const JobSpec& spec, const std::string& kind) {
  const auto drive = solve_whole_drive(spec, {.contact = Wanted::no});
  if (!drive) return drive.error();
  FileOptions options;
  options.only = {kind};
  auto made = make_drive_files(*drive, "", options);
  if (!made) return made.error();
  if (made->files.empty()) return Error{"", kind, "is not a file of this drive"};
  return row(made->files.front().bytes);
}

}  // namespace

Result<Json> Session::file(const std::string& kind, int gear, double tolerance) {
  // The report and the drawings in inch are made from the spec converted to inch.
  if (job_.spec.units() != units_ && (kind == "report" || kind == "drawing")) {
    const auto tree = parse_spec(text_.text, text_.format);
    if (!tree) return tree.error();
    const auto session = opened(spec_text(toml_text(spec_in(units_, *tree))));
    if (!session) return session.error();
    (*session)->units_ = units_;
    return (*session)->file(kind, gear, tolerance);
  }
  if (job_.spec.drive) return kind == "json" ? row(json("drive")) : drive_file(job_.spec, kind);
  if (kind == "json") return row(json(has_pair() ? "pair" : "gear"));
  FileOptions options;
  if (kind == "report") {
    SolvedJob job = job_;  // a copy, because make_everything() adds warnings about omitted parts to
                           // the job
    options.only = {"report"};
    auto made = make_everything(job, "", options);
    if (!made) return spelled(made.error(), job_.spec.given);
    return row(made->files.front().bytes);
  }
  if (tolerance > 0.0) {
    options.mesh_tolerance_mm = tolerance;
    options.drawing_tolerance_mm = tolerance;
  }
  std::vector<int> chosen;
  for (int which = 1; which <= gears(); ++which)
    if (gear == 0 || gear == which) chosen.push_back(which);
  if (chosen.empty()) return absent_input("gear2", " from the spec");
  if (kind == "drawing") {
    auto made = make_workshop_drawing(job_, chosen, SheetFormat::pdf, "drawing.pdf", options);
    if (!made) return spelled(made.error(), job_.spec.given);
    return row(made->bytes);
  }
  const auto wanted = kind_of(kind);
  if (!wanted) return Error{"", kind, "is not a file format of the engine"};
  std::vector<ToothedBody> bodies;
  for (const int which : chosen) {
    auto made = body(which);
    if (!made) return made.error();
    bodies.push_back(std::move(made).take());
    if (gear == 0) bodies.back().pose = pose_of(job_, which);
  }
  const std::string name = gear == 0 ? "pair" : bodies.front().name;
  auto made = make_file(*wanted, bodies, name + std::string(ending(*wanted)), options);
  if (!made) return spelled(made.error(), job_.spec.given);
  return row(made->bytes);
}

}  // namespace gearwright::web
