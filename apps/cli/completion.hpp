// Completion for shells, made from the command line itself.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace gearwright::apps {

/// The script that bash, zsh or fish reads.   Domain  one of the three (contract)
std::string completion(const std::string& shell, const CLI::App& app);

/// What an option takes, as completion offers it; empty: a file's name, or anything.
std::vector<std::string> words_of(const CLI::Option& option);

}  // namespace gearwright::apps
