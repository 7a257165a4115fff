// Judges a whole drive by the worst finding of its meshes and of the assembly. A remedy is tried on the
// whole drive before it is named.
#pragma once

#include <functional>
#include <string>

#include "gearwright/drive/drive.hpp"
#include "gearwright/verdict/verdict.hpp"

namespace gearwright {

/// A change of one number of a drive.
struct DriveChange {
  Adjustable what;
  std::size_t index;  ///< of the gear, or of the mesh if `what` is a centre distance
  double value;       ///< as in SpecChange
};

/// The drive with a change; none if a drive has no such number.
std::optional<DriveInput> changed(const DriveInput& input, const DriveChange& change);

/// The verdict over the assembly and the meshes. A message about a mesh begins with the name of the mesh.
/// If planets can be mounted only axially, the finding is green, because this is the usual way.
///
/// `wanted`  least safeties of a rated drive
/// `key_of`  returns the key of a change in the spec, which is added to the remedy; may be empty
Verdict judge_drive(const Drive& drive, const DriveInput& input,
                    const std::function<std::string(const DriveChange&)>& key_of = {},
                    const WantedSafety& wanted = {1.0, 1.0});

/// The level of the verdict of judge_drive(), without a search for remedies. Planets at unequal pitch do not count
/// if the caller has requested them.
Level drive_level(const Drive& drive, const WantedSafety& wanted, bool unequal_spacing_counts);

}  // namespace gearwright
