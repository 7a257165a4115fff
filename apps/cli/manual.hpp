// Makes the manual page from the command line and the catalogue of keys.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace gearwright::apps {

/// Returns the page gearwright(1) for man.
std::string manual_page(const CLI::App& app);

}  // namespace gearwright::apps
