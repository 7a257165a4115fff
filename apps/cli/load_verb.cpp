#include <nlohmann/json.hpp>

#include "apps/cli/door.hpp"
#include "apps/cli/verbs.hpp"
#include "apps/common/speaking.hpp"
#include "apps/common/watch.hpp"
#include "gearwright/job/csv_answer.hpp"
#include "gearwright/job/judgement.hpp"
#include "gearwright/job/listing.hpp"
#include "gearwright/job/load_text.hpp"

namespace gearwright::cli {

int load_verb(const Options& o) {
  Door door(o);
  auto solved = door.solve(Scope::everything, SpecUse::load);
  if (!solved) return door.fail(solved.error());
  SolvedJob job = std::move(solved).take();
  const auto answer = [&] {
    Watch watch("load");
    return answer_load(job, watch.headway());
  }();
  if (!answer) return door.fail(answer.error());
  const Verdict verdict = judge(job, {.load = true});
  if (o.csv) {
    print(load_csv(*answer));
  } else if (o.json) {
    print_json(load_json(job, *answer, verdict));
  } else {
    print(load_listing(job, *answer) + warning_listing(job.warnings) + verdict_listing(verdict));
  }
  return o.strict && verdict.level != Level::green ? 4 : 0;
}

}  // namespace gearwright::cli
