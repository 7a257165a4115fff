// The answer of the verb drive. Internal to job/ and its tests.
#pragma once

#include <string>

#include "gearwright/drive/drive.hpp"
#include "gearwright/job/verbs.hpp"

namespace gearwright {

/// The worst of the drive and of the pairs in its meshes, of rated ones by the safeties wanted too.
Verdict judge_drive(const Drive& drive, const WantedSafety& wanted = {1.0, 1.0});

/// Tables for people: the whole, bodies, meshes, planets, phases; of a train its stages too.
std::string drive_listing(const Drive& drive);

/// The drive of a spec, its transmission error under the spec's [errors] in every mesh.
///
/// Errors    a spec without a drive; as make_drive(), with the keys of the spec
Result<Drive> make_drive_of(const JobSpec& spec);

/// Errors    as make_drive_of()
Result<Answer> answer_drive(const JobSpec& spec);

/// The same with each mesh rated by ISO 6336.
///
/// Errors    as make_drive_of(); `rating.…` as rate_meshes() and material_of()
Result<Answer> answer_drive_rating(const JobSpec& spec);

}  // namespace gearwright
