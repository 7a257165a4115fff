// A case of a file of golden values, for unit tests of functions without gears.
#pragma once

#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>

#include "gearwright/base/testing/source_file.hpp"

namespace gearwright::testing {

/// The case of this id in tests/golden/`file`.
inline nlohmann::json golden_case(const std::string& file, const std::string& id) {
  const auto all = nlohmann::json::parse(std::ifstream(source_file("tests/golden/" + file)));
  for (const auto& c : all["cases"])
    if (c["id"] == id) return c;
  throw std::logic_error("no case " + id + " in " + file);
}

}  // namespace gearwright::testing
