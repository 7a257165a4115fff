#include "gearwright/cad/step.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <utility>

#include "gearwright/base/contract.hpp"
#include "gearwright/base/output_file.hpp"
#include "gearwright/base/version.hpp"
#include "gearwright/cad/brep.hpp"
#include "gearwright/cad/part21.hpp"
#include "gearwright/cad/products.hpp"
#include "gearwright/cad/section.hpp"
#include "gearwright/cad/walls.hpp"

namespace gearwright {
namespace {

// The time in the header is constant, so the same gears give the same bytes.
constexpr const char* kTime = "1970-01-01T00:00:00";

// The first edition of ISO 10303-242, and the third edition of ISO 10303-214.
constexpr StepProtocol kAp242{
    "AP242_MANAGED_MODEL_BASED_3D_ENGINEERING_MIM_LF { 1 0 10303 442 1 1 4 }",
    "ap242_managed_model_based_3d_engineering", 2014, "managed model based 3d engineering"};
constexpr StepProtocol kAp214{"AUTOMOTIVE_DESIGN { 1 0 10303 214 3 1 1 }", "automotive_design",
                              2010, "core data for automotive mechanical design processes"};

std::string header(const StepProtocol& protocol, const std::string& file_name) {
  return fmt::format(
      "FILE_DESCRIPTION(('toothed bodies, mm'),'2;1');\n"
      "FILE_NAME({},'{}',('Gearwright'),('Gearwright'),'Gearwright {}','Gearwright','');\n"
      "FILE_SCHEMA(('{}'));\n",
      part21_string(file_name), kTime, kVersion, protocol.schema);
}

std::string without_ending(const std::string& file_name) {
  const std::size_t dot = file_name.rfind('.');
  return dot == std::string::npos || dot == 0 ? file_name : file_name.substr(0, dot);
}

void add_half_tooth(std::vector<StepFace>& faces, const BodyWalls& walls, std::size_t body) {
  for (const ArcFit& arc : walls.arcs) {
    if (!arc.spline) {
      faces.push_back({arc.name, body, 0, 0, 0, 0, 0.0});
      continue;
    }
    const SectionSpline& s = *arc.spline;
    const HelixSpline& helix = walls.helices.front();
    faces.push_back({arc.name, body, s.basis.degree(), s.basis.poles(), helix.basis.degree(),
                     helix.basis.poles(), s.deviation_mm + walls.outer_radius * helix.deviation});
  }
}

Error too_many(std::size_t faces, int slices) {
  return {"faces", fmt::format("{}", faces),
          fmt::format(
              "the STEP solid would have {} faces, but the limit is {}; fewer teeth{} would help",
              faces, kMaxStepFaces, slices > 1 ? ", a narrower face or a longer lead" : "")};
}

// Adds the arcs of half a tooth with modifications to the report. For each arc, the report contains
// the greatest degree, the greatest number of poles and the greatest deviation of all its faces.
void add_modified_half(std::vector<StepFace>& faces, const ModifiedTeeth& teeth,
                       const ModifiedFit& fit, std::size_t body) {
  const auto& arcs = teeth.outline().arcs;
  for (std::size_t arc = 0; arc < arcs.size(); ++arc) {
    StepFace face{arcs[arc].name, body, 0, 0, 0, 0, 0.0};
    for (const std::size_t side : {0U, 1U}) {
      for (std::size_t layer = 0; layer < fit.faces[side].size(); ++layer) {
        const ModifiedFace& part = fit.faces[side][layer][arc];
        if (part.poles.empty()) continue;
        face.degree_u = fit.along_u[side][arc].degree;
        face.degree_v = std::max(face.degree_v, fit.along_v[layer].degree);
        face.poles_u = std::max(face.poles_u, static_cast<int>(part.poles.size()));
        face.poles_v = std::max(face.poles_v, static_cast<int>(part.poles.front().size()));
        face.max_deviation_mm = std::max(face.max_deviation_mm, part.deviation_mm);
      }
    }
    faces.push_back(face);
  }
}

std::size_t modified_face_count(const ModifiedTeeth& teeth, const std::vector<ToothLevel>& levels) {
  const std::size_t layers = levels.size() - 1;
  const std::size_t slices = layers - teeth.kinks_z().size();
  std::size_t tooth = 0;
  for (std::size_t arc = 0; arc < teeth.outline().arcs.size(); ++arc)
    tooth += teeth.side(true).role(arc) == ModifiedSide::Role::land ? slices : 2 * layers;
  return tooth * static_cast<std::size_t>(std::abs(teeth.outline().teeth));
}

// Divides a gear into faces, and adds the faces of half a tooth to the report. `index` is the index
// of the body that contains the gear.
Result<GearFaces> faces_of(const ToothedBody& gear, std::size_t index,
                           std::vector<StepFace>& faces) {
  auto walls = make_walls(gear);
  if (!walls) return walls.error();
  GearFaces made{std::move(walls).take(), {}};
  const WallLoop& teeth = made.walls.teeth;
  if (!gear.modified) {
    const std::size_t n =
        teeth.walls.size() * static_cast<std::size_t>(teeth.slices) * made.walls.helices.size();
    if (n > kMaxStepFaces) return too_many(n, teeth.slices);
    add_half_tooth(faces, made.walls, index);
    return made;
  }
  const std::vector<Band> bands = gear.bands();
  const auto levels = tooth_levels(*gear.modified, teeth.slices, bands.back().width);
  const std::size_t n = bands.size() * modified_face_count(*gear.modified, levels);
  if (n > kMaxStepFaces) return too_many(n, teeth.slices);
  auto fit = fit_modified(*gear.modified, levels);
  if (!fit) return fit.error();
  made.fit = std::move(fit).take();
  add_modified_half(faces, *gear.modified, *made.fit, index);
  return made;
}

Result<Brep> add_solid(Part21& file, const ToothedBody& body, std::size_t index,
                       std::vector<StepFace>& faces) {
  if (body.rack) {
    if (const std::size_t n = rack_face_count(body); n > kMaxStepFaces) return too_many(n, 1);
    for (const Arc& arc : body.outline.arcs) faces.push_back({arc.name, index, 0, 0, 0, 0, 0.0});
    return add_rack_brep(file, body);
  }
  std::vector<GearFaces> gears;
  for (const SolidGear& gear : body.gears()) {
    auto made = faces_of(*gear.body, index, faces);
    if (!made) return made.error();
    gears.push_back(std::move(made).take());
  }
  return add_brep(file, body, gears);
}

}  // namespace

const char* to_string(StepSchema schema) { return schema == StepSchema::ap242 ? "AP242" : "AP214"; }

Result<StepDocument> step_document(const std::vector<ToothedBody>& bodies,
                                   const std::string& file_name, const StepOptions& options) {
  GW_EXPECTS(!bodies.empty());
  const StepProtocol& protocol = options.schema == StepSchema::ap242 ? kAp242 : kAp214;
  StepReport report;
  Part21 file(header(protocol, file_name));
  std::vector<Part21Id> solids;
  std::vector<double> volumes;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const ToothedBody& body = bodies[i];
    volumes.push_back(body.same_as ? volumes[*body.same_as] : metal_volume(body));
    for (const SolidGear& gear : body.gears())
      if (gear.body->modified && !body.same_as) {
        const std::vector<Band> bands = gear.bands();  // all have the same width
        volumes.back() -= static_cast<double>(bands.size()) *
                          gear.body->modified->removed_volume(bands.front().width);
      }
    report.volume_mm3 += volumes.back();
    if (body.same_as) {
      solids.push_back(solids[*body.same_as]);
      continue;
    }
    const auto brep = add_solid(file, body, i, report.faces);
    if (!brep) return within(body.name, brep.error());
    report.face_count += brep->face_count;
    report.edge_count += brep->edge_count;
    solids.push_back(brep->solid);
  }
  for (const StepFace& face : report.faces)
    report.max_deviation_mm = std::max(report.max_deviation_mm, face.max_deviation_mm);
  add_products(file, protocol, bodies, solids, without_ending(file_name));
  return StepDocument{std::move(file).finish(), std::move(report)};
}

Result<StepReport> write_step(const std::vector<ToothedBody>& bodies,
                              const std::filesystem::path& path, const StepOptions& options) {
  auto document = step_document(bodies, path.filename().string(), options);
  if (!document) return document.error();
  write_file(path, document->text);
  return document->report;
}

}  // namespace gearwright
