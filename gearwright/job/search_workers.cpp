#include "gearwright/job/search_workers.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "gearwright/arrange/judge.hpp"
#include "gearwright/base/lists.hpp"
#include "gearwright/base/parallel.hpp"
#include "gearwright/catalogue/spelling.hpp"
#include "gearwright/design/design_strength.hpp"

namespace gearwright {

SearchWorkers::SearchWorkers(const Search& search, std::int64_t chunk,
                             std::vector<std::int64_t> todo, const SearchOptions& options)
    : search_(search),
      chunk_(chunk),
      options_(options),
      queue_(std::move(todo), (*search.space().size() + chunk - 1) / chunk, options.next_chunk) {
  progress_.of_chunks = (*search.space().size() + chunk - 1) / chunk;
  progress_.chunks = progress_.of_chunks - static_cast<std::int64_t>(queue_.todo().size());
  for (const std::int64_t c : queue_.todo()) progress_.left += trials_of(c);
}

void SearchWorkers::run(const Done& done) {
  const int threads = thread_count(options_.threads);
  parallel_for(
      static_cast<std::size_t>(threads), [&](std::size_t) { work(done); }, threads);
}

void SearchWorkers::work(const Done& done) {
  unsigned calls = 0;
  const SearchWatch watch = [&](std::int64_t trials) {
    trials_done_ += trials;
    if (stopped()) return false;
    constexpr unsigned kSeldom = 16;  // to save time, only every 16th call without finished trials
                                      // reports the progress
    if (trials > 0 || calls++ % kSeldom == 0) report_progress();
    return true;
  };
  while (!stopped()) {
    const auto c = queue_.next();
    if (!c) return;
    ChunkFinds finds;
    const std::int64_t from = *c * chunk_;
    // The grid points are computed even if no file needs them, because every result contains the
    // number of grid points.
    const SearchCounts counts =
        search_.range(from, from + trials_of(*c), finds.designs,
                      {.detail = detail_of(search_.problem(), !options_.out.empty()),
                       .points = &finds.points,
                       .watch = watch});
    if (stopped()) return;  // a chunk is saved completely or not at all
    done(*c, std::move(finds), counts);
    ++chunks_done_;
    report_progress();
  }
}

void SearchWorkers::report_progress() {
  if (!options_.progress) return;
  const std::unique_lock lock(mutex_, std::try_to_lock);
  if (!lock) return;
  SearchProgress now = progress_;
  now.chunks += chunks_done_;
  now.trials = trials_done_;
  now.left -= std::min(now.left, now.trials);
  options_.progress(now);
}

std::int64_t SearchWorkers::trials_of(std::int64_t c) const {
  return std::min(chunk_, *search_.space().size() - c * chunk_);
}

namespace {

// Returns the keys of these members in backticks: `a`, `b`. Several members may have the same key,
// such as both limits of the profile shifts.
std::string spelled_list(const std::vector<std::string>& fields) {
  std::vector<std::string> keys;
  for (const std::string& field : fields)
    add_once(keys, "`" + spelled_member("search", field).key + "`");
  return fmt::format("{}", fmt::join(keys, ", "));
}

// Returns the reason that rejects the drawing of a design, in words.
std::string finding_words(const SearchProblem& problem, const DesignRow& row) {
  const auto found = finding_of_drawing(problem, row);
  if (!found) {
    const Error error = spelled(found.error());
    return fmt::format("The pair cannot be drawn. {}{}{}.", error.field,
                       error.field.empty() ? "" : ": ", error.rule);
  }
  return *found ? (*found)->named() : "The drawn pair cannot be rated.";
}

}  // namespace

bool look_for_changes(const Search& search, const SearchOptions& options, SearchRun& run) {
  if (run.answer.counts.feasible > 0) return true;
  if (*search.space().size() > kMaxForChange) {
    run.changes_left_out = fmt::format(
        "the smallest change that would help is searched for only if there are at most {} "
        "candidates",
        kMaxForChange);
    return true;
  }
  SearchProgress progress{.stage = SearchProgress::Stage::changes};
  // If drawings are checked, fewer candidates are evaluated, because the check of a drawing takes
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
  run.changes_tried = std::move(found.tried);
  if (found.safest) {
    run.safest = search.whole(*found.safest);
    if (short_of(search.problem(), *run.safest) == Limit::verdict)
      run.safest_finding = finding_words(search.problem(), *run.safest);
  }
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
