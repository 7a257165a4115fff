// Finds the key that a user probably meant when the given key is unknown.
//
// The given key is first compared with the names of keys without units, with their other names
// (Key::also) and with their symbols ("mn" is m_n, "beta" is β) in this table. Then names with a
// typing error in this table, the tables below it and all other tables are searched. Finally, names
// of this table that differ in one word, parts of names, and names that differ in few letters are
// compared. If no key is similar, the message lists the keys of the table.
#pragma once

#include <string>
#include <string_view>

#include "gearwright/catalogue/key.hpp"

namespace gearwright {

/// The text after "unknown key in [gear1]; ", for example "did you mean normal_module_mm?".
/// `path` is the name of the table, "gear1.rack", or empty for the file itself.
std::string key_hint(const KeyTable& table, std::string_view path, std::string_view key);

/// A name in the form for comparison, which has only small Latin letters and digits. Greek letters
/// are spelled out.
std::string folded(std::string_view name);

// Inputs that users may expect but that are not supported. The message states this, or names the
// equivalent key. Otherwise a known key with a similar name would be suggested.

/// The sentence about an unknown key with this path in the file, "gear2.form", or about a known key
/// with a value, "gear2.teeth" and "0". It is empty if there is no such sentence.
std::string_view not_supported(std::string_view path, std::string_view value = {});

}  // namespace gearwright
