// The answer of the verb drive. Internal to job/ and its tests.
#pragma once

#include <string>

#include "gearwright/drive/drive.hpp"
#include "gearwright/job/verbs.hpp"

namespace gearwright {

/// The worst verdict of the drive and of the pairs in its meshes.
Verdict judge_drive(const Drive& drive);

/// Tables for users: the whole drive, bodies, meshes, planets, phases, and the stages of a train.
std::string drive_listing(const Drive& drive);

/// Errors    a spec without a drive; as make_drive(), with the keys of the spec
Result<Answer> answer_drive(const JobSpec& spec);

}  // namespace gearwright
