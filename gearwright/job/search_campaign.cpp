#include <fmt/format.h>

#include <algorithm>

#include "gearwright/base/system.hpp"
#include "gearwright/job/loaded_designs.hpp"
#include "gearwright/job/search_files.hpp"
#include "gearwright/job/search_workers.hpp"
#include "gearwright/store/chunk_store.hpp"
#include "gearwright/store/parquet.hpp"

namespace gearwright {

namespace {

// Returns the counts of a chunk. `rejected` contains the number of trials that each limit rejected,
// followed by the numbers of tested and of feasible grid points, and by the number of trials for
// each finding of the verdict. count_names() has the same order.
ChunkCounts as_chunk(const SearchCounts& c) {
  ChunkCounts chunk{c.tested, c.feasible, {c.rejected.begin(), c.rejected.end()}};
  chunk.rejected.push_back(c.points_tested);
  chunk.rejected.push_back(c.points_feasible);
  chunk.rejected.insert(chunk.rejected.end(), c.findings.begin(), c.findings.end());
  return chunk;
}

SearchCounts as_search(const ChunkCounts& c) {
  SearchCounts counts{.tested = c.tested,
                      .feasible = c.feasible,
                      .points_tested = c.rejected[kLimits],
                      .points_feasible = c.rejected[kLimits + 1]};
  std::copy_n(c.rejected.begin(), kLimits, counts.rejected.begin());
  std::copy_n(c.rejected.begin() + kLimits + 2, kWarningCodes, counts.findings.begin());
  return counts;
}

std::vector<std::string> count_names() {
  std::vector<std::string> names;
  for (int i = 0; i < kLimits; ++i) names.emplace_back(name(static_cast<Limit>(i)));
  names.insert(names.end(), {"points_tested", "points_feasible"});
  for (const WarningMeaning& finding : warning_meanings())
    names.push_back(fmt::format("verdict_{}", finding.text));
  return names;
}

}  // namespace

std::optional<Error> refuse_other_search(const std::filesystem::path& folder, const JobSpec& spec) {
  const auto was = parquet_note(folder / kDesignsFile, kSpecNote);
  if (!was) return std::nullopt;
  const auto old = read_spec(*was, SpecFormat::json);
  constexpr std::int64_t kAnyChunk = 0;  // the same for both specs; results do not depend on the
                                         // chunk size
  std::string changed = "the spec of that search belongs to another version";
  if (old) {
    const std::string before = search_fingerprint(*old, kAnyChunk);
    const std::string now = search_fingerprint(spec, kAnyChunk);
    if (before == now) return std::nullopt;
    changed = campaign_differences(before, now);
  }
  return Error{
      "--out", native_text(folder),
      fmt::format("the folder contains a finished search with another spec ({}), and the files of "
                  "that search would be replaced; use another folder, or remove {} first",
                  changed, kDesignsFile),
      FailureKind::option};
}

Result<SearchRun> run_campaign(const JobSpec& spec, const Search& search, std::int64_t chunk,
                               const SearchOptions& options) {
  SearchRun run = begun(spec, search);
  run.chunks = (*search.space().size() + chunk - 1) / chunk;
  const auto other =
      ChunkStore::is_in(options.out) ? std::nullopt : refuse_other_search(options.out, spec);
  auto opened =
      open_campaign({search_fingerprint(spec, chunk), run.chunks}, count_names(), options, other);
  if (!opened) return opened.error();
  std::optional<ChunkStore> joined = std::move(opened).take();
  if (!joined) return run;
  ChunkStore store = *std::move(joined);
  run.notes = store.notes();
  SearchWorkers workers(search, chunk, own_chunks(store, options), options);
  workers.run([&](std::int64_t c, const ChunkFinds& finds, const SearchCounts& n) {
    store.put(c, pack(finds), as_chunk(n));
  });
  run.stopped = workers.stopped();
  const bool ours = options.finish_together ? options.finish_together() : true;
  const auto missing = store.missing();
  run.chunks_done = run.chunks - static_cast<std::int64_t>(missing.size());
  if (!ours || !missing.empty()) return run;

  BestDesigns best(search.problem(),
                   designs_to_keep(search.problem(), options.top.value_or(kDefaultDesigns)));
  const auto finds_of = [&](std::int64_t c) {
    return unpack(store.get(c), fmt::format("chunk {} in {}", c, native_text(options.out)));
  };
  for (std::int64_t c = 0; c < run.chunks; ++c)
    for (const DesignRow& row : finds_of(c).designs) best.add(row);
  run.answer = std::move(best).answer(as_search(store.totals()));
  if (!load_designs(spec, search, options, run)) return run;
  if (!look_for_changes(search, options, run)) return run;
  run.finished = true;
  std::int64_t at = 0;
  run.files =
      write_search_files(spec, search, run, options.out, options.top, [&](ChunkFinds& finds) {
        if (at == run.chunks) return false;
        finds = finds_of(at++);
        return true;
      });
  return run;
}

}  // namespace gearwright
