#include <algorithm>
#include <nlohmann/json.hpp>

#include "apps/web/engine/session.hpp"
#include "gearwright/cad/mesh.hpp"
#include "gearwright/figure/drive_figures.hpp"
#include "gearwright/job/drive_job.hpp"

namespace gearwright::web {

namespace {

// Chord tolerance relative to the greatest root diameter, and the limits of this tolerance, mm. A
// deviation within the tolerance is not visible.
constexpr double kShare = 1e-4, kFinest = 0.002, kCoarsest = 0.05;

double tolerance_of(const Drive& drive) {
  double greatest = 0.0;
  for (const auto& gear : drive.geometry.gears)
    if (gear) greatest = std::max(greatest, gear->root_diameter);
  return std::clamp(kShare * greatest, kFinest, kCoarsest);
}

Json point(const Vec2& p) { return Json::array({p.x(), p.y()}); }

}  // namespace

Result<Json> Session::drive_solids() const {
  const auto job = solve_drive(job_.spec);
  if (!job) return job.error();
  const auto bodies = drive_bodies(*job);
  if (!bodies) return bodies.error();
  const Drive& drive = job->drive;
  const DriveGraph& graph = drive.graph;
  const double tolerance = tolerance_of(drive);
  const auto ratio = [&](std::size_t body) { return drive.speed_ratio(body).value_or(0.0); };
  Json parts = Json::array(), named = Json::array();
  for (const ToothedBody& body : *bodies) {
    const std::size_t b = *body.colour;
    const auto carrier = graph.bodies[b].carrier;
    // The direction of travel of a rack is −y of its frame (drive/drive_layout.hpp).
    const double travel = ratio(b) * drive.rack_pitch(b).value_or(0.0);
    Json mesh;  // null for a copy
    if (!body.same_as) {
      const auto made = tessellate(body, {.chord_tolerance_mm = tolerance});
      if (!made) return of_body(made.error(), body.name);
      mesh = shape(*made, tolerance);
    }
    parts.push_back({{"name", body.name},
                     {"body", b},
                     {"same", body.same_as ? Json(*body.same_as) : Json()},
                     {"mesh", std::move(mesh)},
                     {"pose", shape(body.pose)},
                     {"turn", drive.rack_pitch(b) ? 0.0 : ratio(b)},
                     {"about", point(job->layout->places.axes[carrier.value_or(b)])},
                     {"carried", carrier ? ratio(*carrier) : 0.0},
                     {"travel", point(-travel * Vec2(body.pose.axis(1).head<2>()))}});
  }
  for (std::size_t b = 0; b < graph.bodies.size(); ++b)
    named.push_back({{"name", graph.bodies[b].name},
                     {"ratio", graph.moves(b) ? 0.0 : ratio(b)},
                     {"rides", graph.bodies[b].carrier.has_value()},
                     {"colour", part_colour(b)}});
  const auto names = [&](const std::vector<std::size_t>& list) {
    Json all = Json::array();
    for (const std::size_t b : list) all.push_back(graph.bodies[b].name);
    return all;
  };
  return Json{{"parts", std::move(parts)},
              {"bodies", std::move(named)},
              {"fixed", names(graph.fixed)},
              {"inputs", names(graph.inputs)},
              {"output", graph.bodies[graph.output].name}};
}

Result<Json> Session::drive_figures(double width) const {
  const auto job = solve_drive(job_.spec);
  if (!job) return job.error();
  Json figures = Json::array();
  if (job->places) figures.push_back(drawn(scheme_figure(job->drive, *job->places, width), width));
  if (auto power = power_figure(job->drive)) figures.push_back(drawn(std::move(*power), width));
  return figures;
}

Result<Json> Session::drive_load_figures(double width) const {
  const auto job = solve_whole_drive(job_.spec, {Wanted::no, Wanted::no});
  if (!job) return job.error();
  Json figures = Json::array();
  for (Figure& figure : gearwright::drive_load_figures(job->drive))
    figures.push_back(drawn(std::move(figure), width));
  return figures;
}

}  // namespace gearwright::web
