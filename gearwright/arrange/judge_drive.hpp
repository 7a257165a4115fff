// The verdict over a whole drive: the worst of its parts and of the assembly, with a remedy that was
// tried on the whole drive.
#pragma once

#include <functional>
#include <string>

#include "gearwright/drive/drive.hpp"
#include "gearwright/verdict/verdict.hpp"

namespace gearwright {

/// A change of one number of a drive.
struct DriveChange {
  Adjustable what;
  std::size_t index;  ///< of the gear; of the mesh where `what` is a centre distance
  double value;       ///< as in SpecChange
};

/// The drive with a change; none if a drive has no such number.
std::optional<DriveInput> changed(const DriveInput& input, const DriveChange& change);

/// The verdict over the assembly and the meshes. The message of a mesh begins with its name. If
/// planets can be mounted only axially, this is a note, because that is the usual way.
///
/// `wanted`  least safeties of a rated drive
/// `key_of`  the key of a change in the spec's own words, after the remedy; may be empty
Verdict judge_drive(const Drive& drive, const DriveInput& input,
                    const std::function<std::string(const DriveChange&)>& key_of = {},
                    const WantedSafety& wanted = {1.0, 1.0});

/// The level of that verdict, without a search for remedies. Planets at unequal pitch do not count
/// if the caller has requested them.
Level drive_level(const Drive& drive, const WantedSafety& wanted, bool unequal_spacing_counts);

}  // namespace gearwright
