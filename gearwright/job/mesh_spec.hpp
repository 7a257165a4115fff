// A mesh of a drive as a spec of its own, so that every verb for pairs applies to it. Internal to
// job/.
#pragma once

#include <string>
#include <vector>

#include "gearwright/job/drive_job.hpp"
#include "gearwright/spec/json.hpp"

namespace gearwright {

struct MeshSpec {
  Json tables;
  std::vector<std::string> notes;  ///< sentences: the origin of the spec, faults of the drive,
                                   ///< and tables that are left out
};

/// The spec of a mesh has its two gears at their centre distance, with the shifts and tip diameters
/// in the drive. If the mesh carries load, it also has the torque, the speed relative to the
/// carrier, the driving gear and the rating. The tables for errors, contact, drawing and scatter
/// are copied from the drive. If one gear is a rack, the rack is gear 2.
///
/// Laws      the pair of this spec has the same numbers as the mesh in the drive
/// Domain    expanded = expanded_spec() of the drive (contract)
MeshSpec mesh_spec(const DriveJob& job, const Json& expanded, std::size_t mesh);

}  // namespace gearwright
