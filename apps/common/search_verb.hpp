// Runs the verb `search` in one process or several. This includes its command line, progress
// display, reaction to Ctrl-C, and output.
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

// Command-line options for work that several processes can share through a common folder. The verb
// `search` does such work, and so does the verb `scatter` over the designs of a search.

struct CampaignCommand {
  std::string spec;
  std::optional<std::string> out, shard;
  bool json = false, resume = false;
  std::optional<std::size_t> top;
  int threads = 0;
};

/// The group of processes to which this process belongs. A process that works alone has no
/// group.
struct Together {
  int rank = 0, ranks = 1;
  std::function<std::int64_t()> next_chunk;
  /// The first process calls this function after its attempt to open the folder. The other
  /// processes call the function before they open the folder, and the function makes them wait for
  /// the first process. It returns true in every process if the first process has opened the
  /// folder.
  std::function<bool(bool opened)> folder_is_open;
  std::function<bool()> finish_together;
};

/// Fills `options`. Returns an error if the command line is wrong. `verb` is the name of the
/// process in the journal if the process is neither a shard nor a rank. `noun` names the work in
/// messages, and is "search" or "study".
std::optional<std::string> fill_campaign(const CampaignCommand& command, const Together* together,
                                         const std::string& verb, const std::string& noun,
                                         CampaignOptions& options);

/// Returns the number of threads of this process. A rank has one by default.
int threads_of(const CampaignCommand& command, const Together* together);

/// Returns the list of written files that is printed after a result. The text is empty if no file
/// was written.
std::string written_files(const std::vector<std::filesystem::path>& files);

struct SearchCommand : CampaignCommand {
  bool yes_large = false;
  std::optional<int> take;
  std::optional<std::int64_t> chunk;
};

inline constexpr int kMostTaken = 1'000'000;  ///< greatest number that --take accepts

/// Adds the options for the folder, the size and the threads of a search.
void add_search_options(CLI::App* sub, SearchCommand& command);

/// Adds a verb of a program that supports this verb only in a folder, with the option --json and
/// the argument SPEC.
CLI::App* add_campaign(CLI::App& app, const char* name, const char* what, CampaignCommand& command);

/// Returns the exit status.   Throws  IoError
int run_search_verb(const SearchCommand& command, const Together* together = nullptr);

// Runs the verb `scatter` over the designs of a search, in one process or several. This includes
// its options, progress display, reaction to Ctrl-C, and output.

struct StudyCommand : CampaignCommand {
  std::optional<std::string> designs;
  bool csv = false;

  /// True if at least one option is given that is valid only for a study of designs.
  bool given() const { return designs || out || shard || resume || top; }
};

void add_study_options(CLI::App* sub, StudyCommand& command);

/// Returns the exit status.   Throws  IoError
int run_study_verb(const StudyCommand& command, const SpecText& text,
                   const Together* together = nullptr);
int run_study_verb(const StudyCommand& command, const Together* together);

}  // namespace gearwright::apps
