// Defines the verbs, the options and their texts in one place. Parsing, --help, completion and the
// manual page all use this definition.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>

#include <CLI/CLI.hpp>

#include "apps/cli/verbs.hpp"
#include "apps/common/search_verb.hpp"

namespace gearwright::apps {

class CommandLine {
 public:
  CommandLine();
  CommandLine(const CommandLine&) = delete;  // CLI11's options point into this object
  CommandLine& operator=(const CommandLine&) = delete;

  const CLI::App& app() const { return app_; }
  /// Runs the requested verb and returns its exit status.   Throws  IoError
  int run(std::vector<std::string> words);

 private:
  /// The work of a verb after its options are read. It returns the exit status.
  using Work = std::function<int()>;
  CLI::App* verb(const char* name, const char* what, const char* example, Work work);
  CLI::App* json_verb(const char* name, const char* what, const char* example, Work work);
  void add_run();
  void add_answering();
  void add_files();
  void add_others();

  /// Handles `help`, `help VERB`, and a first word that is not a verb. For other command lines,
  /// returns nothing.
  std::optional<int> answer_at_once(const std::vector<std::string>& words) const;
  int unknown_verb(const std::string& word) const;
  int unknown_option(const std::string& word) const;
  int answer(const Verb& row) const;
  /// If an option of a study is given, or if the spec contains [search] but no gear 1, ranks
  /// the designs of a search by their scatter. Otherwise computes the scatter of the pair in
  /// the spec.
  int scatter(const Verb& row) const;

  Options options_;
  SearchCommand search_;
  StudyCommand study_;
  CLI::App app_;
  std::map<const CLI::App*, Work> work_;
};

/// Returns the verbs that a user sees, in the order of --help.
std::vector<const CLI::App*> verbs_of(const CLI::App& app);

/// Returns the script for bash, zsh or fish.   Domain  shell is one of the three (contract)
std::string completion(const std::string& shell, const CLI::App& app);

/// Returns the names of an option with their hyphens, "-o" before "--option".
std::vector<std::string> names_of(const CLI::Option& option);

/// Returns the values that completion offers for an option. The list is empty for all options
/// except --gear and --only.
std::vector<std::string> words_of(const CLI::Option& option);

std::string manual_page(const CLI::App& app);

}  // namespace gearwright::apps
