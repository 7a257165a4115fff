// Writes the folder of a search. While the search runs, the folder contains the chunks. At the end,
// it contains the files below, each written completely or not at all. Internal to job/ and the
// programs.
//
//   search.parquet   every feasible design, in the order of the trials
//   points.parquet   every feasible point of the grid of shifts, by trial, if shift_step is set
//   best.csv         the best designs, best first          search.json    the result
//   report.html      the best designs in a sortable table, their regions, the Pareto front
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "gearwright/base/result.hpp"
#include "gearwright/design/design_row.hpp"
#include "gearwright/design/shift_points.hpp"
#include "gearwright/job/search_job.hpp"

namespace gearwright {

// Converts feasible designs to bytes and back, for the chunks of a large search on disk. Every
// number of a row has 64 bits with the low byte first. The rows follow each other and are
// compressed with zstd. Reading gives the same rows, bit for bit.

struct ChunkFinds {
  std::vector<DesignRow> designs;
  std::vector<ShiftPoint> points;  ///< points of the grid of profile shifts, if requested
};

std::string pack(const ChunkFinds& finds);

/// Converts the bytes of pack() back to designs.
///
/// Throws    IoError if the bytes were not made by pack(). `where` names the bytes in the message
ChunkFinds unpack(std::string_view bytes, const std::string& where);

inline constexpr const char* kDesignsFile = "search.parquet";
inline constexpr const char* kSpecNote = "spec";  ///< key of the spec, as JSON, in the footer

/// Reads the next chunk of designs, in the order of the trials. Returns false after the last chunk.
using FindSource = std::function<bool(ChunkFinds& finds)>;

/// Writes all files and returns their names. The CSV has `top` designs, by default a thousand.
///
/// Throws    IoError
std::vector<std::filesystem::path> write_search_files(const JobSpec& spec, const Search& search,
                                                      const SearchRun& run,
                                                      const std::filesystem::path& folder,
                                                      std::optional<std::size_t> top,
                                                      const FindSource& source);

/// Returns an error if the folder contains the finished search of another spec, because this search
/// must not write files into that folder. Returns none otherwise.
std::optional<Error> refuse_other_search(const std::filesystem::path& folder, const JobSpec& spec);

/// Runs those missing chunks of the search in options.out that belong to this process. If all
/// chunks then exist, makes the files. Of several ranks, only the first one makes the files.
///
/// Throws    IoError
/// Errors    the errors of open_campaign(); a finished search of another spec in the folder
Result<SearchRun> run_campaign(const JobSpec& spec, const Search& search, std::int64_t chunk,
                               const SearchOptions& options);

}  // namespace gearwright
