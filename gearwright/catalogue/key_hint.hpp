// Finds the key that a user probably meant by an unknown key.
//
// The unknown key is compared with other keys in this order:
//   (1) in its own table, the names without units, the other names (Key::also) and the symbols of
//       keys ("mn" is m_n, "beta" is β)
//   (2) in its own table, names that differ by a typing error
//   (3) in the tables below and then in all other tables, names and other names of keys
//   (4) in its own table, names that share most of their words or a part with the unknown key, or
//       that differ from the unknown key in few letters
// If no key is similar, the message lists the keys of the table.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "gearwright/catalogue/key.hpp"

namespace gearwright {

/// Returns the known key that an unknown key probably means, for example "diameter_mm in
/// [gear1.bore]". Returns none if no key is similar.
std::optional<std::string> similar_key(const KeyTable& table, std::string_view path,
                                       std::string_view key);

/// Returns the text after "unknown key in [gear1]; ", for example "did you mean normal_module_mm?".
/// `path` is the name of the table, for example "gear1.rack". It is empty for the file itself.
std::string key_hint(const KeyTable& table, std::string_view path, std::string_view key);

/// Returns a name in the form for comparison, which has only small Latin letters and digits. Greek
/// letters are spelled out.
std::string folded(std::string_view name);

// Sentences about inputs that users may expect but that are not supported. Each sentence states
// that the input is not supported, or names the equivalent key. If there were no such sentence, the
// message would suggest a known key with a similar name, which would be misleading.

/// Returns the sentence about an unsupported input. The input is an unknown key, for example
/// "gear2.form", or a known key with an unsupported value, for example "gear2.teeth" with the value
/// "0". Returns an empty text if there is no sentence about the input.
std::string_view not_supported(std::string_view path, std::string_view value = {});

}  // namespace gearwright
