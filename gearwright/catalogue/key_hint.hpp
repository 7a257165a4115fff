// Finds the key that a user probably meant by an unknown one.
//
// It compares, in this order: the key without its unit, its symbol ("mn" is m_n, "beta" is β) and
// its other names (Key::also), first in this table and then in the tables below and beside it; a
// part of its name; a name that differs by few letters. If none is found, the message lists the
// keys of the table.
#pragma once

#include <string>
#include <string_view>

#include "gearwright/catalogue/key.hpp"

namespace gearwright {

/// The text after "unknown key in [gear1]; ": "the nearest known one is normal_module_mm". `path`
/// is the table's name, "gear1.rack", or empty for the file itself.
std::string key_hint(const KeyTable& table, std::string_view path, std::string_view key);

/// A name in the form for comparison: small Latin letters and digits, with Greek letters spelled
/// out.
std::string folded(std::string_view name);

}  // namespace gearwright
