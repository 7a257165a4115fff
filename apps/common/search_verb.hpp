// The verb search, in one process or several: command line, progress, Ctrl-C and output.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>

#include "apps/common/campaign_command.hpp"
#include "gearwright/job/search_job.hpp"

namespace gearwright::apps {

struct SearchCommand : CampaignCommand {
  bool yes_large = false;
  std::optional<int> take;
  std::optional<std::int64_t> chunk;
};

/// Adds the verb `search` to a program.
CLI::App* add_search(CLI::App& app, SearchCommand& command);

/// Returns the exit status.   Throws  IoError
int run_search_verb(const SearchCommand& command, const Together* together = nullptr);

}  // namespace gearwright::apps
