// Finds the key that a user probably meant when the given key is unknown.
//
// The given key is compared with the keys of its own table and of other tables, in this order:
// (1) the names without units, the other names (Key::also) and the symbols ("mn" is m_n, "beta"
// is β) of keys in its own table; (2) names in its own table that differ by a typing error; (3)
// names and other names in the tables below and then in all other tables; (4) names in its own
// table that have most words in common with it, that share a part with it, or that differ from
// it in few letters. If no key is similar, the message lists the keys of the table.
#pragma once

#include <string>
#include <string_view>

#include "gearwright/catalogue/key.hpp"

namespace gearwright {

/// The text after "unknown key in [gear1]; ", for example "did you mean normal_module_mm?".
/// `path` is the name of the table, for example "gear1.rack", or empty for the file itself.
std::string key_hint(const KeyTable& table, std::string_view path, std::string_view key);

/// A name in the form for comparison, which has only small Latin letters and digits. Greek letters
/// are spelled out.
std::string folded(std::string_view name);

// Sentences about inputs that users may expect but that are not supported. Such a sentence states
// that the input is not supported, or names the equivalent key. Without it, the message would
// suggest a known key with a similar name.

/// The sentence about an unsupported input. The input is an unknown key, for example "gear2.form",
/// or a known key with an unsupported value, for example "gear2.teeth" with the value "0". The text
/// is empty if there is no sentence about the input.
std::string_view not_supported(std::string_view path, std::string_view value = {});

}  // namespace gearwright
