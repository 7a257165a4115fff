// The verb `scatter` computes the effect of tolerances on the pair of a spec. Internal to job/ and
// the programs.
#pragma once

#include <string>

#include "gearwright/catalogue/scatter_quantities.hpp"
#include "gearwright/job/contact_answer.hpp"
#include "gearwright/spec/json.hpp"

namespace gearwright {

struct RobustAnswer {
  RobustTask task;
  RobustCorrections found;
  std::shared_ptr<const SpecTree> corrected;  ///< the spec with the corrections
};

struct ScatterAnswer {
  ContactSetup setup;
  ScatterTask task;
  Scatter scatter;
  std::optional<RobustAnswer> robust;
};

/// Returns the tooth thickness of each involute gear and the centre distance as toleranced numbers.
/// Each number varies within the tolerance of the drawing, around the value with which the pair is
/// computed. If [scatter] contains bearings, the centre distance is omitted.
std::vector<ScatterTolerance> drawn_tolerances(const SolvedJob& job);

/// Returns the correlations of [scatter], for tolerances in these groups.
///
/// Errors    `scatter.correlations[N].between` for an input that does not exist, for a pair of
///           inputs that is given twice, and for two names of the same input; `scatter.groups` if
///           indices are requested and correlated inputs are in different groups; the errors of
///           check_correlations()
Result<std::vector<ToleranceCorrelation>> correlations_of(
    const JobSpec& spec, const std::vector<ScatterTolerance>& tolerances,
    const std::vector<ToleranceGroup>& groups);

/// Domain    a job with a pair (contract)
/// Errors    the key in [scatter], or the key of an accuracy grade, whose value is impossible. The
///           kind of the error is `no_flank` if an accuracy grade is given for a gear that has no
///           usable involute flank
Result<VariedInputs> varied_inputs(const SolvedJob& job);

/// Returns the setup and the task of [scatter]. The load, the scatter and the corrections are not
/// yet computed.
///
/// Errors    the errors of answer_scatter()
Result<ScatterAnswer> prepared_scatter(const SolvedJob& job);

/// Returns an error for a scatter under load if [load] and [contact] have different drivers. The
/// samples under load must use the same flanks as the samples without load.
std::optional<Error> other_driver(const JobSpec& spec);

/// Errors    `scatter.…` for a range or a correction that is impossible for the teeth, or for a
///           group with an unknown input; the errors of scatter_of(), robust_corrections() and
///           ContactSetup::of; under load, the errors of other_driver() and load_tasks()
Result<ScatterAnswer> answer_scatter(SolvedJob& job, Progress* progress = nullptr, int threads = 0);

/// Returns the request for a density of contact patterns. The density is computed from the first
/// samples of each replicate. `most` limits the number of samples of all replicates together. If
/// `most` is 0, the default limit applies.
DensityRequest density_request(const SolvedJob& job, const ScatterTask& task, int most = 0);
/// Computes the density that density_request() describes. Figures use this function if the answer
/// does not contain the density.
PatternDensity density_of(const SolvedJob& job, const ScatterAnswer& answer,
                          Progress* progress = nullptr, int most = 0);

/// Converts an error of a function of scatter/ to an error of the spec. If the field of the error
/// is the name of an input, `scatter.` is put before it.
Error of_scatter(const ScatterTask& task, Error error);

/// Returns a view of `answer`. `answer` must outlive the view.
ScatterView scatter_view(const SolvedJob& job, const ScatterAnswer& answer);
std::string scatter_listing(const SolvedJob& job, const ScatterAnswer& answer);
/// Makes a row for each sample, with its inputs and then its results.
std::string scatter_csv(const SolvedJob& job, const ScatterAnswer& answer);

}  // namespace gearwright
