// The answer of the verb drive. Internal to job/ and its tests.
#pragma once

#include <string>

#include "gearwright/drive/drive.hpp"
#include "gearwright/job/verbs.hpp"

namespace gearwright {

/// Tables for people: the whole, bodies, meshes, planets, phases; of a train its stages too.
std::string drive_listing(const Drive& drive);

/// Errors    a spec without a drive; as make_drive(), with the keys of the spec
Result<Answer> answer_drive(const JobSpec& spec);

}  // namespace gearwright
