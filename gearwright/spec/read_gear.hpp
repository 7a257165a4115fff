// Reads one gear's table of a spec, [gear1] or [gear2], with its rack or the pinion cutter that
// replaces the rack.
//
// Internal to spec/. The functions throw SpecError, like the readers of single values.
#pragma once

#include <array>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "gearwright/gear/modifications.hpp"
#include "gearwright/inspection/identify.hpp"
#include "gearwright/spec/json.hpp"
#include "gearwright/spec/spec.hpp"
#include "gearwright/spec/table_reader.hpp"
#include "gearwright/tool/rack.hpp"

namespace gearwright {

/// Reads the table of a gear. `keys` are gear_keys(), cutter_keys(), or the keys of a gear of a
/// drive. `path` is the name of the table, for example "gear1". `mate` is the table of the other
/// gear, or null. If the table of a separate cutter and the table of the gear omit the module or
/// the angles, they are taken from `mate`. File names are relative to `folder`.
GearInput read_gear(const KeyTable& keys, const Json& node, const std::string& path,
                    const Json* mate = nullptr, const std::filesystem::path& folder = {});

/// Reads a rack, which must have straight flanks.
StraightRack read_straight_rack(TableReader& gear);

/// Returns the normal pressure angle. If the gear names an AGMA rack, the result is the angle of
/// this rack, and a different angle `given` is an error. Otherwise, the result is `given`.
std::optional<Angle> rack_angle(TableReader& gear, std::optional<Angle> given);

// Functions that read [gearN.measured] and the other data that are known about a gear.

/// True if the table of a gear gives a module, a base cylinder or a cutter.
bool has_module(const Json& gear);

/// True if the table of a gear has readings but no module, which `identify` must compute.
bool is_unknown_gear(const Json& gear);

/// Returns the readings of gear 1 or 2, or null if its table is absent or has no readings. If the
/// gear is unknown and its readings or [pair] contain the centre distance, the centre distance and
/// the number of teeth of the mating gear are added.
/// Throws    SpecError
std::shared_ptr<const IdentifyProblem> read_measured(const Json& tree, int which);

constexpr std::size_t kMaxTopography = 4 << 20;  ///< bytes, enough for 200 000 points

/// Returns the modifications of the right and the left flank. Without [gearN.modifications], they
/// remove nothing. Conditions that depend on the finished gear are checked in make_removal_field()
/// and not here.
///
/// Throws    IoError if the file of a topography exists and cannot be read
BothFlanks read_modifications(TableReader& gear, const std::filesystem::path& folder);

/// Reads a topography from CSV with the columns diameter_mm, z_mm and removed_um. The rows may have
/// any order, and every diameter must occur once with every z. A first line with these names, empty
/// lines and comments after # are allowed.
///
/// Errors    the line and the reason; the error has no key
Result<Topography> topography_from_csv(std::string_view csv);

}  // namespace gearwright
