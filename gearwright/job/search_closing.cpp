#include "gearwright/job/search_closing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <mutex>

#include "gearwright/base/parallel.hpp"
#include "gearwright/catalogue/spelling.hpp"

namespace gearwright {

namespace {

// The keys of these members in backticks: `a`, `b`.
std::string spelled_list(const std::vector<std::string>& fields) {
  std::string text;
  for (const std::string& field : fields)
    text += (text.empty() ? "`" : ", `") + spelled_member("search." + field) + "`";
  return text;
}

}  // namespace

bool look_for_changes(const Search& search, const SearchOptions& options, SearchRun& run) {
  if (run.answer.counts.feasible > 0) return true;
  if (*search.space().size() > kMaxForChange) {
    run.changes_left_out = fmt::format(
        "the smallest change that would help is not searched if there are more than {} candidates",
        kMaxForChange);
    return true;
  }
  SearchProgress progress{.stage = SearchProgress::Stage::changes};
  // Fewer candidates are evaluated if drawings are checked, because checking a drawing takes
  // milliseconds.
  constexpr std::int64_t kMaxDrawn = 300;
  const std::int64_t most = search.problem().draw ? kMaxDrawn : kMaxChangeQuestions;
  auto found = nearest_changes(
      search.problem(),
      [&](std::int64_t questions) {
        progress.done += questions;
        if (options.progress) options.progress(progress);
        return !(options.stop && *options.stop);
      },
      most);
  run.stopped = found.stopped;
  run.changes = std::move(found.changes);
  if (found.safest) run.safest = search.whole(*found.safest);
  if (!found.bounded.empty()) {
    run.changes_left_out = fmt::format(
        "the search for the smallest change of {} ended after {} trials for each key, so a smaller "
        "change may exist",
        spelled_list(found.bounded), most);
  }
  return !run.stopped;
}

bool complete_regions(const Search& search, const SearchOptions& options, SearchRun& run) {
  auto& designs = run.answer.designs;
  const std::size_t most = std::min(designs.size(), options.regions.value_or(designs.size()));
  std::mutex mutex;
  std::atomic<std::int64_t> done{0};
  const auto stopped = [&] { return options.stop && *options.stop; };
  const auto complete = [&](std::size_t i) {
    if (stopped()) return;
    if (!designs[i].whole) designs[i] = search.whole(designs[i]);
    ++done;
    if (!options.progress) return;
    if (const std::unique_lock lock(mutex, std::try_to_lock); lock) {
      options.progress({.stage = SearchProgress::Stage::regions,
                        .done = done,
                        .of = static_cast<std::int64_t>(most)});
    }
  };
  parallel_for(most, complete, options.threads);
  run.stopped = run.stopped || stopped();
  return !run.stopped;
}

}  // namespace gearwright
