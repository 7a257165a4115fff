#include "gearwright/job/rack_answer.hpp"

#include <memory>

#include "gearwright/base/contract.hpp"
#include "gearwright/job/csv_answer.hpp"
#include "gearwright/job/judgement.hpp"
#include "gearwright/job/listing.hpp"
#include "gearwright/job/result_json.hpp"

namespace gearwright {

Result<Answer> answer_rack(const JobSpec& spec) {
  GW_EXPECTS(spec.rack.has_value());
  auto solved = solve_any(spec, Scope::gears);
  if (!solved) return solved.error();
  const auto job = std::make_shared<const SolvedJob>(std::move(solved).take());
  Answer answer;
  answer.record = job_record(*job);
  answer.warnings = job->warnings;
  answer.verdict = judge(*job);
  answer.listing = [job] { return gear_listing(*job) + pair_listing(*job); };
  answer.csv = [job] { return rack_csv(job->gears[0], *job->rack); };
  return answer;
}

}  // namespace gearwright
