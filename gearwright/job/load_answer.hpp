// The verb `load` computes the pair of a spec under torque, and probes of its teeth. This header
// also contains the load part of `run`.
#pragma once

#include <optional>
#include <string>

#include "gearwright/arrange/loaded_pair.hpp"
#include "gearwright/catalogue/load_quantities.hpp"
#include "gearwright/catalogue/rating_quantities.hpp"
#include "gearwright/figure/load_scene.hpp"
#include "gearwright/job/contact_answer.hpp"

namespace gearwright {

/// Returns the nominal torque of [rating] in N m. It has three decimals, or four digits if it is
/// below 1 N m. Returns none if [load] has a torque or if [rating] has none.
std::optional<double> torque_of_rating(const JobSpec& spec);

/// Computes the result of `load`. If [load] has neither a torque nor probes, the nominal torque of
/// [rating] is used, and the job gets a note.
///
/// Errors    `load` if there is neither a torque nor a probe; `gear2` if it is missing; the errors
///           of loaded()
Result<LoadAnalysis> answer_load(SolvedJob& job, Progress* progress = nullptr);

/// Errors    the errors of answer_load; `load` if there is no torque; `gear1.double_helical` for
///           double-helical gears
Result<LoadTask> load_task(SolvedJob& job);
/// Returns the task of the pair, or for a double-helical pair the tasks of load_tasks_of_halves().
Result<std::vector<LoadTask>> load_tasks(SolvedJob& job);

std::string load_listing(const SolvedJob& job, const LoadAnalysis& answer);

// The load part of `run` consists of the result of `load` and the scenes for the report.

/// The report contains pointers to data of the job, so the job must outlive it. The report covers
/// one pitch, even if [load] requests other rotations.
struct LoadPart {
  LoadAnalysis answer;
  std::optional<LoadScene> report;  ///< none if [load] requests only probes
};

/// Computes the result of `load` and its scene.
///
/// Errors    the errors of answer_load
Result<LoadPart> load_with_scene(SolvedJob& job, Progress* progress = nullptr);

/// Returns the load part, or none if [load] requests neither torques nor probes. There is also no
/// load part if torques are given for a single gear, if the gears have no contact, or if the
/// contact under load cannot be computed for such gears. In these three cases, the job has a
/// warning.
///
/// Errors    all other errors of answer_load
Result<std::optional<LoadPart>> load_part(SolvedJob& job, Progress* progress = nullptr);

// The verb `rate` rates the pair of a spec that has [rating] and materials. It also computes values
// that would give sufficient safety factors.

/// Rates the pair. If a limit of the standard is exceeded, the job gets a warning.
///
/// Errors    `rating` if the spec has none; `gearN.material…` if a strength of the material is
///           unknown; the errors of rated_pair and rate; the errors of FaceLoads::of if K_Hβ is
///           computed from the load along the teeth; the errors of answer_load if
///           `rating.tooth_contact` is set
Result<RatingAnswer> answer_rating(SolvedJob& job, Progress* progress = nullptr);

}  // namespace gearwright
