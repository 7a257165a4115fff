#include "gearwright/drive/drive_graph.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "gearwright/base/number_text.hpp"
#include "gearwright/base/subject.hpp"

namespace gearwright {

namespace {

bool holds(const std::vector<std::size_t>& list, std::size_t body) {
  return std::find(list.begin(), list.end(), body) != list.end();
}

std::optional<Error> check_body(const DriveGraph& graph, std::size_t index) {
  const DriveBody& body = graph.bodies[index];
  const auto wrong_count = [&](const std::string& rule) {
    return refused(fmt::format("drive.body[{}].count", index + 1), body.count, rule);
  };
  if (body.count < 1)
    return wrong_count(fmt::format("body {} must have at least one copy", body.name));
  if (body.count > 1 && !body.carrier)
    return wrong_count(
        fmt::format("body {} has copies but no carrier; only a planet can have copies", body.name));
  if (!body.carrier) return std::nullopt;
  if (*body.carrier == index)
    return Error{"drive.body", body.name,
                 "a body cannot be its own carrier; give another body as its carrier"};
  if (graph.bodies[*body.carrier].carrier)
    return Error{"drive.body", body.name,
                 fmt::format("the carrier {} of this planet is mounted on another body, but the "
                             "carrier of a planet must turn about a fixed axis",
                             graph.bodies[*body.carrier].name)};
  return std::nullopt;
}

// Returns an error if a body has a side, but no earlier planet to which the side refers.
std::optional<Error> check_side(const DriveGraph& graph, std::size_t index) {
  const DriveBody& body = graph.bodies[index];
  if (body.side == IdlerSide::counter_clockwise) return std::nullopt;
  for (const DriveMesh& mesh : graph.meshes) {
    const std::size_t a = graph.gear(mesh, 0).body, b = graph.gear(mesh, 1).body;
    if (std::max(a, b) == index && graph.bodies[std::min(a, b)].carrier) return std::nullopt;
  }
  return Error{
      "drive.body", body.name,
      "has idler_side = \"clockwise\", but it does not mesh with a planet that is listed before "
      "it; list the planet before this body"};
}

std::optional<Error> check_mesh(const DriveGraph& graph, const DriveMesh& mesh) {
  const DriveGear& a = graph.gear(mesh, 0);
  const DriveGear& b = graph.gear(mesh, 1);
  const auto wrong = [&](std::string rule) { return Error{"drive.mesh", mesh.name, rule}; };
  if (a.body == b.body)
    return wrong(fmt::format("both gears are on body {}, but a mesh needs gears on two bodies",
                             graph.body(a).name));
  if (a.factor() < 0 && b.factor() < 0)
    return wrong(
        "neither gear is external, but a ring or a rack can mesh only with an external gear");
  if (a.rack) return wrong("names the rack first; the pinion must come first");
  if (a.teeth + b.teeth == 0 && !b.rack)
    return wrong(
        fmt::format("ring and gear have the same number of teeth, {}, and cannot turn relative to "
                    "each other; give the ring more teeth",
                    std::abs(a.teeth)));
  if (const int sum = a.teeth + b.teeth; !b.rack && (a.is_ring() || b.is_ring()) && sum > 0)
    return wrong(fmt::format(
        "the ring has fewer teeth than the gear inside it ({} and {}); give the ring more teeth",
        -std::min(a.teeth, b.teeth), std::max(a.teeth, b.teeth)));
  const auto& carrier_a = graph.body(a).carrier;
  const auto& carrier_b = graph.body(b).carrier;
  if (carrier_a && carrier_b && carrier_a != carrier_b)
    return wrong(fmt::format(
        "the planets of this mesh are on two carriers, {} and {}, but planets that mesh with each "
        "other must be on one carrier",
        graph.bodies[*carrier_a].name, graph.bodies[*carrier_b].name));
  if (carrier_a && carrier_b && graph.body(a).count != graph.body(b).count)
    return wrong(
        "the planets of this mesh have different numbers of copies, but planets that mesh with "
        "each other must have the same number");
  if (b.rack && carrier_a)
    return wrong(
        "the pinion of this mesh is on a carrier, but a rack can mesh only with a gear on a fixed "
        "axis");
  if (b.rack && a.double_helical)
    return wrong(
        "the pinion of this mesh is double-helical, but a rack can mesh only with a spur or "
        "helical pinion");
  if ((a.double_helical || b.double_helical) && a.spec && b.spec) {
    const auto error =
        mates_error({a.double_helical, b.double_helical}, {a.spec->face_width, b.spec->face_width});
    if (error) {
      const bool first = subject_of(error->field).gear == 1;
      Error own = *error;
      own.field.erase(0, own.field.find('.') + 1);
      return of_drive_gear(first ? a : b, std::move(own));
    }
  }
  if (mesh.efficiency && !(*mesh.efficiency > 0.0 && *mesh.efficiency <= 1.0))
    return refused(
        "drive.mesh", *mesh.efficiency,
        fmt::format("the efficiency of {} must be greater than 0 and at most 1", mesh.name));
  return std::nullopt;
}

}  // namespace

std::optional<std::size_t> DriveGraph::frame(const DriveMesh& mesh) const {
  const auto& first = body(gear(mesh, 0)).carrier;
  return first ? first : body(gear(mesh, 1)).carrier;
}

int DriveGraph::copies(const DriveMesh& mesh) const {
  return std::max(body(gear(mesh, 0)).count, body(gear(mesh, 1)).count);
}

bool DriveGraph::is_fixed(std::size_t body) const { return holds(fixed, body); }
bool DriveGraph::is_input(std::size_t body) const { return holds(inputs, body); }

bool DriveGraph::moves(std::size_t body) const {
  return std::any_of(gears.begin(), gears.end(),
                     [body](const DriveGear& gear) { return gear.rack && gear.body == body; });
}

Error of_drive_gear(const DriveGear& gear, Error error) {
  return within(fmt::format("drive.gear[\"{}\"]", gear.name), std::move(error));
}

std::optional<Error> check_speeds(const std::vector<double>& speeds_rpm, std::size_t inputs) {
  if (speeds_rpm.empty() || speeds_rpm.size() == inputs) return std::nullopt;
  std::vector<std::string> texts;
  for (const double rpm : speeds_rpm) texts.push_back(format_number(rpm));
  return Error{
      "drive.speed", fmt::format("[{}]", fmt::join(texts, ", ")),
      fmt::format("has {} number{} for {} input{}; give one speed for each input", texts.size(),
                  texts.size() == 1 ? "" : "s", inputs, inputs == 1 ? "" : "s")};
}

std::optional<Error> check_graph(const DriveGraph& graph) {
  if (graph.bodies.empty() || graph.meshes.empty())
    return absent_input("drive.mesh",
                        "; a drive needs bodies, gears on the bodies and meshes of the gears");
  for (std::size_t i = 0; i < graph.bodies.size(); ++i)
    if (auto error = check_body(graph, i)) return error;
  for (const DriveGear& gear : graph.gears) {
    if (!gear.rack && gear.teeth == 0)
      return Error{"drive.gear", gear.name,
                   "has 0 teeth; give a positive number of teeth, or a negative number for a ring"};
    if (gear.rack && graph.body(gear).carrier)
      return Error{"drive.gear", gear.name,
                   "is a rack on a planet, but the body of a rack must not have a carrier"};
    if (!gear.double_helical || !gear.spec) continue;
    if (const double stagger = gear.double_helical->stagger_pitches; stagger != 0.0)
      return of_drive_gear(
          gear, refused("double_helical.stagger_pitches", stagger,
                        "must be 0, because staggered halves are not supported in a drive"));
    if (auto error = half_error(*gear.double_helical, gear.spec->face_width))
      return of_drive_gear(gear, std::move(*error));
  }
  for (const DriveMesh& mesh : graph.meshes)
    if (auto error = check_mesh(graph, mesh)) return error;
  for (std::size_t i = 0; i < graph.bodies.size(); ++i)
    if (auto error = check_side(graph, i)) return error;
  if (auto error = check_speeds(graph.speeds_rpm, graph.inputs.size())) return error;
  if (graph.inputs.size() == 1 && graph.speeds_rpm.size() == 1 &&
      graph.torque_Nm.value_or(0.0) * graph.speeds_rpm.front() < 0.0)
    return Error{"drive.torque", format_number(*graph.torque_Nm),
                 fmt::format("must have the sign of the speed ({} rpm), because a single input "
                             "drives; if the other end drives, give that body as the input",
                             format_number(graph.speeds_rpm.front()))};
  return std::nullopt;
}

std::vector<PlanetGroup> planet_groups(const DriveGraph& graph) {
  // Planets that mesh with each other form a group. The number of a group is the index of its first
  // body.
  std::vector<std::size_t> group(graph.bodies.size());
  for (std::size_t i = 0; i < group.size(); ++i) group[i] = i;
  for (const DriveMesh& mesh : graph.meshes) {
    const std::size_t a = graph.gear(mesh, 0).body;
    const std::size_t b = graph.gear(mesh, 1).body;
    if (!graph.bodies[a].carrier || !graph.bodies[b].carrier) continue;
    const auto [low, high] = std::minmax(group[a], group[b]);
    std::replace(group.begin(), group.end(), std::size_t(high), std::size_t(low));
  }
  std::vector<PlanetGroup> groups;
  for (std::size_t i = 0; i < group.size(); ++i) {
    const DriveBody& body = graph.bodies[i];
    if (!body.carrier || group[i] != i) continue;
    PlanetGroup made{*body.carrier, {}, {}, body.count};
    for (std::size_t j = i; j < group.size(); ++j)
      if (group[j] == i) made.riders.push_back(j);
    for (std::size_t m = 0; m < graph.meshes.size(); ++m) {
      const DriveMesh& mesh = graph.meshes[m];
      if (holds(made.riders, graph.gear(mesh, 0).body) ||
          holds(made.riders, graph.gear(mesh, 1).body))
        made.meshes.push_back(m);
    }
    groups.push_back(std::move(made));
  }
  return groups;
}

}  // namespace gearwright
