// The verbs that compute a result for solved gears. The table of the verbs, `run`, Python and the
// page find, judge and describe such a result by the same functions.
// Internal to job/ and the programs.
#pragma once

#include <nlohmann/json.hpp>

#include "gearwright/job/compensate_answer.hpp"
#include "gearwright/job/contact_answer.hpp"
#include "gearwright/job/load_answer.hpp"
#include "gearwright/job/propose_answer.hpp"
#include "gearwright/job/result_json.hpp"
#include "gearwright/job/scatter_answer.hpp"

namespace gearwright {

/// Returns the table of the quantities.
template <const auto& (*quantities)()>
const QuantityTable& quantities_table() {
  return quantities().table();
}

/// The functions of a verb whose result is a Found.
template <class Found>
struct Analysis {
  Scope scope;
  Result<Found> (*find)(SolvedJob& job, Progress* progress);  ///< may add warnings to the job
  Verdict (*judge)(const SolvedJob& job, const Found& found);
  /// The quantities of the result, whose name is its key, and their values. They are null if the
  /// verb returns only the gears and the pair.
  const QuantityTable& (*table)() = nullptr;
  ValueRecord (*record)(const SolvedJob& job, const Found& found) = nullptr;
};

extern const Analysis<ContactAnswer> kContactAnalysis;
extern const Analysis<CompensateAnswer> kCompensateAnalysis;
extern const Analysis<ProposeAnswer> kProposeAnalysis;
extern const Analysis<ScatterAnswer> kScatterAnalysis;
extern const Analysis<LoadAnalysis> kLoadAnalysis;
extern const Analysis<RatingAnswer> kRatingAnalysis;

/// Returns the title of the spec, and the quantities of the result under the name of their table.
template <class Found>
Json titled_record(const Analysis<Found>& how, const SolvedJob& job, const Found& found) {
  return titled_record(job.spec, how.table().name.c_str(), how.record(job, found));
}

}  // namespace gearwright
