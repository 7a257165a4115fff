// Defines the methods that return teeth as points and triangles, and the methods that write files
// of gears.
#include <fmt/format.h>
#include <pybind11/eigen.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <cmath>

#include "apps/python/arrays.hpp"
#include "apps/python/model.hpp"
#include "apps/python/watched.hpp"
#include "gearwright/base/output_file.hpp"
#include "gearwright/cad/contour.hpp"
#include "gearwright/cad/mesh.hpp"
#include "gearwright/job/files.hpp"
#include "gearwright/job/workshop_drawing.hpp"

namespace gearwright::python {

namespace {

namespace fs = std::filesystem;

constexpr int kMostPoints = 100'000;            // greatest number of points per arc
constexpr std::size_t kMostOfAll = 20'000'000;  // greatest number of points per section

int points_in_range(int points) {
  if (points < 2 || points > kMostPoints)
    raise(refused("points", points, fmt::format("must lie between 2 and {}", kMostPoints)));
  return points;
}

double tolerance_in_range(double tolerance, const ToleranceRange& range) {
  if (!(tolerance >= range.least && tolerance <= range.greatest))
    raise(refused("tolerance", tolerance,
                  fmt::format("must lie between {} and {} mm", range.least, range.greatest)));
  return tolerance;
}

// Raises the error. If there is only one gear, the keys in the error do not begin with "gear1".
[[noreturn]] void raise_of_body(const Error& error, const Model& model) {
  if (!model.job.mounted()) raise_of_gear(spelled(error, model.given()));
  raise(error, model);
}

ToothedBody body_of(const Model& model, int which) {
  auto body = make_body(model.job, which);
  if (!body) raise_of_body(body.error(), model);
  return std::move(body).take();
}

ToothedBody body_of(const GearValue& gear) { return body_of(*gear.model, gear.which); }

py::array_t<double> rows_of(std::vector<Vec2> points) {
  const auto owner = std::make_shared<std::vector<Vec2>>(std::move(points));
  static_assert(sizeof(Vec2) == 2 * sizeof(double));
  return array_of<double>(owner, owner->data()->data(),
                          {static_cast<py::ssize_t>(owner->size()), 2});
}

py::dict outline(const GearValue& gear, int points) {
  points_in_range(points);
  const ToothedBody body = body_of(gear);
  std::vector<std::pair<ArcName, std::vector<Vec2>>> arcs;
  for (const Arc& arc : body.outline.arcs) {
    auto more = sample(arc, points);
    if (arcs.empty() || arcs.back().first != arc.name) {
      arcs.emplace_back(arc.name, std::move(more));
    } else {  // consecutive arcs with the same name; their common point is listed once
      arcs.back().second.insert(arcs.back().second.end(), more.begin() + 1, more.end());
    }
  }
  py::dict all;
  for (const auto& [name, list] : arcs) all[py::str(std::string(to_string(name)))] = rows_of(list);
  return all;
}

// Returns the points on the circle of a land, from the start to the end of the piece.
std::vector<Vec2> land_points(const ContourPiece& piece, int points) {
  std::vector<Vec2> all;
  const Vec2 across(-piece.begin.y(), piece.begin.x());
  for (int i = 0; i + 1 < points; ++i) {
    const double turn = piece.sweep * i / (points - 1);
    all.emplace_back(std::cos(turn) * piece.begin + std::sin(turn) * across);
  }
  all.push_back(piece.end);
  return all;
}

py::array_t<double> section(const GearValue& gear, int points) {
  points_in_range(points);
  const ToothedBody body = body_of(gear);
  auto made = closed_contour(body.outline);
  if (!made) raise(made.error(), *gear.model);
  const Contour contour = std::move(made).take();
  if (contour.pieces.size() * static_cast<std::size_t>(points) > kMostOfAll)
    raise(refused(
        "points", points,
        fmt::format("must be at most {}, because the section has {} arcs and may have at most {} "
                    "points in total",
                    kMostOfAll / contour.pieces.size(), contour.pieces.size(), kMostOfAll)));
  std::vector<std::vector<Vec2>> sampled;
  for (const Arc& arc : body.outline.arcs) sampled.push_back(sample(arc, points));
  std::vector<Vec2> all;
  for (const ContourPiece& piece : contour.pieces) {
    const auto part =
        piece.land ? land_points(piece, points) : placed(contour, piece, sampled[piece.arc]);
    all.insert(all.end(), part.begin(),
               part.end() - 1);  // the next piece starts at this point
  }
  if (!all.empty()) all.push_back(all.front());
  return rows_of(all);
}

py::tuple mesh(const GearValue& gear, double tolerance) {
  tolerance_in_range(tolerance, kMeshTolerances);
  const ToothedBody body = body_of(gear);
  const auto owner =
      std::make_shared<TriangleMesh>(watched_result(gear.model->given(), [&](Progress*) {
        return tessellate(body, {.chord_tolerance_mm = tolerance});
      }));
  static_assert(sizeof(Vec3) == 3 * sizeof(double) &&
                sizeof(Triangle) == 3 * sizeof(std::uint32_t));
  const auto n = static_cast<py::ssize_t>(owner->vertices.size());
  const auto m = static_cast<py::ssize_t>(owner->triangles.size());
  return py::make_tuple(array_of<double>(owner, owner->vertices.data()->data(), {n, 3}),
                        array_of<std::uint32_t>(owner, owner->triangles.data()->data(), {m, 3}));
}

// Writes the file and returns its path. If no path is given, returns the bytes of the file.
py::object bytes_or_file(const JobFile& file, const std::optional<fs::path>& path) {
  if (!path) return py::bytes(file.bytes);
  write_file(*path, file.bytes);
  return py::cast(*path);
}

// Makes one file with these gears. If there are two gears, they are in their mounted positions.
py::object exported(FileKind kind, const std::vector<int>& gears, const Model& model,
                    const std::optional<fs::path>& path, std::optional<double> tolerance,
                    bool splines) {
  FileOptions options;
  const bool drawn = kind == FileKind::dxf;
  if (tolerance && (kind == FileKind::step || kind == FileKind::svg))
    raise(refused("tolerance", *tolerance,
                  "has no effect on STEP and SVG files; leave out this argument, or write STL, "
                  "3MF, GLB or DXF"));
  if (splines && !drawn)
    raise({"splines", "True",
           "has an effect on DXF files only; leave out this argument, or write DXF"});
  if (tolerance)
    (drawn ? options.drawing_tolerance_mm : options.mesh_tolerance_mm) =
        tolerance_in_range(*tolerance, drawn ? kDrawingTolerances : kMeshTolerances);
  options.drawing_splines = splines;
  const fs::path name = path.value_or(model.spec.contains("gear2") ? "pair" : "gear");
  std::vector<ToothedBody> bodies;
  for (const int which : gears) {
    bodies.push_back(body_of(model, which));
    if (gears.size() == 2) bodies.back().pose = pose_of(model.job, which);
  }
  return bytes_or_file(
      watched_result(model.given(),
                     [&](Progress*) { return make_file(kind, bodies, name, options); }),
      path);
}

// Makes the workshop drawing, with a sheet for each gear or rack. If a path is given, its extension
// determines the format, which `format` must not contradict.
py::object drawing(const std::vector<int>& gears, const Model& model,
                   const std::optional<fs::path>& path, const std::optional<std::string>& format,
                   const std::optional<std::string>& sheet, double tolerance) {
  const auto wanted = sheet_format("drawing." + format.value_or("pdf"));
  if (!wanted) raise({"format", *format, "must be pdf, svg or dxf"});
  const auto kind = path ? sheet_format(*path) : wanted;
  if (!kind) raise({"path", path->string(), "must end in .pdf, .svg or .dxf"});
  if (format && kind != wanted)
    raise({"format", *format, "contradicts the ending of the path; leave out this argument"});
  if (sheet && *sheet != "A4" && *sheet != "A3") raise({"sheet", *sheet, "must be A4 or A3"});
  FileOptions options;
  options.drawing_tolerance_mm = tolerance_in_range(tolerance, kDrawingTolerances);
  if (sheet) options.sheet = *sheet == "A3" ? SheetSize::a3 : SheetSize::a4;
  const fs::path name = path.value_or("drawing");
  std::optional<Result<JobFile>> file;
  {
    const py::gil_scoped_release free;
    file = make_workshop_drawing(model.job, gears, *kind, name, options);
  }
  if (!*file) raise_of_body(file->error(), model);
  return bytes_or_file(file->value(), path);
}

struct Export {
  const char* name;
  FileKind kind;
  std::optional<double> tolerance;  // mm, the default; none if the file has no tolerance
  const char* doc;
};
constexpr Export kExports[] = {
    {"step", FileKind::step, {}, "STEP AP242 solid"},
    {"stl", FileKind::stl, 0.005, "Binary STL mesh, within tolerance of the exact surface"},
    {"threemf", FileKind::threemf, 0.005, "3MF mesh, within tolerance of the exact surface"},
    {"glb", FileKind::glb, 0.005, "GLB mesh, within tolerance of the exact surface"},
    {"dxf", FileKind::dxf, 0.001,
     "DXF of the section as arcs within tolerance of the exact outline, or as splines if "
     "splines=True"},
    {"svg", FileKind::svg, {}, "SVG of the section"}};

template <class Class>
void bind_exports(Class& type) {
  using Self = typename Class::type;
  for (const Export& e : kExports) {
    type.def(
        e.name,
        [kind = e.kind](const Self& self, const py::object& path, std::optional<double> tolerance,
                        bool splines) {
          return exported(kind, self.gears(), *self.model, path_or_none(path, "path"), tolerance,
                          splines);
        },
        py::arg("path") = py::none(), py::arg("tolerance") = e.tolerance,
        py::arg("splines") = false,
        fmt::format("{}. Returns the bytes of the file. If path is given, writes the file instead, "
                    "completely or not at all. Lengths are in mm",
                    e.doc)
            .c_str());
  }
  type.def(
      "drawing",
      [](const Self& self, const py::object& path, const std::optional<std::string>& format,
         const std::optional<std::string>& sheet, double tolerance) {
        return drawing(self.gears(), *self.model, path_or_none(path, "path"), format, sheet,
                       tolerance);
      },
      py::arg("path") = py::none(), py::arg("format") = py::none(), py::arg("sheet") = py::none(),
      py::arg("tolerance") = 0.001,
      "Workshop drawing with the gear data, one sheet for each gear or rack: the given sheet "
      "(\"A4\" "
      "or \"A3\"), by default A4, or A3 if the scale on A4 would be smaller than 1:2. Returns the "
      "bytes of the file in the given format (pdf, svg or dxf; by default pdf), or writes the file "
      "to path, "
      "whose ending determines the format. The drawn outline is within tolerance (mm) of the exact "
      "outline");
}

Eigen::Matrix4d pose(const PairValue& pair, int which) {
  if (which != 1 && which != 2)
    raise(refused("which", which, "must be 1 or 2, the number of the gear"));
  return pose_of(pair.model->job, which).isometry().matrix();
}

}  // namespace

void bind_files(py::class_<GearValue>& gear, py::class_<PairValue>& pair) {
  gear.def("outline", &outline, py::arg("points") = 200,
           "Returns half a tooth in the section z = 0, from root to tip, as a dict that contains, "
           "for the name of each arc, an array (points, 2) in mm. The centre line of the tooth is "
           "the x axis, "
           "and the half lies at y > 0")
      .def("section", &section, py::arg("points") = 20,
           "Returns the closed outline of all teeth in the section z = 0 as an array (n, 2) in mm, "
           "counter-clockwise; points is the number of points per arc")
      .def("mesh", &mesh, py::arg("tolerance") = 0.005,
           "Returns the closed body as a tuple of vertices (n, 3) in mm and triangles (m, 3), "
           "within tolerance of the exact surface");
  bind_exports(gear);
  bind_exports(pair);
  pair.def("pose", &pose, py::arg("which"),
           "Returns the 4×4 matrix that transforms from the frame of gear 1 or 2 to the frame of "
           "the housing. The files of a gear are in the frame of this gear");
}

}  // namespace gearwright::python
