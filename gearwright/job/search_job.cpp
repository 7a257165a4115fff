#include "gearwright/job/search_job.hpp"

#include <fmt/format.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <map>
#include <mutex>
#include <nlohmann/json.hpp>
#include <numeric>

#include "gearwright/base/version.hpp"
#include "gearwright/catalogue/spelling.hpp"
#include "gearwright/job/search_files.hpp"
#include "gearwright/job/search_record.hpp"
#include "gearwright/job/search_refusal.hpp"
#include "gearwright/spec/table_reader.hpp"
#include "gearwright/store/chunk_store.hpp"

namespace gearwright {

namespace {

constexpr std::int64_t kMinChunk = 1 << 18;
constexpr std::int64_t kShare = 1 << 16;     // of a thread at a time, where no file is made of it
constexpr std::int64_t kMaxChunk = 1 << 22;  // a thread holds the designs of one

void flatten(const Json& node, const std::string& path, std::string& lines) {
  if (node.is_object()) {
    for (const auto& [key, value] : node.items())
      flatten(value, path.empty() ? key : path + "." + key, lines);
    return;
  }
  lines += path + " = " + json_text(node) + "\n";
}

// The store's counts by name: the limits, then the points of the grid.
ChunkCounts as_chunk(const SearchCounts& c) {
  ChunkCounts chunk{c.tested, c.feasible, {c.rejected.begin(), c.rejected.end()}};
  chunk.rejected.push_back(c.points_tested);
  chunk.rejected.push_back(c.points_feasible);
  return chunk;
}

SearchCounts as_search(const ChunkCounts& c) {
  SearchCounts counts{c.tested, c.feasible, {}, c.rejected[kLimits], c.rejected[kLimits + 1]};
  std::copy_n(c.rejected.begin(), kLimits, counts.rejected.begin());
  return counts;
}

std::vector<std::string> count_names() {
  std::vector<std::string> names;
  for (int i = 0; i < kLimits; ++i) names.emplace_back(name(static_cast<Limit>(i)));
  names.insert(names.end(), {"points_tested", "points_feasible"});
  return names;
}

// Chunks done by all threads of this process; each is handed on as soon as it is done.
class Workers {
 public:
  Workers(const Search& search, std::int64_t chunk, std::vector<std::int64_t> todo,
          const SearchOptions& options)
      : search_(search), chunk_(chunk), todo_(std::move(todo)), options_(options) {
    progress_.of_chunks = (*search.space().size() + chunk - 1) / chunk;
    progress_.chunks = progress_.of_chunks - static_cast<std::int64_t>(todo_.size());
    for (const std::int64_t c : todo_) progress_.left += trials_of(c);
  }

  template <class Done>
  void run(const Done& done) {
    const int threads = thread_count(options_);
    tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                              static_cast<std::size_t>(threads));
    tbb::parallel_for(0, threads, [&](int) {
      unsigned asked = 0;
      const SearchWatch watch = [&](std::int64_t trials) {
        trials_done_ += trials;
        if (stopped()) return false;
        constexpr unsigned kSeldom = 16;  // graphs: a look at the clock is no part of their cost
        if (trials > 0 || asked++ % kSeldom == 0) tell();
        return true;
      };
      while (const auto c = next()) {
        ChunkFinds finds;
        const std::int64_t from = *c * chunk_;
        // Points are wanted for the files alone; their counts are in the answer of every search.
        const SearchCounts counts =
            search_.range(from, from + trials_of(*c), finds.designs,
                          {.detail = detail_of(search_.problem(), !options_.out.empty()),
                           .points = &finds.points,
                           .watch = watch});
        if (stopped()) return;  // a chunk is whole or not there
        done(*c, std::move(finds), counts);
        ++chunks_done_;
        tell();
      }
    });
  }
  bool stopped() const { return options_.stop && *options_.stop; }

 private:
  void tell() {
    if (!options_.progress) return;
    const std::unique_lock lock(mutex_, std::try_to_lock);
    if (!lock) return;
    SearchProgress now = progress_;
    now.chunks += chunks_done_;
    now.trials = trials_done_;
    now.left -= std::min(now.left, now.trials);
    options_.progress(now);
  }
  std::int64_t trials_of(std::int64_t c) const {
    return std::min(chunk_, *search_.space().size() - c * chunk_);
  }
  std::optional<std::int64_t> next() {
    if (stopped()) return std::nullopt;
    const std::lock_guard lock(queue_mutex_);
    if (options_.next_chunk) {
      // What was missing when the folder was opened, whoever opened it when.
      std::int64_t c = options_.next_chunk();
      while (c < progress_.of_chunks && !std::binary_search(todo_.begin(), todo_.end(), c))
        c = options_.next_chunk();
      return c < progress_.of_chunks ? std::optional(c) : std::nullopt;
    }
    if (place_ == todo_.size()) return std::nullopt;
    return todo_[place_++];
  }

  const Search& search_;
  std::int64_t chunk_;
  std::vector<std::int64_t> todo_;
  const SearchOptions& options_;
  std::size_t place_ = 0;
  std::mutex queue_mutex_, mutex_;
  SearchProgress progress_;  // as it was at the start
  std::atomic<std::int64_t> trials_done_{0}, chunks_done_{0};
};

// The program's names of some members, `a`, `b`.
std::string spelled_list(const std::vector<std::string>& fields) {
  std::string text;
  for (const std::string& field : fields)
    text += (text.empty() ? "`" : ", `") + spelled_member("search." + field) + "`";
  return text;
}

// Nothing is feasible: what would help. Whether to go on.
bool look_for_changes(const Search& search, const SearchOptions& options, SearchRun& run) {
  if (run.answer.counts.feasible > 0) return true;
  if (*search.space().size() > kMaxForChange) {
    run.changes_left_out = fmt::format(
        "with more than {} candidates the nearest change is not looked for", kMaxForChange);
    return true;
  }
  SearchProgress progress{.stage = SearchProgress::Stage::changes};
  auto found = nearest_changes(search.problem(), [&](std::int64_t questions) {
    progress.done += questions;
    if (options.progress) options.progress(progress);
    return !(options.stop && *options.stop);
  });
  run.stopped = found.stopped;
  run.changes = std::move(found.changes);
  if (!found.bounded.empty()) {
    run.changes_left_out = fmt::format(
        "the smallest change of {} was looked for with {} questions to candidates "
        "each; with more of them it may be smaller, or there may be one",
        spelled_list(found.bounded), kMaxChangeQuestions);
  }
  return !run.stopped;
}

// The regions of the designs that are listed. Whether to go on.
bool complete_regions(const Search& search, const SearchOptions& options, SearchRun& run) {
  auto& designs = run.answer.designs;
  const std::size_t most = std::min(designs.size(), options.regions.value_or(designs.size()));
  std::mutex mutex;
  std::atomic<std::int64_t> done{0};
  const auto stopped = [&] { return options.stop && *options.stop; };
  tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                            static_cast<std::size_t>(thread_count(options)));
  tbb::parallel_for(std::size_t{0}, most, [&](std::size_t i) {
    if (stopped()) return;
    if (!designs[i].whole) designs[i] = search.whole(designs[i]);
    ++done;
    if (!options.progress) return;
    if (const std::unique_lock lock(mutex, std::try_to_lock); lock) {
      options.progress({.stage = SearchProgress::Stage::regions,
                        .done = done,
                        .of = static_cast<std::int64_t>(most)});
    }
  });
  run.stopped = run.stopped || stopped();
  return !run.stopped;
}

// All in memory: small searches, and those that leave no files.
SearchRun run_in_memory(const JobSpec& spec, const Search& search, std::int64_t chunk,
                        const SearchOptions& options) {
  SearchRun run;
  run.pair_not_read = parse_json(spec.tree).contains("pair");
  run.chunks = (*search.space().size() + chunk - 1) / chunk;
  std::vector<std::int64_t> todo(static_cast<std::size_t>(run.chunks));
  std::iota(todo.begin(), todo.end(), 0);
  BestDesigns best(search.problem(), options.top.value_or(kDefaultDesigns));
  SearchCounts counts;
  std::map<std::int64_t, ChunkFinds> all;  // for the files
  std::mutex mutex;
  Workers workers(search, chunk, std::move(todo), options);
  workers.run([&](std::int64_t c, ChunkFinds finds, const SearchCounts& n) {
    const std::lock_guard lock(mutex);
    counts += n;
    for (const DesignRow& row : finds.designs) best.add(row);
    if (!options.out.empty()) all.emplace(c, std::move(finds));
    ++run.chunks_done;
  });
  run.stopped = workers.stopped();
  if (run.stopped) return run;
  run.answer = std::move(best).answer(counts);
  if (!complete_regions(search, options, run)) return run;
  if (!look_for_changes(search, options, run)) return run;
  run.finished = true;
  if (!options.out.empty()) {
    auto at = all.begin();
    run.files =
        write_search_files(spec, search, run, options.out, options.top, [&](ChunkFinds& finds) {
          if (at == all.end()) return false;
          finds = std::move((at++)->second);
          return true;
        });
  }
  return run;
}

Result<SearchRun> run_campaign(const JobSpec& spec, const Search& search, std::int64_t chunk,
                               const SearchOptions& options) {
  SearchRun run;
  run.pair_not_read = parse_json(spec.tree).contains("pair");
  run.chunks = (*search.space().size() + chunk - 1) / chunk;
  // Ranks restarted by a scheduler say --resume always: they go on with whatever is there.
  const bool first = !options.many;
  if (options.folder_is_open && !first && !options.folder_is_open(true)) return run;
  const OpenAs as = options.many || (options.together && options.resume) ? OpenAs::join
                    : options.resume                                     ? OpenAs::resume
                                                                         : OpenAs::fresh;
  auto opened = ChunkStore::open(options.out, {search_fingerprint(spec, chunk), run.chunks},
                                 count_names(), as, options.writer);
  if (options.folder_is_open && first) options.folder_is_open(static_cast<bool>(opened));
  if (!opened) return opened.error();
  ChunkStore store = std::move(opened).take();
  run.notes = store.notes();
  std::vector<std::int64_t> todo = store.missing();
  if (!options.next_chunk) {
    std::erase_if(todo, [&](std::int64_t c) { return c % options.shards != options.shard - 1; });
  }
  Workers workers(search, chunk, std::move(todo), options);
  workers.run([&](std::int64_t c, const ChunkFinds& finds, const SearchCounts& n) {
    store.put(c, pack(finds), as_chunk(n));
  });
  run.stopped = workers.stopped();
  const bool ours = options.finish_together ? options.finish_together() : true;
  const auto missing = store.missing();
  run.chunks_done = run.chunks - static_cast<std::int64_t>(missing.size());
  if (!ours || !missing.empty()) return run;

  BestDesigns best(search.problem(), options.top.value_or(kDefaultDesigns));
  const auto finds_of = [&](std::int64_t c) {
    return unpack(store.get(c), fmt::format("chunk {} in {}", c, options.out.string()));
  };
  for (std::int64_t c = 0; c < run.chunks; ++c)
    for (const DesignRow& row : finds_of(c).designs) best.add(row);
  run.answer = std::move(best).answer(as_search(store.totals()));
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

}  // namespace

std::int64_t chunk_size(const SearchProblem& problem, std::int64_t trials) {
  constexpr std::int64_t kChunks = 4096;
  const std::int64_t size = std::clamp((trials + kChunks - 1) / kChunks, kMinChunk, kMaxChunk);
  if (!problem.shift_step) return size;
  // A region has about one square module: so many points of the grid fit into memory.
  constexpr double kPoints = 5e4;
  const double step = *problem.shift_step;
  return std::clamp<std::int64_t>(static_cast<std::int64_t>(kPoints * step * step), 1, size);
}

std::string search_fingerprint(const JobSpec& spec, std::int64_t chunk) {
  const Json tree = parse_json(spec.tree);
  std::string lines;
  for (const char* table : {"search", "gear1", "gear2"})
    if (tree.contains(table)) flatten(tree[table], table, lines);
  lines += fmt::format("trials of a chunk = {}\nversion = {}\n", chunk, kVersion);
  return lines;
}

Result<SearchRun> run_search(const JobSpec& spec, const Search& search,
                             const SearchOptions& options) {
  if (options.out.empty() && (options.resume || options.shards > 1)) {
    const std::string flag = options.resume ? "--resume" : "--shard";
    return Error{flag, "", "needs --out DIR, the folder of the search"};
  }
  if (auto error = refuse_large(search, options)) return *error;
  const std::int64_t trials = *search.space().size();
  const double chunks =
      std::ceil(static_cast<double>(trials) /
                static_cast<double>(options.chunk.value_or(chunk_size(search.problem(), trials))));
  if (chunks > kMaxChunks) {
    return Error{
        "search", fmt::format("{:.3g}", static_cast<double>(trials)),
        fmt::format("so many candidates in {:.3g} chunks are more than one search can keep account "
                    "of, at most {}; split the list of modules or the band of `pinion_teeth` among "
                    "several searches{}",
                    chunks, kMaxChunks, options.chunk ? ", or take a larger --chunk" : "")};
  }
  if (trials == 0) {
    return Error{"search.ratio", "",
                 "no tooth numbers within `pinion_teeth` have such a ratio; widen one of the two "
                 "bands"};
  }
  const std::int64_t chunk = options.chunk.value_or(chunk_size(search.problem(), trials));
  const bool campaign =
      !options.out.empty() &&
      (trials > chunk || options.many || options.together || options.resume || options.chunk);
  return campaign
             ? run_campaign(spec, search, chunk, options)
             : Result<SearchRun>(run_in_memory(spec, search, std::min(chunk, kShare), options));
}

}  // namespace gearwright
