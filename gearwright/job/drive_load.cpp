#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "gearwright/base/number_text.hpp"
#include "gearwright/base/printable.hpp"
#include "gearwright/base/units.hpp"
#include "gearwright/drive/loaded_drive.hpp"
#include "gearwright/job/drive_answer.hpp"
#include "gearwright/job/drive_job.hpp"
#include "gearwright/job/load_answer.hpp"
#include "gearwright/spec/parse_spec.hpp"
#include "gearwright/spec/read_drive.hpp"

namespace gearwright {

namespace {

// Returns an error if the spec gives keys of [load] that apply only to a single pair.
std::optional<Error> not_for_drives(const JobSpec& spec) {
  for (const char* key :
       {"driver", "rotation1_deg", "deflection_slope_um", "deflection_bow_um", "probe"})
    if (spec.given.contains(std::string("load.") + key))
      return Error{std::string("load.") + key, "",
                   "applies to a pair; the command `gearwright drive SPEC --take N` writes mesh N "
                   "of the drive as a pair"};
  return std::nullopt;
}

// Returns the torque on the input in N m, from the drive or from [load].
Result<double> torque_of(const JobSpec& spec, const Drive& drive) {
  const auto& own = drive.graph.torque_Nm;
  const auto& given = spec.load.torques;
  if (given.size() > 1)
    return Error{"load.torques", fmt::format("{} numbers", given.size()),
                 "must be one number for a drive, the torque on its input"};
  if (!own && given.empty())
    return absent_input("load.torques",
                        "; a drive under load needs a torque. Give torque_Nm on the input of the "
                        "drive or in [load]");
  if (given.empty()) return std::abs(*own);
  if (auto error = other_torque("load.torques", given.front(), drive)) return *error;
  return given.front();
}

// Returns the position errors of the pins in mm. If the drive has one set of planets, a single
// number applies to the first pin, and the other pins have no error.
std::vector<double> pins_of(const LoadInput& input, const Drive& drive) {
  std::vector<double> pins;
  for (const double error : input.pin_errors) pins.push_back(error * kMmPerUm);
  if (pins.size() == 1 && drive.sets.size() == 1) pins.resize(drive.sets.front().group.pins(), 0.0);
  return pins;
}

bool has_earlier_mesh(const Drive& drive, std::size_t gear, std::size_t mesh) {
  for (std::size_t m = 0; m < mesh; ++m) {
    const auto& [a, b] = drive.graph.meshes[m].gears;
    if (drive.flow->driver[m] >= 0 && (a == gear || b == gear)) return true;
  }
  return false;
}

// If a gear of a mesh has no bore, the computation assumes a diameter at which its body is held.
// The function adds a finding for each such gear, but only for the first mesh of the gear.
void note_held(Drive& drive, std::size_t mesh, const LoadRequest& request,
               const std::vector<Warning>& warnings) {
  for (const Warning& w : warnings) {
    if (w.code != WarningCode::held_at_rim_as_drawn && w.code != WarningCode::held_at_half_the_root)
      continue;
    const std::size_t side = w.gear - 1;
    const std::size_t gear = drive.graph.meshes[mesh].gears[side];
    if (has_earlier_mesh(drive, gear, mesh)) continue;
    drive.findings.push_back(held_without_bore(drive.graph.gears[gear].name, w.code,
                                               request.bodies[side].bore_diameter));
  }
}

// Returns the mesh as a pair under load. The pair is made from the spec that --take prints.
Result<LoadRequest> request_of(DriveJob& job, const Json& expanded, std::size_t mesh,
                               const LoadInput& load) {
  Json tables = mesh_spec(job, expanded, mesh).tables;
  // [load] must have a torque, but its value has no effect. Only the gear bodies, the slices and
  // the accuracy of the request are used.
  tables["load"]["torque_Nm"] = 1.0;
  const auto spec = job_of_mesh(job.drive, mesh, std::move(tables));
  if (!spec) return spec.error();
  auto solved = solve(*spec, Scope::pair);
  if (!solved) return solved.error();
  SolvedJob pair = std::move(solved).take();
  pair.warnings.clear();
  pair.spec.load.slices = load.slices;
  pair.spec.load.accuracy = load.accuracy;
  const auto task = load_task(pair);
  if (!task) return task.error();
  note_held(job.drive, mesh, task->request, pair.warnings);
  return task->request;
}

}  // namespace

std::optional<Error> load_drive(DriveJob& job, Progress* progress) {
  const JobSpec& spec = job.spec;
  const Drive& drive = job.drive;
  if (auto error = not_for_drives(spec)) return error;
  const auto torque = torque_of(spec, drive);
  if (!torque) return torque.error();
  DriveLoadCase load;
  load.torque = *torque;
  load.positions = spec.load.positions;
  load.harmonics = spec.drive->harmonics;
  load.pin_errors = pins_of(spec.load, drive);
  load.requests.resize(drive.graph.meshes.size());
  if (!spec.load.floating.empty()) {
    const auto body = find_body(drive.graph, spec.load.floating, "load.floating");
    if (!body) return body.error();
    load.floating = *body;
  }
  if (spec.errors.any()) load.errors = mesh_errors(spec, drive);
  if (auto error = check_load(drive, load)) return error;
  const Json expanded = expanded_spec(spec.tree->tables, *spec.drive);
  for (std::size_t m = 0; m < load.requests.size(); ++m) {
    if (drive.flow->driver[m] < 0) continue;
    auto request = request_of(job, expanded, m, spec.load);
    if (!request) return of_mesh(drive, m, request.error());
    load.requests[m] = std::move(request).take();
  }
  auto loaded = loaded_drive(drive, load, progress);
  if (!loaded) return loaded.error();
  job.drive.loaded = std::move(loaded).take();
  return std::nullopt;
}

}  // namespace gearwright
