#include "gearwright/job/run_parts.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "gearwright/catalogue/spelling.hpp"
#include "gearwright/contact/contact_setup.hpp"

namespace gearwright {

namespace {

// Adds a note if the rating and the drawing use the tolerances of different editions.
void note_editions(SolvedJob& job, const Rating& rating) {
  if (!rating.tolerance) return;
  const FlankTolerances rated = tolerance_edition(rating.edition);
  const auto year = [](FlankTolerances edition) {
    return edition == FlankTolerances::iso_2013 ? 2013 : 1995;
  };
  for (const int which : {1, 2}) {
    const ToleranceInput& drawn = job.spec.gear(which).tolerance;
    if (!drawn.quality || drawn.edition == rated) continue;
    job.warnings.push_back(
        {WarningCode::tolerance_editions,
         fmt::format("The rating by {} uses the tolerances of ISO 1328-1:{}, but the inspection "
                     "table and the drawing use ISO 1328-1:{}. Give edition = \"ISO 1328:{}\" in "
                     "[gear1.tolerance] and [gear2.tolerance], or standard = \"ISO 6336:{}\" in "
                     "[rating], to use one edition.",
                     name(rating.edition), year(rated), year(drawn.edition), year(rated),
                     rated == FlankTolerances::iso_2013 ? 2006 : 2019),
         0});
    return;
  }
}

}  // namespace

Result<std::optional<CompensateAnswer>> compensation_part(SolvedJob& job, Progress* progress) {
  if (!job.pair || !job.spec.compensate.given) return std::optional<CompensateAnswer>();
  auto answer = kCompensateAnalysis.find(job, progress);
  if (answer) return std::optional(std::move(answer).take());
  const FailureKind kind = answer.error().kind;
  const auto none = [&](const std::string& why) {
    job.warnings.push_back(
        {WarningCode::no_corrections, "Corrections cannot be computed: " + why + ".", 0});
    return std::optional<CompensateAnswer>();
  };
  if (kind == FailureKind::not_under_load)
    return none(spelled(answer.error(), job.spec.given).message());
  if (!without_contact(answer.error())) return answer.error();
  if (!warns(job, WarningCode::no_contact)) {
    const Error why = spelled(answer.error(), job.spec.given);
    job.warnings.push_back(
        {WarningCode::no_contact, "Corrections cannot be computed: " + why.message() + ".", 0});
  }
  return std::optional<CompensateAnswer>();
}

Result<std::optional<ScatterAnswer>> scatter_part(SolvedJob& job, Progress* progress) {
  if (!job.pair || !job.spec.scatter.given) return std::optional<ScatterAnswer>();
  auto answer = kScatterAnalysis.find(job, progress);
  if (answer) return std::optional(std::move(answer).take());
  if (without_contact(answer.error())) return std::optional<ScatterAnswer>();
  return answer.error();
}

Result<std::optional<RatingAnswer>> rating_part(SolvedJob& job, Progress* progress) {
  if (!job.pair || !job.spec.rating.given) return std::optional<RatingAnswer>();
  auto answer = kRatingAnalysis.find(job, progress);
  if (!answer) {
    const RatingTable& rating = job.spec.rating;
    const FailureKind kind = answer.error().kind;
    const bool needs_load = rating.input.face_load_computed || rating.tooth_contact;
    const bool has_none = without_contact(answer.error()) || kind == FailureKind::not_under_load ||
                          kind == FailureKind::not_converged;
    if (!needs_load || !has_none) return answer.error();
    job.warnings.push_back({WarningCode::no_strength,
                            "The strength cannot be computed: " +
                                spelled(answer.error(), job.spec.given).message() + ".",
                            0});
    return std::optional<RatingAnswer>();
  }
  note_editions(job, answer->rating);
  return std::optional(std::move(answer).take());
}

}  // namespace gearwright
