#include "gearwright/drive/short_forms.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>

#include "gearwright/base/lists.hpp"
#include "gearwright/base/number_text.hpp"
#include "gearwright/drive/drive_geometry.hpp"
#include "gearwright/inspection/thickness_series.hpp"

namespace gearwright {

namespace {

using M = SetMember;

constexpr std::array<M, kSetMembers> kMembers{M::sun,     M::sun2, M::idler, M::planet,
                                              M::planet2, M::ring, M::ring2};

// Returns 1 if the helix of a member has the hand of the sun, and otherwise −1. Every external mesh
// reverses the hand.
double hand_of(const PlanetarySpec& spec, M member) {
  const double planet = spec.z(M::idler) ? 1.0 : -1.0;
  switch (member) {
    case M::sun: return 1.0;
    case M::sun2: return -planet;
    case M::idler: return -1.0;
    default: return planet;
  }
}

// True if a member is a planet with one gear that meshes with two suns side by side, or with two
// rings side by side.
bool spans_two(const PlanetarySpec& spec, M member) {
  const auto has = [&](M m) { return spec.z(m).has_value(); };
  if (member != M::planet || has(M::planet2)) return false;
  return (has(M::ring) && has(M::ring2)) || (has(M::sun2) && (has(M::sun) || has(M::idler)));
}

CylindricalSpec teeth_of(const PlanetarySpec& spec, M member) {
  CylindricalSpec made;
  made.normal_module = *spec.normal_module;
  made.normal_pressure_angle = spec.normal_pressure_angle;
  const auto& own_helix = spec.helix_deg.each[static_cast<std::size_t>(member)];
  const double sun = spec.helix_deg.each[0].value_or(spec.helix_deg.all.value_or(0.0));
  made.helix_angle = Angle::degrees(own_helix.value_or(hand_of(spec, member) * sun));
  made.face_width = spec.face_width.of(member).value_or(10 * made.normal_module);
  if (!spec.face_width.each[static_cast<std::size_t>(member)] && spans_two(spec, member))
    made.face_width = 2 * made.face_width + kBetweenFaces * made.normal_module;
  const double diameter =
      made.normal_module * std::abs(*spec.z(member)) / std::cos(made.helix_angle.rad());
  made.thickness_allowance =
      spec.allowance.of(member).value_or(mean_allowance(spec.series, diameter));
  made.tip_diameter = spec.tip_diameter.of(member);
  return made;
}

std::optional<Error> check_set(const PlanetarySpec& spec) {
  const auto has = [&](M m) { return spec.z(m).has_value(); };
  if (has(M::idler) && !has(M::sun))
    return Error{"planetary.idler", std::to_string(*spec.z(M::idler)),
                 "needs a sun, because an idler is between the sun and the planet"};
  if (spec.idler_side != IdlerSide::counter_clockwise && !has(M::idler))
    return Error{"planetary.idler_side", "",
                 "needs `planetary.idler`, the number of teeth of the idler"};
  if (has(M::planet2) && !has(M::sun2) && !has(M::ring2))
    return Error{"planetary.planet2", std::to_string(*spec.z(M::planet2)),
                 "needs sun2 or ring2, with which it meshes"};
  if (meshes_of(spec).empty())
    return absent_input("planetary.ring", "; planets need a sun or a ring with which they mesh");
  for (const M m : kMembers) {
    if (!has(m) || is_ring(m) || *spec.z(m) > 0) continue;
    return refused(fmt::format("planetary.{}", to_string(m)), *spec.z(m),
                   "must be at least 1; only a ring may have a negative number of teeth");
  }
  for (const SetMesh& mesh : meshes_of(spec)) {
    if (!is_ring(mesh.second) || std::abs(*spec.z(mesh.second)) > *spec.z(mesh.first)) continue;
    return refused(fmt::format("planetary.{}", to_string(mesh.second)), *spec.z(mesh.second),
                   fmt::format("must have more teeth than {} = {}, which meshes inside it",
                               to_string(mesh.first), *spec.z(mesh.first)));
  }
  if (!spec.fixed && meshes_of(spec).size() == 1 && !has(M::ring) && !has(M::ring2))
    return absent_input("planetary.ring",
                        "; a set of one sun and planets has no default for the fixed, the driving "
                        "and the driven body. Give a ring or a second sun, or name these bodies by "
                        "`fixed`, `input` and `output`");
  if (!spec.fixed && spec.output.empty() && meshes_of(spec).size() == 1)
    return absent_input("planetary.sun",
                        "; one ring has no default output. Give a sun, or give `output`");
  if (!spec.normal_module && (spec.backlash.all || !spec.backlash.each.empty()))
    return Error{"planetary.backlash", "",
                 "needs `normal_module`, because there are no teeth without a module"};
  if (spec.planets < 1) return refused("planetary.planets", spec.planets, "must be at least 1");
  return std::nullopt;
}

std::optional<Error> find_bodies(const DriveGraph& graph, const std::vector<std::string>& names,
                                 const std::string& field, std::vector<std::size_t>& bodies) {
  for (const std::string& name : names) {
    auto body = find_body(graph, name, field);
    if (!body) return body.error();
    bodies.push_back(*body);
  }
  return std::nullopt;
}

// Adds a planet that fits between sun and ring, z_p = (|z_r| − z_s)/2, if the set has no planet.
std::optional<Error> add_planet(PlanetarySpec& spec) {
  if (spec.z(M::planet)) return std::nullopt;
  const char* const kField = "planetary.planet";
  const auto has = [&](M m) { return spec.z(m).has_value(); };
  if (!has(M::sun) || *spec.z(M::sun) < 1 || !has(M::ring) || has(M::sun2) || has(M::ring2) ||
      has(M::idler) || has(M::planet2))
    return absent_input(kField, "; a planetary set needs planets, for example planet = 20");
  const int sun = *spec.z(M::sun), ring = std::abs(*spec.z(M::ring)), both = ring - sun;
  if (both >= 2 && both % 2 == 0) {
    spec.z(M::planet) = both / 2;
    return std::nullopt;
  }
  if (both < 3)
    return refused(
        "planetary.ring", ring,
        fmt::format("must have at least {} teeth, because the planets are between the ring and "
                    "the sun, which has {} teeth",
                    sun + 2, sun));
  return absent_input(
      kField,
      fmt::format("; its default is (ring − sun)/2 = {}, which is not a whole number. Give planet "
                  "= {} or {}, for which the profile shifts follow from the common centre "
                  "distance, or give ring = {} or {}",
                  both / 2.0, both / 2, both / 2 + 1, ring - 1, ring + 1));
}

// Sets the fixed bodies, inputs and output of the graph. Values that are absent get defaults.
std::optional<Error> set_ends(const PlanetarySpec& spec, DriveGraph& graph) {
  const auto has = [&](M m) { return spec.z(m).has_value(); };
  std::vector<std::string> inputs = spec.inputs;
  if (inputs.empty()) inputs = {has(M::sun) ? "sun" : has(M::sun2) ? "sun2" : "carrier"};
  std::vector<std::string> fixed;
  if (spec.fixed) {
    fixed = *spec.fixed;
  } else {
    fixed = {has(M::ring) ? "ring" : has(M::ring2) ? "ring2" : "sun"};
  }
  std::string output = spec.output;
  const auto taken = [&](const std::string& name) {
    return is_in(name, inputs) || is_in(name, fixed);
  };
  if (output.empty()) {
    output = "carrier";
    for (const char* other : {"ring2", "ring", "sun2", "sun"})
      if (taken(output) && find_body(graph, other, "")) output = other;
    if (taken(output))
      return Error{
          spec.fixed ? "drive.fixed" : "drive.input",
          fmt::format("{}", fmt::join(spec.fixed ? fixed : inputs, ", ")),
          fmt::format("leaves no body for the output (fixed: {}; input: {}); fix fewer bodies",
                      fmt::join(fixed, ", "), fmt::join(inputs, ", "))};
  }
  if (auto error = find_bodies(graph, fixed, "drive.fixed", graph.fixed)) return error;
  if (auto error = find_bodies(graph, inputs, "drive.input", graph.inputs)) return error;
  auto out = find_body(graph, output, "drive.output");
  if (!out) return out.error();
  graph.output = *out;
  return std::nullopt;
}

DriveGraph pair_graph(const PairStage& stage) {
  DriveGraph graph;
  for (const std::size_t i : {0, 1}) {
    const std::string name = i == 0 ? "gear1" : "gear2";
    graph.bodies.push_back({name, std::nullopt, 1, {}});
    graph.gears.push_back({name, i, stage.teeth[i], std::nullopt, stage.specs[i], stage.shifts[i],
                           stage.modifications[i], stage.bores[i], stage.double_helical[i]});
  }
  graph.meshes.push_back({"gear1_gear2", {0, 1}, stage.efficiency, stage.center_distance});
  graph.meshes.front().backlash = stage.backlash;
  graph.meshes.front().backlash_is_mean = stage.backlash_is_mean;
  graph.meshes.front().direction = stage.direction;
  graph.inputs = {0};
  graph.output = 1;
  return graph;
}

// Appends a stage to the train. If `joined` is given, the input of the stage is the body `joined`
// of the train.
void append(DriveGraph& train, const DriveGraph& stage, const std::string& prefix,
            std::optional<std::size_t> joined) {
  std::vector<std::size_t> body(stage.bodies.size());
  for (std::size_t b = 0; b < body.size(); ++b) {
    if (joined && b == stage.inputs.front()) {
      body[b] = *joined;
      continue;
    }
    body[b] = train.bodies.size();
    train.bodies.push_back(stage.bodies[b]);
    train.bodies.back().name = prefix + stage.bodies[b].name;
    if (stage.bodies[b].carrier) train.bodies.back().spacing = stage.spacing;
  }
  for (std::size_t b = 0; b < body.size(); ++b) {
    if (joined && b == stage.inputs.front()) continue;
    if (auto& carrier = train.bodies[body[b]].carrier) carrier = body[*stage.bodies[b].carrier];
  }
  const std::size_t first_gear = train.gears.size();
  for (DriveGear gear : stage.gears) {
    gear.name = prefix + gear.name;
    gear.body = body[gear.body];
    train.gears.push_back(std::move(gear));
  }
  for (DriveMesh mesh : stage.meshes) {
    mesh.name = prefix + mesh.name;
    mesh.friction = stage.friction;
    for (std::size_t& g : mesh.gears) g += first_gear;
    train.meshes.push_back(std::move(mesh));
  }
  for (const std::size_t b : stage.fixed) train.fixed.push_back(body[b]);
  if (!joined) {
    for (const std::size_t b : stage.inputs) train.inputs.push_back(body[b]);
    train.speeds_rpm = stage.speeds_rpm;
    train.torque_Nm = stage.torque_Nm;
  }
  train.output = body[stage.output];
}

// A stage of two gears. The line between its axes is a side of the polygon that the axes of a train
// form.
struct Side {
  std::size_t stage;  // counted from 1
  std::size_t mesh;
  double length;  // a  mm
};

// Sets the direction of the last stage so that the axis of the output is also the axis of the
// input. If the direction of the stage before the last one is absent, the function may compute it
// as well.
std::optional<Error> close_train(DriveInput& train) {
  constexpr double kCloses = 1e-6;  // mm; far below the play of any bearing
  const auto fails = [&train](const std::string& rule) {
    return Error{fmt::format("stage[{}].angle", train.stages.size()), "\"coaxial\"", rule};
  };
  if (auto error = check_graph(train.graph)) return error;
  const DriveGeometry geometry = drive_geometry(train.graph);
  std::vector<Side> sides;
  std::size_t mesh = 0;
  for (std::size_t k = 0; k < train.stages.size(); ++k) {
    const DriveGraph& own = train.stages[k];
    if (!own.frame(own.meshes.front())) {
      const auto distance = geometry.distance[mesh] ? geometry.distance[mesh]
                                                    : train.graph.meshes[mesh].center_distance;
      if (!distance)
        return fails(
            fmt::format("needs the centre distance of stage {}, which is not known; give "
                        "`normal_module` for all stages",
                        k + 1));
      sides.push_back({k + 1, mesh, *distance});
    }
    mesh += own.meshes.size();
  }
  const Side last = sides.back();
  if (sides.size() < 2)
    return fails(
        "needs at least two stages of two gears, because a single stage cannot lead back to the "
        "axis of its input");
  // Adds up the sides of the polygon. `from` and `to` become the axes of the input and of the
  // output of the stage before the last one.
  auto& meshes = train.graph.meshes;
  const Side before = sides[sides.size() - 2];
  double angle = 0.0;
  Vec2 from = Vec2::Zero(), to = Vec2::Zero();
  for (const Side& side : sides) {
    if (side.mesh == last.mesh) break;
    angle = meshes[side.mesh].direction.value_or(Angle::radians(angle)).rad();
    from = to;
    to += side.length * Vec2(std::cos(angle), std::sin(angle));
  }
  const double first = from.norm();
  if (sides.size() > 2 && !meshes[before.mesh].direction && first > kCloses) {
    const double a = before.length, b = last.length;
    if (a + b < first - kCloses || std::abs(a - b) > first + kCloses)
      return fails(
          fmt::format("is impossible, because no triangle has the sides {:.4f} mm (between the "
                      "input and stage {}), {:.4f} mm and {:.4f} mm (the centre distances); give "
                      "another `center_distance`",
                      first, before.stage, a, b));
    // The interior angle at `from`, by the law of cosines.
    const double cosine = (first * first + a * a - b * b) / (2 * first * a);
    const double at_from = std::acos(std::clamp(cosine, -1.0, 1.0));
    angle = std::remainder(std::atan2(-from.y(), -from.x()) - at_from, 2 * std::numbers::pi);
    meshes[before.mesh].direction = Angle::radians(angle);
    to = from + a * Vec2(std::cos(angle), std::sin(angle));
  }
  if (std::abs(to.norm() - last.length) > kCloses)
    return fails(
        fmt::format("is impossible, because the last stage begins {:.4f} mm from the axis of the "
                    "input, but its centre distance is {:.4f} mm; give `center_distance` = {:.4f} "
                    "mm for the last stage, and leave out one of its profile shifts",
                    to.norm(), last.length, to.norm()));
  meshes[last.mesh].direction = Angle::radians(std::atan2(-to.y(), -to.x()));
  return std::nullopt;
}

}  // namespace

double mean_allowance(const std::string& series, double reference_diameter) {
  const auto ends = thickness_allowances(series, reference_diameter);
  return ends ? ((*ends)[0] + (*ends)[1]) / 2 : 0.0;
}

void PairStage::set_teeth(const PairTeeth& given) {
  for (const std::size_t i : {0, 1}) {
    CylindricalSpec spec;
    spec.teeth = teeth[i];
    spec.normal_module = given.normal_module;
    spec.normal_pressure_angle = given.normal_pressure_angle;
    spec.helix_angle =
        Angle::degrees(i == 0 ? given.helix_deg : -side_of(teeth[1]) * given.helix_deg);
    spec.face_width = given.face_width.value_or(10 * given.normal_module);
    spec.thickness_allowance = given.allowance[i].value_or(0.0);
    specs[i] = spec;
  }
}

void PairStage::set_allowances(const std::string& series) {
  for (auto& spec : specs) {
    if (series.empty() || !spec || spec->thickness_allowance != 0.0) continue;
    const double diameter =
        spec->normal_module * std::abs(spec->teeth) / std::cos(spec->helix_angle.rad());
    spec->thickness_allowance = mean_allowance(series, diameter);
  }
}

Result<std::size_t> find_body(const DriveGraph& graph, const std::string& name,
                              const std::string& field) {
  std::vector<std::string> known;
  for (std::size_t b = 0; b < graph.bodies.size(); ++b) {
    if (graph.bodies[b].name == name) return b;
    known.push_back(graph.bodies[b].name);
  }
  return Error{field, name,
               fmt::format("there is no such body; the bodies are {}", fmt::join(known, ", "))};
}

Result<DriveGraph> graph_of(const PlanetarySpec& given) {
  PlanetarySpec spec = given;
  if (auto error = add_planet(spec)) return *error;
  if (auto error = check_set(spec)) return *error;
  DriveGraph graph;
  std::array<std::size_t, kSetMembers> gear_of{};
  // The bodies are the central gears, the carrier and the riders, in this order. A stepped planet
  // is one body.
  for (const M m : {M::sun, M::sun2, M::ring, M::ring2})
    if (spec.z(m)) graph.bodies.push_back({to_string(m), std::nullopt, 1, {}});
  const std::size_t carrier = graph.bodies.size();
  graph.bodies.push_back({"carrier", std::nullopt, 1, {}});
  for (const M m : {M::planet, M::idler})
    if (spec.z(m))
      graph.bodies.push_back({to_string(m), carrier, spec.planets, spec.positions_deg});
  if (spec.z(M::idler)) graph.bodies.back().side = spec.idler_side;
  for (const M m : kMembers) {
    if (!spec.z(m)) continue;
    const auto body = find_body(graph, m == M::planet2 ? "planet" : to_string(m), "");
    const int teeth = signed_teeth(m, *spec.z(m));
    gear_of[static_cast<std::size_t>(m)] = graph.gears.size();
    DriveGear gear{to_string(m), *body,        teeth,
                   std::nullopt, std::nullopt, spec.profile_shift.of(m)};
    if (spec.normal_module) gear.spec = teeth_of(spec, m);
    const auto& own_bore = spec.bore.each[static_cast<std::size_t>(m)];
    if (const auto bore = is_ring(m) ? own_bore : spec.bore.of(m)) gear.bore = Bore{*bore};
    graph.gears.push_back(std::move(gear));
  }
  for (const SetMesh& mesh : meshes_of(spec)) {
    const auto distance = spec.center_distance.of(mesh.name);
    const bool named =
        std::any_of(spec.center_distance.each.begin(), spec.center_distance.each.end(),
                    [&](const auto& e) { return e.first == mesh.name; });
    graph.meshes.push_back({mesh.name,
                            {gear_of[static_cast<std::size_t>(mesh.first)],
                             gear_of[static_cast<std::size_t>(mesh.second)]},
                            spec.efficiency.of(mesh.name),
                            named || graph.meshes.empty() ? distance : std::nullopt});
    graph.meshes.back().backlash = spec.backlash.of(mesh.name);
    graph.meshes.back().backlash_is_mean = spec.backlash_is_mean;
  }
  graph.speeds_rpm = spec.speeds_rpm;
  graph.torque_Nm = spec.torque_Nm;
  graph.friction = spec.friction;
  graph.spacing = spec.spacing;
  if (auto error = set_ends(spec, graph)) return *error;
  return graph;
}

Result<DriveInput> train_of(const std::vector<StageSpec>& stages) {
  DriveInput made;
  std::optional<std::size_t> joined;
  for (std::size_t k = 0; k < stages.size(); ++k) {
    Result<DriveGraph> stage = stages[k].planetary ? graph_of(*stages[k].planetary)
                                                   : Result<DriveGraph>(pair_graph(stages[k].pair));
    if (!stage) return stage.error();
    DriveGraph own = std::move(stage).take();
    if (!stages[k].planetary) {
      own.speeds_rpm = stages[k].speeds_rpm;
      own.torque_Nm = stages[k].torque_Nm;
      own.friction = stages[k].friction;
    }
    if (k > 0 && own.inputs.size() != 1)
      return Error{fmt::format("stage[{}].input", k + 1), std::to_string(own.inputs.size()),
                   fmt::format("stage {} must have exactly one input, because the output of the "
                               "previous stage drives it",
                               k + 1)};
    if (k > 0 && (!own.speeds_rpm.empty() || own.torque_Nm)) {
      const bool speed = !own.speeds_rpm.empty();
      return Error{fmt::format("stage[{}].{}", k + 1, speed ? "speed" : "torque"),
                   format_number(speed ? own.speeds_rpm.front() : *own.torque_Nm),
                   fmt::format("must not be given for stage {}, because the first stage determines "
                               "this value; give the value in the first stage",
                               k + 1)};
    }
    append(made.graph, own, fmt::format("s{}_", k + 1), joined);
    joined = made.graph.output;
    made.stages.push_back(std::move(own));
  }
  if (!stages.empty() && !stages.back().planetary && stages.back().pair.coaxial)
    if (auto error = close_train(made)) return *error;
  return made;
}

}  // namespace gearwright
