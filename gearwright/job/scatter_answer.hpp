// The effect of tolerances on the pair of a spec: the verb `scatter`. Internal to job/ and the
// program.
#pragma once

#include <string>

#include "gearwright/catalogue/scatter_quantities.hpp"
#include "gearwright/job/job_contact.hpp"
#include "gearwright/spec/json.hpp"

namespace gearwright {

/// Answer to [scatter.robust].
struct RobustAnswer {
  RobustTask task;
  RobustCorrections found;
  std::shared_ptr<const SpecTree> corrected;  ///< the spec with the corrections in it
};

struct ScatterAnswer {
  ContactSetup setup;
  ScatterTask task;
  Scatter scatter;
  std::optional<RobustAnswer> robust;
};

/// Setup and task of [scatter], without a load, a scatter and corrections.
///
/// Errors    as answer_scatter()
Result<ScatterAnswer> prepared_scatter(SolvedJob& job);

/// Errors    `scatter.…` of a range or a correction that the teeth cannot take, of a group with an
///           unknown input; as scatter_of() and ContactSetup::of
Result<ScatterAnswer> answer_scatter(SolvedJob& job, Progress* progress = nullptr, int threads = 0);

/// The density of patterns for the first samples of each replicate, at most as many in all; 0 for
/// the usual number.
DensityRequest density_request(const SolvedJob& job, const ScatterTask& task, int most = 0);
/// This density, for the figures of an answer that has none.
PatternDensity density_of(const SolvedJob& job, const ScatterAnswer& answer,
                          Progress* progress = nullptr, int most = 0);

/// An error of the room scatter with the keys of [scatter].
Error of_scatter(const ScatterTask& task, Error error);

/// The view refers to `answer`.
ScatterView scatter_view(const SolvedJob& job, const ScatterAnswer& answer);
Json scatter_json(const SolvedJob& job, const ScatterAnswer& answer);
std::string scatter_listing(const SolvedJob& job, const ScatterAnswer& answer);
/// A row for each sample: its inputs, then its numbers.
std::string scatter_csv(const SolvedJob& job, const ScatterAnswer& answer);
/// Names of the coordinates of x in a table: "errors.crossing_deg", "bearings.bore_a.x_mm".
std::vector<std::string> scatter_columns(const ScatterTask& task);

}  // namespace gearwright
