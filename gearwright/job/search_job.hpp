// The verb `search` runs a search in memory, or as a campaign that keeps finished chunks on disk.
//
//   trials   0 … N − 1, divided into chunks of equal size      campaign   many chunks and a folder
//
// Chunks are independent, and the files are made from them in order. The result is therefore the
// same for any number of threads, shards or ranks.
#pragma once

#include <atomic>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "gearwright/catalogue/search_quantities.hpp"
#include "gearwright/design/search.hpp"
#include "gearwright/job/campaign.hpp"
#include "gearwright/spec/spec.hpp"

namespace gearwright {

struct SearchProgress {
  enum class Stage {
    trials,   ///< the search itself
    changes,  ///< the search for changes that would give a design, if nothing is feasible; `done`
              ///< counts the evaluated trials
    loads,    ///< the transmission error under load of the best designs; `done` counts the computed
              ///< designs, and `of` counts all of them
    regions   ///< the regions of the listed designs; `done` counts the computed regions, and `of`
              ///< counts all regions
  };
  Stage stage = Stage::trials;
  std::int64_t done = 0, of = 0;
  std::int64_t trials = 0;  ///< trials done by this process
  std::int64_t chunks = 0;  ///< chunks done by all processes, as far as known
  std::int64_t of_chunks = 0;
  std::int64_t left = 0;  ///< trials that remain for this process
};

struct SearchOptions : CampaignOptions {
  bool yes_large = false;
  std::optional<std::size_t> top;      ///< number of designs to keep; by default kDefaultDesigns
  std::optional<std::int64_t> chunk;   ///< number of trials in a chunk; the default depends on the
                                       ///< size of the search
  std::optional<std::size_t> regions;  ///< number of listed designs with regions; by default all
  int threads = 0;                     ///< 0 uses all threads of the machine
  /// This function is called many times a second, by one thread at a time.
  std::function<void(const SearchProgress&)> progress;
  /// If the caller sets this to true, the search ends at once and discards unfinished chunks.
  const std::atomic<bool>* stop = nullptr;
};

/// Default number of designs in a result. Only huge searches have more designs.
inline constexpr std::size_t kDefaultDesigns = 100'000;
/// If a search has more trials than this, it requires yes_large.
inline constexpr double kLargeSearch = 2e10;
/// If a grid of shifts has more points than this, it requires yes_large.
inline constexpr double kManyPoints = 1e8;

/// A search run. The members of SearchView are the result of a finished search.
struct SearchRun : SearchView {
  bool finished = false;  ///< true if all chunks are done and this process has the result
  bool stopped = false;   ///< true if SearchOptions::stop ended the run
  std::int64_t chunks_done = 0, chunks = 0;
  std::string changes_left_out;            ///< reason why only some changes were searched; may be
                                           ///< empty
  std::vector<std::string> changes_tried;  ///< members that were changed in the search for changes
  std::vector<std::string> notes;          ///< repairs that were made in the folder
  bool pair_not_read = false;              ///< true if the spec has a [pair], which a search does
                                           ///< not use
  bool teeth_not_read = false;   ///< true if [gear1] or [gear2] has a number of teeth, which a
                                 ///< search does not use
  bool rating_not_read = false;  ///< true if the spec has a [rating], which this search does not
                                 ///< use
  std::vector<std::filesystem::path> files;
};

/// Returns a run that has not started. It records the parts of the spec that the search ignores.
SearchRun begun(const JobSpec& spec, const Search& search);

/// Greatest number of chunks of a search. A folder and its list cannot hold more.
inline constexpr std::int64_t kMaxChunks = 1'000'000;

/// Throws    IoError
/// Errors    the errors of refuse_folder(), refuse_large() and run_campaign(); --out if the folder
///           contains a finished search of another spec; --shard or --resume without --out;
///           `search.ratio` if no numbers of teeth give the ratio; `search` if there are more
///           chunks than kMaxChunks
Result<SearchRun> run_search(const JobSpec& spec, const Search& search,
                             const SearchOptions& options);

/// Returns the error --yes-large if the search has more than kLargeSearch trials, or
/// `search.shift_step` if its grid has too many points. SearchOptions::yes_large permits both. A
/// number of trials that does not fit into 64 bits is always the error `search`. The message about
/// the trials contains a duration, for which the speed is measured for half a second. The points of
/// a grid are estimated.
std::optional<Error> refuse_large(const Search& search, const SearchOptions& options);

Error no_search();
Error no_tooth_numbers();

/// Determines when regions are computed. If the ranking or a table of all designs needs them, they
/// are computed at once. Otherwise, only the regions of the listed designs are computed, at the
/// end.
RegionDetail detail_of(const SearchProblem& problem, bool files);

/// Returns all inputs that determine the result, as lines "key = value". `more` names further
/// tables of the spec. They do not affect a search, but they affect the study for which the lines
/// are made.
std::string search_fingerprint(const JobSpec& spec, std::int64_t chunk,
                               const std::vector<std::string>& more = {});

}  // namespace gearwright
