// Interprets any bytes as a spec with [search]. Small searches run to their end, and their designs
// are read back and mounted. Large ones are skipped.
#include <nlohmann/json.hpp>

#include "gearwright/job/search_answer.hpp"
#include "gearwright/job/solved_job.hpp"
#include "gearwright/spec/json.hpp"
#include "tests/fuzz/fuzzing.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace gearwright;
  using fuzz::require;
  const auto spec = fuzz::spec_of(fuzz::text_of(data, size));
  if (!spec || !spec->search) return 0;
  SearchProblem problem = *spec->search;
  problem.loaded_designs = 0;  // each of them takes seconds
  const Search search(problem);
  constexpr std::int64_t kMost = 300;
  const auto trials = search.space().size();
  if (!trials || *trials > kMost) return 0;
  SearchOptions options;
  options.threads = 1;
  const auto run = run_search(*spec, search, options);
  if (!run) {
    require(!run.error().message().empty() && !run.error().field.empty());
    return 0;
  }
  require(!search_json_text(search, *run).empty());
  require(!search_listing(search, *run, spec->units()).empty());
  for (std::size_t i = 0; i < run->answer.designs.size() && i < 3; ++i) {
    const Json pair = pair_spec(*spec, search, run->answer.designs[i]);
    const auto again = read_spec(toml_text(pair), SpecFormat::toml);
    require(bool(again));
    require(bool(solve(*again, Scope::pair)));
  }
  return 0;
}
