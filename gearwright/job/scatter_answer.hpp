// The effect of tolerances on the pair of a spec: the verb `scatter`. Internal to job/ and the
// program.
#pragma once

#include <string>

#include "gearwright/job/job_contact.hpp"
#include "gearwright/scatter/scatter.hpp"
#include "gearwright/spec/json.hpp"

namespace gearwright {

struct ScatterAnswer {
  ContactSetup setup;
  ScatterTask task;
  Scatter scatter;
};

/// Errors    `scatter.…` for a range that the teeth do not permit, or for a group with an unknown
///           input; as scatter_of() and ContactSetup::of
Result<ScatterAnswer> answer_scatter(SolvedJob& job, Progress* progress = nullptr);

Json scatter_json(const SolvedJob& job, const ScatterAnswer& answer);
std::string scatter_listing(const SolvedJob& job, const ScatterAnswer& answer);
/// A row for each sample: its inputs, then its numbers.
std::string scatter_csv(const SolvedJob& job, const ScatterAnswer& answer);

}  // namespace gearwright
