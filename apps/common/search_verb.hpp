// The verb search, in one process or several: command line, progress, Ctrl-C and output.
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "gearwright/job/search_job.hpp"
#include "gearwright/spec/spec_text.hpp"

namespace gearwright::apps {

// Command-line options for work that several processes can share in a folder: the verb search, and
// scatter over the designs of a search.

/// The options that both verbs have.
struct CampaignCommand {
  std::string spec;
  std::optional<std::string> out, shard;
  bool json = false, resume = false;
  std::optional<std::size_t> top;
  int threads = 0;
};

/// Describes the group of processes to which this process belongs. Not used by a single process.
struct Together {
  int rank = 0, ranks = 1;
  std::function<std::int64_t()> next_chunk;
  /// Called after the folder has been opened or could not be opened. The first process opens the
  /// folder while the others wait.
  std::function<bool(bool opened)> folder_is_open;
  std::function<bool()> finish_together;
};

/// Fills `options` and returns an error of the command line, if there is one. If the process is
/// neither a shard nor a rank, its name in the journal is `verb`. `noun` is the name of the work,
/// "search" or "study".
std::optional<std::string> fill_campaign(const CampaignCommand& command, const Together* together,
                                         const std::string& verb, const std::string& noun,
                                         CampaignOptions& options);

/// The number of threads of this process. A rank has one by default.
int threads_of(const CampaignCommand& command, const Together* together);

/// The list of written files for the end of a listing; empty if no file was written.
std::string written_files(const std::vector<std::filesystem::path>& files);

struct SearchCommand : CampaignCommand {
  bool yes_large = false;
  std::optional<int> take;
  std::optional<std::int64_t> chunk;
};

/// Adds the verb `search` to a program.
CLI::App* add_search(CLI::App& app, SearchCommand& command);

/// Returns the exit status.   Throws  IoError
int run_search_verb(const SearchCommand& command, const Together* together = nullptr);

// The verb scatter over the designs of a search, in one process or several: options, progress,
// Ctrl-C and output.

struct StudyCommand : CampaignCommand {
  std::optional<std::string> designs;
  bool csv = false;

  /// True if at least one option is given that is valid only for a study of designs.
  bool given() const { return designs || out || shard || resume || top; }
};

void add_study_options(CLI::App* sub, StudyCommand& command);

/// Adds the verb scatter to a program that supports it only for the designs of a search.
CLI::App* add_study(CLI::App& app, StudyCommand& command);

/// Returns the exit status.   Throws  IoError
int run_study_verb(const StudyCommand& command, const SpecText& text,
                   const Together* together = nullptr);
/// Reads the spec that the command names, and runs the verb for it.
int run_study_verb(const StudyCommand& command, const Together* together);

}  // namespace gearwright::apps
