// Checks whether a drive can be computed under a load.
#include <fmt/format.h>

#include "gearwright/base/lists.hpp"
#include "gearwright/drive/loaded_drive.hpp"
#include "gearwright/drive/mesh_springs.hpp"

namespace gearwright {

namespace {

using detail::not_loaded;

// Returns an error if the loaded contact does not support this kind of drive.
std::optional<Error> not_made_for(const Drive& drive, const DriveLoadCase& load) {
  const DriveGraph& graph = drive.graph;
  if (graph.inputs.size() != 1 || drive.motion.freedom != 1)
    return not_loaded(
        "does not apply to a drive with several inputs; fix all inputs except one, or write one "
        "mesh as a pair with the command `gearwright drive SPEC --take N`");
  if (!drive.motion.redundant.empty())
    return not_loaded(
        "does not apply to a drive with a closed loop of meshes, because the torques in the loop "
        "depend on the compliance of shafts");
  if (!drive.geometry.faults.empty())
    return not_loaded("does not apply to gears that do not fit: " +
                      drive.geometry.faults.front().message);
  for (std::size_t m = 0; m < graph.meshes.size(); ++m)
    if (const auto& pair = drive.geometry.pairs[m]; pair && pair->arcs())
      return not_loaded(
          "does not apply to circular-arc teeth, because their loaded contact is not computed",
          graph.meshes[m].name);
  if (!drive.flow)
    return not_loaded(
        "needs the torques of all meshes; give a normal module or the efficiencies of the meshes");
  if (drive.flow->self_locking())
    return not_loaded("does not apply to a self-locking drive, because it transmits no power");
  if (!(load.torque > 0.0)) return Error{"load.torques", "0", "must be greater than 0"};
  for (std::size_t m = 0; m < graph.meshes.size(); ++m) {
    if (drive.flow->driver[m] < 0) continue;
    const DriveMesh& mesh = graph.meshes[m];
    const DriveGear &a = graph.gear(mesh, 0), &b = graph.gear(mesh, 1);
    if (a.rack || b.rack)
      return not_loaded(
          "does not apply to a drive with a rack, because its loaded contact is not computed",
          mesh.name);
    if (a.double_helical || b.double_helical)
      return not_loaded(
          "does not apply to drives with double-helical gears; write the mesh as a pair with the "
          "command `gearwright drive SPEC --take N`; the command `gearwright load` computes both "
          "halves of this pair",
          mesh.name);
    if (!drive.geometry.involutes(m))
      return not_loaded(
          "needs involute teeth in every mesh; give a normal module and profile shifts that fit",
          mesh.name);
  }
  return std::nullopt;
}

// Returns an error if the body cannot float, or if the number of pin errors differs from the number
// of pins.
std::optional<Error> not_possible(const Drive& drive, const DriveLoadCase& load) {
  const DriveGraph& graph = drive.graph;
  if (load.floating) {
    std::vector<std::string> names;
    int sets = 0;
    bool known = false;
    for (const PlanetSet& set : drive.sets) {
      std::vector<std::size_t> bodies{set.group.carrier};
      for (const std::size_t m : set.group.meshes)
        for (const int side : {0, 1}) {
          const DriveGear& gear = graph.gear(graph.meshes[m], side);
          if (!graph.body(gear).carrier) bodies.push_back(gear.body);
        }
      for (const std::size_t b : bodies) {
        const std::string& name = graph.bodies[b].name;
        add_once(names, name);
      }
      const bool here = is_in(*load.floating, bodies);
      known = known || here;
      sets += here ? 1 : 0;
      if (here && set.group.count < 2)
        return Error{"load.floating", graph.bodies[*load.floating].name,
                     "cannot float, because a single planet cannot hold it in position"};
    }
    const std::string& name = graph.bodies[*load.floating].name;
    if (!known)
      return Error{
          "load.floating", name,
          names.empty()
              ? "cannot float, because the drive has no planets"
              : fmt::format(
                    "cannot float; only the carrier and the central gears of a set can float: {}",
                    fmt::join(names, ", "))};
    if (sets > 1)
      return Error{"load.floating", name,
                   "belongs to several sets, but a floating body must belong to one set only"};
  }
  if (load.pin_errors.empty()) return std::nullopt;
  const std::string count =
      fmt::format("{} number{}", load.pin_errors.size(), load.pin_errors.size() == 1 ? "" : "s");
  if (drive.sets.size() != 1)
    return Error{"load.pin_errors", count,
                 drive.sets.empty() ? "apply only to planets, but the drive has no planets"
                                    : "apply only to a drive with one set of planets"};
  const PlanetGroup& group = drive.sets.front().group;
  if (group.pins() != load.pin_errors.size()) {
    std::vector<std::string> names;
    for (const std::size_t b : group.riders)
      names.push_back(fmt::format("{} of {}", group.count, graph.bodies[b].name));
    return Error{
        "load.pin_errors", count,
        fmt::format(
            "must be one number for each of the {} pins ({}), or a single number for the first pin",
            group.pins(), fmt::join(names, ", then "))};
  }
  return std::nullopt;
}

}  // namespace

std::optional<Error> check_load(const Drive& drive, const DriveLoadCase& load) {
  if (auto error = not_made_for(drive, load)) return error;
  return not_possible(drive, load);
}

}  // namespace gearwright
