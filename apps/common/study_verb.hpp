// The verb scatter over the designs of a search, in one process or several: options, progress,
// Ctrl-C and output.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

#include "apps/common/search_verb.hpp"
#include "gearwright/spec/spec_text.hpp"

namespace gearwright::apps {

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
