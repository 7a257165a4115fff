// The answer of the verb drive. Internal to job/ and its tests.
#pragma once

#include <string>

#include "gearwright/drive/drive.hpp"
#include "gearwright/job/verbs.hpp"

namespace gearwright {

/// Tables for users: the whole drive, bodies, meshes, planets, phases, and the stages of a train.
std::string drive_listing(const Drive& drive, UnitSystem units);

/// The answer of the verb drive. It includes the drive under load if the spec has [load].
///
/// Errors    the errors of solve_drive() and load_drive()
Result<Answer> answer_drive(const JobSpec& spec, Progress* progress = nullptr);

/// The answer of the verb drive with each mesh rated by ISO 6336.
///
/// Errors    the errors of solve_drive() and load_drive(); `rating.…` for the errors of
///           rate_meshes() and material_of()
Result<Answer> answer_drive_rating(const JobSpec& spec, Progress* progress = nullptr);

}  // namespace gearwright
