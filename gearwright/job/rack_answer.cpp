#include "gearwright/job/rack_answer.hpp"

#include <memory>

#include "gearwright/base/contract.hpp"
#include "gearwright/catalogue/rack_pair_quantities.hpp"
#include "gearwright/catalogue/spelling.hpp"
#include "gearwright/job/csv_answer.hpp"
#include "gearwright/job/judgement.hpp"
#include "gearwright/job/listing.hpp"
#include "gearwright/job/result_json.hpp"
#include "gearwright/job/value_json.hpp"

namespace gearwright {

namespace {

struct RackJob {
  SolvedJob job;  ///< of the pinion
  RackPair pair;
};

std::string listing(const RackJob& of) {
  return gear_listing(of.job) + "\nRack\n" +
         quantity_listing(rack_quantities().table(), {rack_quantities().of(of.pair.rack)}, {}) +
         "\nRack and pinion\n" +
         quantity_listing(rack_pair_quantities().table(), {rack_pair_quantities().of(of.pair)}, {});
}

// The verdict on the pinion and on the mesh. Changes of the spec are not tried, so remedies have no
// numbers.
Verdict verdict(const SolvedJob& job) {
  Judged judged;
  judged.gears = {&job.gears[0]};
  judged.warnings = &job.warnings;
  Verdict verdict = verdict_of(judged);
  if (verdict.level == Level::green) verdict.headline = "The rack and pinion run as specified.";
  return verdict;
}

}  // namespace

Result<Answer> answer_rack(const JobSpec& spec) {
  GW_EXPECTS(spec.rack.has_value());
  auto solved = solve(spec, Scope::gears);
  if (!solved) return solved.error();
  SolvedJob job = std::move(solved).take();
  auto pair = mount_rack(job.gears[0], *spec.rack, spec.pair.center_distance, spec.pair.speed_rpm);
  if (!pair) return spelled(pair.error(), spec.given);
  job.warnings.insert(job.warnings.end(), pair->warnings.begin(), pair->warnings.end());
  Answer answer;
  answer.record = job_record(job);
  answer.record["gears"].push_back(to_json(rack_quantities().of(pair->rack)));
  answer.record["pair"] = to_json(rack_pair_quantities().of(*pair));
  answer.warnings = job.warnings;
  answer.verdict = verdict(job);
  const auto state =
      std::make_shared<const RackJob>(RackJob{std::move(job), std::move(pair).take()});
  answer.listing = [state] { return listing(*state); };
  answer.csv = [state] { return rack_csv(state->job.gears[0], state->pair); };
  return answer;
}

}  // namespace gearwright
