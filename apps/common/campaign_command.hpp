// Work that several processes may share in a folder, as the command line gives it: the verb search, and scatter over
// the designs of a search.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "gearwright/job/chunk_queue.hpp"

namespace gearwright::apps {

/// The options of both verbs.
struct CampaignCommand {
  std::string spec;
  std::optional<std::string> out, shard;
  bool json = false, resume = false;
  std::optional<std::size_t> top;
  int threads = 0;
};

/// Several processes that work together. A single process does not use this.
struct Together {
  int rank = 0, ranks = 1;
  std::function<std::int64_t()> next_chunk;
  /// Called when the folder has been opened or could not be opened. The first process opens the folder, and the
  /// others wait.
  std::function<bool(bool opened)> folder_is_open;
  std::function<bool()> finish_together;
};

/// Fills `options`, and returns the error of the command line if there is one. `verb` is the name of a single process
/// in the journal, and `noun` is that of the work, "search" or "study".
std::optional<std::string> fill_campaign(const CampaignCommand& command, const Together* together,
                                         const std::string& verb, const std::string& noun,
                                         CampaignOptions& options);

/// The number of threads of this process. A rank has one by default.
int threads_of(const CampaignCommand& command, const Together* together);

/// The list of written files at the end of a listing; empty if there are none.
std::string written_files(const std::vector<std::filesystem::path>& files);

}  // namespace gearwright::apps
