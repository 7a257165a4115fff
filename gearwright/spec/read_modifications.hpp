// Reads [gearN.modifications] for the right and the left flank.
//
// A key sets both flanks. With the prefix right_ or left_ it sets one flank and takes precedence.
//
// Internal to spec/. The functions throw SpecError, like the readers of single values.
#pragma once

#include <array>
#include <filesystem>
#include <string_view>

#include "gearwright/gear/modifications.hpp"
#include "gearwright/spec/table_reader.hpp"

namespace gearwright {

constexpr std::size_t kMaxTopography = 4 << 20;  ///< in bytes, enough for 200 000 points

/// The modifications of the right and the left flank. They remove nothing if the gear has no such
/// table. make_removal_field checks the conditions on the finished gear.
///
/// Throws    IoError if the file of a topography exists and cannot be read
std::array<FlankModifications, 2> read_modifications(TableReader& gear,
                                                     const std::filesystem::path& folder);

/// Reads a topography from CSV with the columns diameter_mm, z_mm and removed_um. The rows may have
/// any order, and every diameter must occur once with every z. A first line with these names, empty
/// lines and comments after # are allowed.
///
/// Errors    line and reason, without a key
Result<Topography> topography_from_csv(std::string_view csv);

}  // namespace gearwright
