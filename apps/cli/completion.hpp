// Completion for shells, made from the command line itself.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace gearwright::apps {

/// The script that bash, zsh or fish reads.   Domain  shell is one of the three (contract)
std::string completion(const std::string& shell, const CLI::App& app);

/// The values of an option that completion offers. Empty if it takes a file name or any text.
std::vector<std::string> words_of(const CLI::Option& option);

}  // namespace gearwright::apps
