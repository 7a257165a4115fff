// Makes the completion scripts for shells from the definition of the command line.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace gearwright::apps {

/// Returns the script for bash, zsh or fish.   Domain  shell is one of the three (contract)
std::string completion(const std::string& shell, const CLI::App& app);

/// Returns the values that completion offers for an option. The list is empty if the value of the
/// option is a file name or free text.
std::vector<std::string> words_of(const CLI::Option& option);

}  // namespace gearwright::apps
