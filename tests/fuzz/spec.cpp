// Interprets any bytes as a spec. Every spec ends in gears, a pair, or an error with a message, and
// never in a crash, a broken contract or an empty message.
#include <nlohmann/json.hpp>

#include "gearwright/job/fit_answer.hpp"
#include "gearwright/job/measures.hpp"
#include "gearwright/job/result_json.hpp"
#include "gearwright/job/solved_job.hpp"
#include "gearwright/spec/json.hpp"
#include "tests/fuzz/fuzzing.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace gearwright;
  using fuzz::require;
  const auto spec = fuzz::spec_of(fuzz::text_of(data, size));
  if (!spec) {
    require(!spec.error().message().empty());
    return 0;
  }
  for (const Scope scope : {Scope::gears, Scope::everything}) {
    const auto job = solve(*spec, scope);
    if (!job) {
      require(!job.error().message().empty() && !job.error().field.empty());
      continue;
    }
    require(!job_record(*job).dump().empty());
    SolvedJob measured = *job;
    const auto measures = measure_gears(measured);
    require(measures ? !measures_record(measured, *measures).dump().empty()
                     : !measures.error().message().empty());
    for (const Gear& gear : job->gears) {
      if (!gear.tooth || !gear.exists()) continue;
      for (const Arc& arc : gear.tooth->outline.arcs) {
        for (const Vec2& p : sample(arc, 5)) require(p.allFinite());
      }
    }
  }
  const auto answer = answer_fit(*spec);
  if (!answer) {
    require(!answer.error().message().empty() && !answer.error().field.empty());
    return 0;
  }
  require(!fit_json(*answer).dump().empty());
  for (const Json& branch : answer->specs) {
    require(bool(read_spec(toml_text(branch), SpecFormat::toml)));  // the branches of fit are specs
  }
  return 0;
}
