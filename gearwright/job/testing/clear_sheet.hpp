// Tests that the texts of a sheet overlap neither lines nor other texts.
#pragma once

#include <string>

#include "gearwright/cad/sheet.hpp"

namespace gearwright::testing {

void expect_clear(const Sheet& sheet, const std::string& what);

}  // namespace gearwright::testing
