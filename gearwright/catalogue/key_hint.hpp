// Which key somebody meant who wrote one that a table has not.
//
// Looked for in this order: the key without its unit, its symbol ("mn" is m_n, "beta" is β) and the
// words that its entry says people try (Key::also), here and then in the tables below and beside;
// a part of its name; a name that differs by few letters. Where nothing of this is found, no key is
// nearer than another, and the table says which it has.
#pragma once

#include <string>
#include <string_view>

#include "gearwright/catalogue/key.hpp"

namespace gearwright {

/// What follows "unknown key in [gear1]; ": "the nearest known one is normal_module_mm". `path` is
/// the table's name, "gear1.rack", empty for the file itself.
std::string key_hint(const KeyTable& table, std::string_view path, std::string_view key);

/// A name as it is compared: small Latin letters and digits, Greek ones written out.
std::string folded(std::string_view name);

}  // namespace gearwright
