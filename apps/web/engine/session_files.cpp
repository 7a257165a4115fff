// The files of a session: the bytes that the program would write.
#include <algorithm>
#include <array>
#include <optional>

#include "apps/web/engine/session.hpp"

namespace gearwright::web {

namespace {

std::optional<FileKind> kind_of(std::string_view word) {
  for (const FileKind kind : {FileKind::step, FileKind::stl, FileKind::glb, FileKind::threemf,
                              FileKind::dxf, FileKind::svg})
    if (ending(kind).substr(1) == word) return kind;
  return std::nullopt;
}

}  // namespace

Result<std::string> Session::file(std::string_view kind, int gear, double tolerance) {
  if (kind == "json") return json(job_.pair ? "pair" : "gear");
  FileOptions options;
  if (kind == "report") {
    SolvedJob job = job_;  // what is left out becomes a warning of the job
    options.only = {"report"};
    auto made = make_everything(job, "", options);
    if (!made) return spelled(made.error(), job_.spec.given);
    return made->files.front().bytes;
  }
  const auto wanted = kind_of(kind);
  if (!wanted) return Error{"", std::string(kind), "is no kind of file that the engine makes"};
  std::vector<ToothedBody> bodies;
  for (int which = 1; which <= gears(); ++which) {
    if (gear != 0 && gear != which) continue;
    auto made = body(which, gear == 0);
    if (!made) return made.error();
    bodies.push_back(std::move(made).take());
  }
  if (bodies.empty()) return Error{"gear2", "", "is missing from the spec"};
  if (tolerance > 0.0) {
    options.mesh_tolerance_mm = tolerance;
    options.drawing_tolerance_mm = tolerance;
  }
  const std::string name = gear == 0 ? "pair" : bodies.front().name;
  auto made = make_file(*wanted, bodies, name + std::string(ending(*wanted)), options);
  if (!made) return spelled(made.error(), job_.spec.given);
  return made->bytes;
}

}  // namespace gearwright::web
