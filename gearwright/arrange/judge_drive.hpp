// Judges a drive. The verdict is the worst finding of its meshes and its assembly. A remedy is
// tried on the whole drive before it is proposed.
#pragma once

#include <functional>
#include <string>

#include "gearwright/drive/drive.hpp"
#include "gearwright/verdict/verdict.hpp"

namespace gearwright {

/// A change of one number of a drive.
struct DriveChange {
  Adjustable what;
  std::size_t index;  ///< index of the gear, or of the mesh if `what` is a centre distance
  double value;       ///< the new value, as in SpecChange
};

/// The input of the drive with this change. None if the input does not contain this number.
std::optional<DriveInput> changed(const DriveInput& input, const DriveChange& change);

/// The verdict on the assembly and the meshes. A message about a mesh begins with the name of the
/// mesh.
/// Planets that can only be mounted axially are a green finding, because axial mounting is usual.
///
/// `wanted`  required safeties of a rated drive
/// `key_of`  returns the key of the changed number in the spec, for the text of the remedy; may be
///           empty
Verdict judge_drive(const Drive& drive, const DriveInput& input,
                    const std::function<std::string(const DriveChange&)>& key_of = {},
                    const WantedSafety& wanted = {1.0, 1.0});

/// The level of the verdict of judge_drive(), without a search for remedies.
/// `unequal_spacing_counts` is false if the caller has requested unequally spaced planets. Unequal
/// spacing is then no finding.
Level drive_level(const Drive& drive, const WantedSafety& wanted, bool unequal_spacing_counts);

}  // namespace gearwright
