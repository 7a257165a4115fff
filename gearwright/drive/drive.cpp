#include "gearwright/drive/drive.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "gearwright/base/lists.hpp"
#include "gearwright/base/units.hpp"
#include "gearwright/drive/drive_error.hpp"
#include "gearwright/drive/drive_places.hpp"
#include "gearwright/drive/geometry_remedy.hpp"

namespace gearwright {

namespace {

// Orders the gears of each mesh so that a ring or a rack is the second gear, as in a pair. The
// equation of a mesh does not depend on this order.
DriveGraph normalised(DriveGraph graph) {
  for (DriveMesh& mesh : graph.meshes)
    if (graph.gear(mesh, 0).factor() < 0) {
      std::swap(mesh.gears[0], mesh.gears[1]);
      if (mesh.direction) mesh.direction = Angle::radians(mesh.direction->rad() + std::numbers::pi);
    }
  return graph;
}

std::vector<std::optional<MeshEfficiency>> mesh_efficiencies(const DriveGraph& graph,
                                                             const DriveGeometry& geometry) {
  std::vector<std::optional<MeshEfficiency>> list;
  for (std::size_t m = 0; m < graph.meshes.size(); ++m) {
    list.emplace_back();
    if (const auto given = graph.meshes[m].efficiency) {
      list.back() = MeshEfficiency{*given, *given};
      continue;
    }
    const ParallelPair* pair = geometry.involutes(m);
    const auto& rack = geometry.racks[m];
    const auto eta = rack ? rack->efficiency : pair ? pair->efficiency : std::nullopt;
    if (eta && eta->gear1_drives && eta->gear2_drives)
      list.back() = MeshEfficiency{*eta->gear1_drives, *eta->gear2_drives};
    // Without friction, no teeth have losses, so the teeth need not be known.
    const bool known_teeth = graph.gear(graph.meshes[m], 0).spec.has_value();
    if (!known_teeth && graph.meshes[m].friction.value_or(graph.friction) == 0.0)
      list.back() = MeshEfficiency{1.0, 1.0};
  }
  return list;
}

// Returns the speeds of all bodies for the torque 1 on the first input. A single input has the
// speed 1. Several inputs have the speeds that the user gives. If the torque on the first input is
// negative, all speeds have the opposite sign, because friction depends on the direction of the
// power. Without a given torque, the first input delivers power. Returns none if the speeds of
// several inputs are not given.
std::optional<std::vector<double>> speeds_of(const Drive& drive) {
  const DriveGraph& graph = drive.graph;
  std::vector<double> inputs = graph.inputs.size() == 1 ? std::vector{1.0} : graph.speeds_rpm;
  if (inputs.size() != graph.inputs.size()) return std::nullopt;
  if (inputs.size() > 1 && graph.torque_Nm.value_or(inputs.front()) < 0.0)
    for (double& speed : inputs) speed = -speed;
  std::vector<double> speeds;
  for (std::size_t b = 0; b < graph.bodies.size(); ++b)
    speeds.push_back(drive.motion.speed(b, inputs));
  return speeds;
}

std::optional<Error> find_flows(Drive& drive) {
  std::vector<MeshEfficiency> known;
  for (const auto& eta : drive.efficiencies) {
    if (!eta) return std::nullopt;
    known.push_back(*eta);
  }
  const auto speeds = speeds_of(drive);
  if (!speeds || !drive.motion.redundant.empty()) return std::nullopt;
  auto flow = power_flow(drive.graph, *speeds, known);
  if (!flow) return flow.error();
  drive.flow = std::move(flow).take();
  if (drive.graph.inputs.size() != 1) return std::nullopt;
  DriveGraph turned = drive.graph;
  std::swap(turned.inputs.front(), turned.output);
  std::vector<double> backward = *speeds;
  const double w_out = (*speeds)[drive.graph.output];
  for (double& w : backward) w /= w_out;
  auto back = power_flow(turned, backward, known);
  if (!back) return back.error();
  drive.backward = std::move(back).take();
  return std::nullopt;
}

struct CentralMesh {
  std::size_t mesh;
  const DriveGear *central, *rider;
};

std::optional<CentralMesh> first_central(const DriveGraph& graph, const PlanetGroup& group,
                                         bool ring) {
  for (const std::size_t m : group.meshes) {
    const DriveGear& a = graph.gear(graph.meshes[m], 0);
    const DriveGear& b = graph.gear(graph.meshes[m], 1);
    const bool a_rides = graph.body(a).carrier == group.carrier;
    const bool b_rides = graph.body(b).carrier == group.carrier;
    if (a_rides == b_rides) continue;
    const DriveGear& central = a_rides ? b : a;
    if (central.is_ring() == ring) return CentralMesh{m, &central, a_rides ? &a : &b};
  }
  return std::nullopt;
}

std::optional<double> phase_between(const Drive& drive, const CentralMesh& sun,
                                    const CentralMesh& ring) {
  const ParallelPair* one = drive.geometry.involutes(sun.mesh);
  const ParallelPair* two = drive.geometry.involutes(ring.mesh);
  if (sun.rider != ring.rider || !one || !two) return std::nullopt;
  const DriveMesh& mesh = drive.graph.meshes[sun.mesh];
  const int which = &drive.graph.gear(mesh, 0) == sun.rider ? 1 : 2;
  // If the power flow is unknown and the sun is not the output, the sun is assumed to drive.
  bool sun_drives = drive.graph.output != sun.central->body;
  if (drive.flow && !drive.flow->self_locking() && drive.flow->driver[sun.mesh] >= 0)
    sun_drives = drive.flow->driver[sun.mesh] == 2 - which;
  return sun_ring_phase(sun.rider->teeth, thickness_share(*one, which), thickness_share(*two, 1),
                        sun_drives);
}

Result<PlanetSet> planet_set(Drive& drive, const PlanetGroup& group, int harmonics) {
  PlanetSet set{group, {}, {}, {}, {}, {}, {}};
  auto assembly = assemble(drive.graph, group, &drive.geometry);
  if (!assembly) return assembly.error();
  set.assembly = std::move(assembly).take();
  const std::vector<Rational>& turns = set.assembly.turns;
  const auto sun = first_central(drive.graph, group, false);
  const auto ring = first_central(drive.graph, group, true);
  if (sun) set.sun_phases = mesh_phases(sun->central->teeth, turns);
  if (ring) set.ring_phases = mesh_phases(ring->central->teeth, turns);
  if (sun && ring) set.sun_ring_phase = phase_between(drive, *sun, *ring);
  const std::vector<Rational>& phases = sun ? set.sun_phases : set.ring_phases;
  if (!phases.empty()) set.phasing = phasing(phases, turns, harmonics);
  std::optional<GeometryFault> fault;
  if (group.count > 1)
    set.neighbours = neighbours(drive.graph, group, drive.geometry, set.assembly, fault);
  if (fault) drive.geometry.faults.push_back(*fault);
  return set;
}

std::optional<DriveBacklash> backlash_of_drive(const Drive& drive) {
  const std::size_t input = drive.graph.inputs.front(), output = drive.graph.output;
  const auto in = drive.play(input, output), out = drive.play(output, input);
  if (!in || !out) return std::nullopt;
  return DriveBacklash{*in, *out, drive.lever(input), drive.lever(output)};
}

std::string names_of(const DriveGraph& graph, const std::vector<std::size_t>& meshes) {
  std::string list;
  for (const std::size_t m : meshes) list += (list.empty() ? "" : ", ") + graph.meshes[m].name;
  return list;
}

// In a drive with several inputs, the torque of the first input determines all other torques. As a
// result, the torque of another input may oppose its rotation.
void report_power_against_inputs(Drive& drive) {
  const DriveGraph& graph = drive.graph;
  const auto speeds = speeds_of(drive);
  if (graph.inputs.size() < 2 || !drive.flow || drive.flow->self_locking() || !speeds) return;
  const auto power = [&](std::size_t body) {
    return drive.flow->torque[body] * (*speeds)[body] / drive.flow->power_in;
  };
  const double out = power(graph.output);
  for (const std::size_t input : graph.inputs)
    if (power(input) < 0.0)
      drive.findings.push_back(
          {WarningCode::power_against_input,
           fmt::format(
               "The input {} absorbs {:.2f} % of the power that flows in, because its torque "
               "and its speed have opposite signs.{}",
               graph.bodies[input].name, -100 * power(input),
               out > 0.0 ? fmt::format(" The output {} delivers power to the drive.",
                                       graph.bodies[graph.output].name)
                         : ""),
           0});
}

void find_facts(Drive& drive) {
  const auto say = [&](WarningCode code, std::string message) {
    drive.findings.push_back({code, std::move(message), 0});
  };
  for (const GeometryFault& fault : drive.geometry.faults)
    say(WarningCode::not_coaxial, fault.message);
  for (const DriveMesh& mesh : drive.graph.meshes)
    for (const std::size_t g : mesh.gears) {
      const DriveGear& gear = drive.graph.gears[g];
      if (mesh.backlash && gear.spec &&
          gear.spec->thickness_allowance > no_backlash(gear.spec->normal_module))
        say(WarningCode::thickened_for_backlash,
            fmt::format("For a backlash of {:g} mm in the mesh {}, the teeth of {} must be {:.4f} "
                        "mm thicker than their profile shift requires.",
                        *mesh.backlash, mesh.name, gear.name, gear.spec->thickness_allowance));
    }
  for (const PlanetSet& set : drive.sets) {
    const std::string planet = drive.graph.bodies[set.group.riders.front()].name;
    // Copies that cannot be assembled have no positions at which neighbours could be compared.
    const bool too_many = set.assembly.places > 0 && set.group.count > set.assembly.places;
    if (set.neighbours && set.neighbours->clearance < 0.0 && !too_many)
      say(WarningCode::planets_collide,
          fmt::format("Neighbouring copies of {} overlap by {:.4f} mm. At most {} copies fit at "
                      "equal pitch.",
                      planet, -set.neighbours->clearance, set.neighbours->most));
    if (set.assembly.places > 0 && set.group.count > set.assembly.places) {
      say(WarningCode::planets_collide,
          fmt::format("{} copies of {} cannot be assembled, because their teeth mesh at only {} "
                      "per revolution.",
                      set.group.count, planet,
                      set.assembly.places == 1 ? std::string("one position")
                                               : fmt::format("{} positions", set.assembly.places)));
      continue;
    }
    if (set.assembly.equal || set.group.count == 1) continue;
    const auto& riders = set.group.riders;
    const bool given = std::any_of(riders.begin(), riders.end(), [&](std::size_t body) {
      return !drive.graph.bodies[body].positions_deg.empty();
    });
    say(WarningCode::unequal_spacing,
        fmt::format("{} copies of {} are unequally spaced, because {}.", set.group.count, planet,
                    given ? std::string("the given positions are not at equal pitch")
                          : fmt::format("their teeth mesh at only {} positions per revolution",
                                        set.assembly.places)));
  }
  if (!drive.motion.redundant.empty())
    say(WarningCode::redundant_meshes,
        fmt::format(
            "The meshes {} form a closed loop that can move. The shares of these meshes in the "
            "torque depend on their compliance, so no torques are computed.",
            names_of(drive.graph, drive.motion.redundant)));
  if (drive.flow && drive.flow->self_locking())
    say(WarningCode::cannot_drive,
        fmt::format("With this friction, {} cannot drive {}, because the drive is self-locking.",
                    drive.graph.bodies[drive.graph.inputs.front()].name,
                    drive.graph.bodies[drive.graph.output].name));
  report_power_against_inputs(drive);
  if (drive.backward && drive.backward->self_locking())
    say(WarningCode::self_locking,
        fmt::format(
            "With this friction, {} cannot drive {} backwards, because the drive is self-locking.",
            drive.graph.bodies[drive.graph.output].name,
            drive.graph.bodies[drive.graph.inputs.front()].name));
}

}  // namespace

std::optional<double> Drive::speed_rpm(std::size_t body) const {
  if (graph.speeds_rpm.size() != graph.inputs.size()) return std::nullopt;
  return motion.speed(body, graph.speeds_rpm);
}

std::optional<double> Drive::speed_ratio(std::size_t body) const {
  if (graph.inputs.size() == 1) return motion.speeds[body][0].value();
  const auto rpm = speed_rpm(body);
  if (!rpm || graph.speeds_rpm.front() == 0.0) return std::nullopt;
  return *rpm / graph.speeds_rpm.front();
}

std::optional<double> rack_pitch(const DriveGraph& graph, std::size_t body) {
  for (const DriveMesh& mesh : graph.meshes)
    for (const int side : {0, 1}) {
      const DriveGear& rack = graph.gear(mesh, side);
      const DriveGear& pinion = graph.gear(mesh, 1 - side);
      if (rack.rack && rack.body == body && pinion.spec)
        return std::numbers::pi * pinion.spec->normal_module /
               std::cos(pinion.spec->helix_angle.rad());
    }
  return std::nullopt;
}

std::optional<double> Drive::rack_pitch(std::size_t body) const {
  return gearwright::rack_pitch(graph, body);
}

std::optional<double> Drive::lever(std::size_t body) const {
  const auto pitch = rack_pitch(body);
  return pitch ? std::optional(*pitch / kTurn) : std::nullopt;
}

std::optional<double> Drive::linear_speed(std::size_t body) const {
  const auto pitches = speed_rpm(body);
  const auto pitch = rack_pitch(body);
  if (!pitches || !pitch) return std::nullopt;
  return *pitches / 60.0 * *pitch / kMmPerM;
}

std::optional<double> Drive::force(std::size_t body) const {
  const auto arm = lever(body);
  if (!arm || !graph.torque_Nm || !flow || flow->self_locking()) return std::nullopt;
  return flow->torque[body] * *graph.torque_Nm / (*arm / kMmPerM);
}

std::optional<std::size_t> Drive::frame_of_body(std::size_t body) const {
  for (const DriveMesh& mesh : graph.meshes)
    for (const int side : {0, 1})
      if (graph.gear(mesh, side).body == body) return graph.frame(mesh);
  return std::nullopt;
}

std::optional<double> Drive::play(std::size_t body, std::size_t held) const {
  if (motion.freedom != 1 || !motion.redundant.empty()) return std::nullopt;
  const auto loads = lossless_loads(graph, motion, body, held);
  double sum = 0.0;
  for (std::size_t m = 0; m < loads.size(); ++m) {
    if (!loads[m].fits()) return std::nullopt;
    if (loads[m].zero()) continue;
    const auto backlash = transverse_base_backlash(geometry, m);
    if (!backlash) return std::nullopt;
    const Gear& gear = *geometry.gears[graph.meshes[m].gears[0]];
    sum += std::abs(loads[m].value()) * kTurn * *backlash / gear.reference().base_pitch_transverse;
  }
  return sum;
}

std::vector<Rational> Drive::phases(std::size_t mesh) const {
  for (const PlanetSet& set : sets) {
    const auto& own = set.group.meshes;
    if (!is_in(mesh, own)) continue;
    for (const std::size_t g : graph.meshes[mesh].gears)
      if (graph.body(graph.gears[g]).carrier != set.group.carrier)
        return mesh_phases(graph.gears[g].teeth, set.assembly.turns);
  }
  return {};
}

std::optional<double> Drive::relative_speed_ratio(std::size_t body) const {
  const auto own = speed_ratio(body);
  const auto frame = frame_of_body(body);
  if (!own || !frame) return own;
  if (graph.inputs.size() == 1) return (motion.speeds[body][0] - motion.speeds[*frame][0]).value();
  return *own - *speed_ratio(*frame);
}

std::optional<double> Drive::frequency_ratio(std::size_t mesh) const {
  const DriveMesh& m = graph.meshes[mesh];
  const DriveGear& a = graph.gear(m, 0);
  const auto frame = graph.frame(m);
  if (graph.inputs.size() == 1) {
    const Rational w_c = frame ? motion.speeds[*frame][0] : Rational();
    return std::abs((Rational(a.teeth) * (motion.speeds[a.body][0] - w_c)).value());
  }
  const auto w_a = speed_ratio(a.body);
  const auto w_c = frame ? speed_ratio(*frame) : std::optional(0.0);
  if (!w_a || !w_c) return std::nullopt;
  return std::abs(a.teeth * (*w_a - *w_c));
}

Result<Drive> make_drive(const DriveInput& input) {
  const DriveGraph given = normalised(input.graph);
  if (auto error = check_graph(given)) return *error;
  if (auto error = check_distances(given)) return *error;
  Drive drive;
  drive.graph = with_backlash(given);
  auto motion = drive_motion(drive.graph);
  if (!motion) return motion.error();
  drive.motion = std::move(motion).take();
  drive.geometry = drive_geometry(drive.graph);
  if (input.remedies && !blame_backlash(given, drive.graph, drive.geometry))
    add_remedy(drive.graph, drive.geometry);
  drive.efficiencies = mesh_efficiencies(drive.graph, drive.geometry);
  if (auto error = find_flows(drive)) return *error;
  for (const PlanetGroup& group : planet_groups(drive.graph)) {
    auto set = planet_set(drive, group, input.harmonics);
    if (!set) return set.error();
    drive.sets.push_back(std::move(set).take());
  }
  drive.backlash = backlash_of_drive(drive);
  drive.error = transmission_error(drive, input.harmonics);
  find_facts(drive);
  for (const DriveGraph& stage : input.stages) {
    auto made = make_drive({stage, {}, input.harmonics, input.remedies});
    if (!made) return made.error();
    drive.stages.push_back(std::move(made).take());
  }
  return drive;
}

}  // namespace gearwright
