// The verb scatter over the designs of a search, for one process or several: options, progress,
// Ctrl-C and output.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

#include "apps/common/campaign_command.hpp"
#include "gearwright/spec/spec_text.hpp"

namespace gearwright::apps {

struct StudyCommand : CampaignCommand {
  std::optional<std::string> designs;
  bool csv = false;

  /// True if an option is given that only a study of designs has.
  bool given() const { return designs || out || shard || resume || top; }
};

/// Adds the options of a study to the verb scatter.
void add_study_options(CLI::App* sub, StudyCommand& command);

/// Adds the verb scatter of designs alone to a program.
CLI::App* add_study(CLI::App& app, StudyCommand& command);

/// Returns the exit status.   Throws  IoError
int run_study_verb(const StudyCommand& command, const SpecText& text,
                   const Together* together = nullptr);
/// The same for a spec that has not been read.
int run_study_verb(const StudyCommand& command, const Together* together);

}  // namespace gearwright::apps
