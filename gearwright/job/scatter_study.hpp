// A study: the scatter of every design of a search, ranked by a percentile of the transmission error.
//
//   N   rank of a design in the search, as in `search --take N`
//
// The row of a design contains the numbers of `scatter` for the spec that `search --take N` prints,
// bit for bit. Rows do not depend on each other, so a study is cut into chunks of designs like a
// search into chunks of trials, with a folder, shards and ranks. Internal to job/ and the programs.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "gearwright/base/progress.hpp"
#include "gearwright/job/chunk_queue.hpp"
#include "gearwright/job/search_job.hpp"
#include "gearwright/spec/json.hpp"

namespace gearwright {

/// A design of a list.
struct ListedDesign {
  std::int64_t number;  ///< N
  std::int64_t trial;
  /// Teeth in the file of the list, by which a file of another search is recognised.
  std::optional<std::array<int, 2>> teeth{};
};

struct StudyOptions : CampaignOptions {
  std::optional<std::string> designs;  ///< file or folder of a search
  std::vector<ListedDesign> list;      ///< designs that are known; without both, the search is run
  std::filesystem::path folder;        ///< of the spec, for the files that it names
  std::optional<std::size_t> top;      ///< designs of the list; by default all
  int threads = 0;                     ///< with 0, as many as the machine has
  Progress* progress = nullptr;        ///< of the samples of one design
  /// Receives the number of finished designs, of all; called before each design and at the end.
  std::function<void(std::int64_t done, std::int64_t of)> on_design;
};

struct StudyRun {
  bool finished = false;      ///< true if all rows are there and this process made the files
  std::vector<Json> designs;  ///< ranked rows; scattered_design_quantities
  std::vector<Json> refused;  ///< rows without a scatter, in the order of the list
  std::int64_t done = 0, of = 0;
  std::vector<std::string> notes;  ///< repairs in the folder
  std::vector<std::filesystem::path> files;
};

/// The row of one design.
///
/// Throws    WorkStopped
/// Errors    "--designs" if the search of the spec does not have the design; an error of [scatter],
///           which concerns all designs. A failure that concerns this design only is a row.
Result<Json> study_row(const JobSpec& spec, const Search& search, const ListedDesign& design,
                       const StudyOptions& options);

/// Computes the rows of this process, and ranks them when none is missing.
///
/// Domain    a spec with [search] (contract)
/// Throws    IoError, WorkStopped
/// Errors    as listed_designs(), study_row() and run_search(); "--out" of another study
/// Laws      (1) the same rows and files with any threads, shards and ranks
Result<StudyRun> run_study(const JobSpec& spec, const StudyOptions& options);

/// Throws    IoError
std::string text_of_file(const std::filesystem::path& path);

/// Index of the greatest of the requested percentiles, by which the designs are ranked.
std::size_t ranking_percentile(const JobSpec& spec);

/// True if the design of the row loses contact in more samples than this percentile leaves out.
bool loses_contact(const JobSpec& spec, const Json& row);

/// Ranks the rows. A row that loses contact in more samples than the percentile leaves out comes after
/// all others. Within each group, the rows are sorted by the percentile, then by N. Rows without a
/// scatter are moved to `refused`.
void rank_rows(const JobSpec& spec, std::vector<Json> rows, StudyRun& run);

/// The whole result as text, one design per line.
std::string study_json_text(const JobSpec& spec, const StudyRun& run);
/// The result of a study that has not finished.
Json unfinished_study(const StudyRun& run);
std::string study_listing(const JobSpec& spec, const StudyRun& run, std::size_t most);
/// A row for each design, refused ones at the end.
std::string study_csv(const JobSpec& spec, const StudyRun& run);
/// The page of the study.
std::string study_page(const JobSpec& spec, const StudyRun& run);

/// Designs in the table for users.
inline constexpr std::size_t kListedStudy = 40;

}  // namespace gearwright
