// The verb `load`: the pair of a spec under torque, probes of its teeth, and the load part of
// `run`.
#pragma once

#include <optional>
#include <string>

#include "gearwright/arrange/loaded_pair.hpp"
#include "gearwright/catalogue/load_quantities.hpp"
#include "gearwright/catalogue/rating_quantities.hpp"
#include "gearwright/figure/load_scene.hpp"
#include "gearwright/job/contact_answer.hpp"

namespace gearwright {

/// The nominal torque of [rating] in N m with three decimals, or four digits if it is below 1 N m,
/// for a spec whose [load] has no torque. None if the spec has neither torque.
std::optional<double> torque_of_rating(const JobSpec& spec);

/// Without a torque and probes in [load], the nominal torque of [rating] is used, and the job gets
/// a note.
///
/// Errors    `load` if there is neither a torque nor a probe; `gear2` if it is missing; the errors
///           of loaded()
Result<LoadAnalysis> answer_load(SolvedJob& job, Progress* progress = nullptr);

/// Errors    the errors of answer_load; `load` if there is no torque
Result<LoadTask> load_task(SolvedJob& job);
/// The task of the pair, or the tasks of load_tasks_of_halves() for a double-helical pair.
Result<std::vector<LoadTask>> load_tasks(SolvedJob& job);

std::string load_listing(const SolvedJob& job, const LoadAnalysis& answer);

// The load part of `run` consists of the result of `load` and the scenes for the report.

/// The report contains pointers into the job. The report always covers one pitch, even if
/// [load] requests other rotations.
struct LoadPart {
  LoadAnalysis answer;
  std::optional<LoadScene> report;  ///< none if only probes were requested
};

/// The load part, or nothing if [load] requests neither torques nor probes. There is also no
/// load part, and the job gets a warning, if torques are given for a single gear, if the gears
/// have no contact, or if loaded contact does not support them.
///
/// Errors    the errors of answer_load that are about a wrong number of the spec
Result<std::optional<LoadPart>> load_part(SolvedJob& job, Progress* progress = nullptr);

// The verb `rate` rates the pair of a spec that has [rating] and materials. It also computes values
// that would improve the rating.

/// Rates the pair. If a limit of the standard is exceeded, the job gets a warning.
///
/// Errors    `rating` if the spec has none; `gearN.material…` if a strength of the material is
///           unknown; the errors of rated_pair and rate; the errors of answer_load if
///           `rating.tooth_contact` is set
Result<RatingAnswer> answer_rating(SolvedJob& job, Progress* progress = nullptr);

}  // namespace gearwright
