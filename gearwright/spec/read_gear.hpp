// Reads one gear's table of a spec, [gear1] or [gear2], with its rack or the pinion cutter that
// replaces the rack.
//
// Internal to spec/. The functions throw SpecError, like the readers of single values.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "gearwright/spec/spec.hpp"
#include "gearwright/spec/table_reader.hpp"
#include "gearwright/tool/rack.hpp"

namespace gearwright {

/// `keys` are gear_keys() or cutter_keys(), and `path` is the name of the table, "gear1". `mate` is
/// the table of the other gear, from which a separate cutter takes the module and angles that it
/// omits. File names are relative to `folder`.
GearInput read_gear(const KeyTable& keys, const Json& node, const std::string& path,
                    const Json* mate = nullptr, const std::filesystem::path& folder = {});

/// The rack in [gearN], by default ISO53-A. `module`, in mm, selects one of the racks of GB/T
/// 12759.
Rack read_rack(TableReader& gear, std::optional<double> module);

/// Reads a rack for which only straight flanks are allowed.
StraightRack read_straight_rack(TableReader& gear);

/// The normal pressure angle in degrees. It is the given angle or the angle of a rack of AGMA.
std::optional<double> rack_angle(TableReader& gear, std::optional<double> given);

/// Reads `cut_by` and `profile_shift_pair`. `node` is the table of the gear. `mate` is the table of
/// the other gear, or null.
void read_cut_by(TableReader& gear, const Json& node, const Json* mate, GearInput& g);

}  // namespace gearwright
