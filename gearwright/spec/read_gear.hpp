// Reads one gear's table of a spec, [gear1] or [gear2], with its rack or the pinion cutter that
// replaces the rack.
//
// Internal to spec/: throws SpecError, as the readers of single values do.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "gearwright/spec/spec.hpp"
#include "gearwright/spec/table_reader.hpp"
#include "gearwright/tool/rack.hpp"

namespace gearwright {

/// `keys` are gear_keys() or cutter_keys(); `path` is the table's name, "gear1"; `mate` the other
/// gear's table, from which a separate cutter takes the module and angles that it omits. File names
/// are relative to `folder`.
GearInput read_gear(const KeyTable& keys, const Json& node, const std::string& path,
                    const Json* mate = nullptr, const std::filesystem::path& folder = {});

/// [gearN] rack; by default ISO53-A. `module`, mm, chooses among the racks of GB/T 12759.
Rack read_rack(TableReader& gear, std::optional<double> module);

/// Reads a rack for which only straight flanks are allowed.
StraightRack read_straight_rack(TableReader& gear);

/// `cut_by` and `profile_shift_pair`; `node` is the gear's table, `mate` the other's or null.
void read_cut_by(TableReader& gear, const Json& node, const Json* mate, GearInput& g);

}  // namespace gearwright
