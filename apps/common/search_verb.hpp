// The verb search, for one process or several: command line, progress, Ctrl-C and output.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <optional>
#include <string>

#include "gearwright/job/search_job.hpp"

namespace gearwright::apps {

struct SearchCommand {
  std::string spec;
  std::optional<std::string> out, shard;
  bool json = false, resume = false, yes_large = false;
  std::optional<std::size_t> top;
  std::optional<int> take;
  std::optional<std::int64_t> chunk;
  int threads = 0;
};

/// Adds the verb `search` to a program.
CLI::App* add_search(CLI::App& app, SearchCommand& command);

/// Several processes that work on one search. A single process does not use this.
struct Together {
  int rank = 0, ranks = 1;
  std::function<std::int64_t()> next_chunk;
  /// Called when the folder has been opened or could not be opened. The first process opens the folder, and the
  /// others wait.
  std::function<bool(bool opened)> folder_is_open;
  std::function<bool()> finish_together;
};

/// One of several processes that share a folder, counted from 1.
struct Shard {
  int which = 1, of = 1;
};
/// Reads "3/8"; none if it is not a shard.
std::optional<Shard> parse_shard(const std::string& text);

/// Returns the exit status.   Throws  IoError
int run_search_verb(const SearchCommand& command, const Together* together = nullptr);

}  // namespace gearwright::apps
