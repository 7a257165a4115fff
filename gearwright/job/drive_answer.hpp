// The answer of the verb drive. Internal to job/ and its tests.
#pragma once

#include <string>

#include "gearwright/drive/drive.hpp"
#include "gearwright/job/verbs.hpp"

namespace gearwright {

/// Tables for users: the whole drive, bodies, meshes, planets, phases, and the stages of a train.
std::string drive_listing(const Drive& drive);

/// Errors    the errors of solve_drive()
Result<Answer> answer_drive(const JobSpec& spec);

/// The answer of the verb drive with each mesh rated by ISO 6336.
///
/// Errors    the errors of solve_drive(); those of rate_meshes() and material_of(), with keys of [rating]
Result<Answer> answer_drive_rating(const JobSpec& spec);

}  // namespace gearwright
