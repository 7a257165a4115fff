// Reads one case from a file with results of another program. Unit tests of functions that need no
// gear use it.
#pragma once

#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>

#include "gearwright/base/testing/source_file.hpp"

namespace gearwright::testing {

inline nlohmann::json oracle_case(const std::string& file, const std::string& id) {
  const auto all = nlohmann::json::parse(std::ifstream(source_file("tests/oracle/" + file)));
  for (const auto& c : all["cases"])
    if (c["id"] == id) return c;
  throw std::logic_error("no case " + id + " in " + file);
}

}  // namespace gearwright::testing
