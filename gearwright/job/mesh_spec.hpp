// A mesh of a drive as a spec of its own, so that every verb for pairs applies to it. Internal to job/.
#pragma once

#include <string>
#include <vector>

#include "gearwright/job/drive_job.hpp"
#include "gearwright/spec/json.hpp"

namespace gearwright {

struct MeshSpec {
  Json tables;
  std::vector<std::string> notes;  ///< sentences: the origin of the spec, then faults of the drive
                                   ///< and tables that are left out
};

/// The two gears of a mesh at their centre distance, with the shifts and tip diameters of the drive,
/// the torque, the speed relative to the carrier and the driving gear of a mesh that carries load, its
/// rating, and the tables for errors, contact and inspection of the drive. The gear of a rack is gear
/// 2.
///
/// Laws      the pair of this spec has the numbers of the mesh in the drive
/// Domain    expanded = expanded_spec() of the drive (contract)
MeshSpec mesh_spec(const DriveJob& job, const Json& expanded, std::size_t mesh);

}  // namespace gearwright
