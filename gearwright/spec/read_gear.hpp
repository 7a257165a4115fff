// Reads one gear's table of a spec: [gear1], [gear2].
//
// Internal to spec/: throws SpecError, as the readers of single values do.
#pragma once

#include <filesystem>
#include <string>

#include "gearwright/spec/spec.hpp"
#include "gearwright/spec/table_reader.hpp"

namespace gearwright {

/// `keys` are gear_keys() or cutter_keys(); `path` is the table's name, "gear1"; `mate` the other
/// gear's table, from which a separate cutter takes the module and angles that it omits. File names
/// are relative to `folder`.
GearInput read_gear(const KeyTable& keys, const Json& node, const std::string& path,
                    const Json* mate = nullptr, const std::filesystem::path& folder = {});

}  // namespace gearwright
