// The files of a search, each written completely or not at all.
//
//   search.parquet   every feasible design, in the order of the trials
//   points.parquet   if shift_step is set: every feasible point of its grid, by trial
//   best.csv         the best designs, best first          search.json    the result
//   report.html      the best designs in a sortable table, their regions, the Pareto front
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "gearwright/base/result.hpp"
#include "gearwright/job/chunk_queue.hpp"
#include "gearwright/job/search_job.hpp"
#include "gearwright/job/search_record.hpp"
#include "gearwright/store/chunk_store.hpp"

namespace gearwright {

inline constexpr const char* kDesignsFile = "search.parquet";
inline constexpr const char* kSpecNote = "spec";  ///< key of the spec, as JSON, in the footer

/// Reads the next chunk of designs, in the order of the trials. Returns false if there are no more.
using FindSource = std::function<bool(ChunkFinds& finds)>;

/// Writes all files and returns their names. The CSV has `top` designs, by default a thousand.
///
/// Throws    IoError
std::vector<std::filesystem::path> write_search_files(const JobSpec& spec, const Search& search,
                                                      const SearchRun& run,
                                                      const std::filesystem::path& folder,
                                                      std::optional<std::size_t> top,
                                                      const FindSource& source);

// Opens the folder of a campaign. A campaign is a search or a study whose finished chunks stay on
// disk.

/// The store, or nothing if the first process could not open the folder. If `refused` is set, the
/// folder must not be used, and `refused` is the error.
///
/// Throws    IoError
/// Errors    `refused`; the errors of ChunkStore::open
Result<std::optional<ChunkStore>> open_campaign(const Campaign& campaign,
                                                const std::vector<std::string>& count_names,
                                                const CampaignOptions& options,
                                                const std::optional<Error>& refused);

/// The missing chunks of this process, in ascending order.
std::vector<std::int64_t> own_chunks(const ChunkStore& store, const CampaignOptions& options);

}  // namespace gearwright
