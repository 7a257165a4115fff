// Runs a study, which computes the scatter of every design of a search and ranks the designs by a
// percentile of the transmission error.
//
//   N   rank of a design in the search, as in `search --take N`
//
// The row of a design contains exactly the numbers of `scatter` for the spec that `search --take N`
// prints. Rows do not depend on each other, so a study can be divided into chunks of designs. It
// uses a folder, shards and ranks as a search does. Internal to job/ and the programs.
#pragma once

#include <array>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "gearwright/base/progress.hpp"
#include "gearwright/job/search_job.hpp"
#include "gearwright/spec/json.hpp"

namespace gearwright {

struct ListedDesign {
  std::int64_t number;  ///< N
  std::int64_t trial;
  /// The numbers of teeth in the file of the list. If they differ from the numbers of teeth of
  /// the trial in this search, the file belongs to another search.
  std::optional<std::array<int, 2>> teeth{};
};

struct StudyOptions : CampaignOptions {
  std::optional<std::string> designs;  ///< file or folder of a search
  std::vector<ListedDesign> list;      ///< the designs, if they are known; without `designs` and
                                       ///< `list`, the search is run
  std::optional<std::size_t> top;      ///< greatest number of designs; by default all
  int threads = 0;                     ///< 0 uses all threads of the machine
  Progress* progress = nullptr;        ///< counts the samples of one design
  /// Receives the number of finished designs and the number of all designs. It is called before
  /// each design. If the rows are kept in a folder, it is also called at the end.
  std::function<void(std::int64_t done, std::int64_t of)> on_design;
};

struct StudyRun {
  bool finished = false;      ///< true if all rows are computed; of several ranks, only for the one
                              ///< that makes the files
  std::vector<Json> designs;  ///< ranked rows with scattered_design_quantities
  std::vector<Json> refused;  ///< rows without a scatter, in the order of the list
  std::int64_t done = 0, of = 0;
  std::vector<std::string> notes;  ///< repairs in the folder
  std::vector<std::filesystem::path> files;
};

/// Throws    WorkStopped
/// Errors    "--designs" if the search of the spec does not have the design; the errors of reading
///           the spec of the design. If its scatter cannot be computed, the row contains the reason
///           instead
Result<Json> study_row(const JobSpec& spec, const Search& search, const ListedDesign& design,
                       const StudyOptions& options);

/// Computes the rows of this process that are missing in the folder options.out. If all rows of the
/// study exist afterwards, they are appended to `rows`, in the order of the list and without a
/// ranking.
///
/// Throws    IoError, WorkStopped
/// Errors    the errors of open_campaign() and study_row()
Result<StudyRun> run_study_campaign(const JobSpec& spec, const Search& search,
                                    const std::vector<ListedDesign>& list,
                                    const StudyOptions& options, std::vector<Json>& rows);

/// Computes the rows of this process. If all rows of the study exist afterwards, ranks them.
///
/// Domain    a spec with [search] (contract)
/// Throws    IoError, WorkStopped
/// Errors    "--designs" if the file or folder is not the result of a finished search of this spec;
///           `search` if no design is feasible; an error of [scatter] or [load] that concerns every
///           design; the errors of run_search(), study_row() and run_study_campaign()
/// Laws      (1) the rows and files do not depend on the numbers of threads, shards and ranks
Result<StudyRun> run_study(const JobSpec& spec, const StudyOptions& options);

/// Throws    IoError
std::string text_of_file(const std::filesystem::path& path);

/// Returns the index of the percentile by which the designs are ranked. This is the greatest
/// requested percentile.
std::size_t ranking_percentile(const JobSpec& spec);

/// True if the design of the row loses contact in more than (100 − p) % of the samples. p is the
/// percentile of the ranking.
bool loses_contact(const JobSpec& spec, const Json& row);

/// Ranks the rows. Rows that lose contact in more than (100 − p) % of the samples come after all
/// other rows. Within both groups, the rows are sorted by the percentile p, and then by N. Rows
/// without a scatter are moved to `refused`.
void rank_rows(const JobSpec& spec, std::vector<Json> rows, StudyRun& run);

Json study_json(const JobSpec& spec, const StudyRun& run);
/// Returns the whole result as JSON text, with one design per line.
std::string study_json_text(const JobSpec& spec, const StudyRun& run);
Json unfinished_study(const StudyRun& run);
std::string study_listing(const JobSpec& spec, const StudyRun& run, std::size_t most);
/// Makes a row for each design. Designs without a scatter are at the end.
std::string study_csv(const JobSpec& spec, const StudyRun& run);
std::string study_page(const JobSpec& spec, const StudyRun& run);

/// The number of designs in the table for users.
inline constexpr std::size_t kListedStudy = 40;

}  // namespace gearwright
