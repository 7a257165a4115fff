// Reads [gearN.modifications] for the right and the left flank.
//
// A key sets both flanks. With the prefix right_ or left_ it sets one flank and takes precedence.
//
// Internal to spec/: throws SpecError, as the readers of single values do.
#pragma once

#include <array>
#include <filesystem>
#include <string_view>

#include "gearwright/gear/modifications.hpp"
#include "gearwright/spec/table_reader.hpp"

namespace gearwright {

constexpr std::size_t kMaxTopography = 4 << 20;  ///< bytes: 200 000 points

/// The right and the left flank; nothing is removed if the gear has no such table. Conditions on
/// the finished gear are checked by make_removal_field.
///
/// Throws    IoError if the file of a topography exists and cannot be read
std::array<FlankModifications, 2> read_modifications(TableReader& gear,
                                                     const std::filesystem::path& folder);

/// A topography from CSV: rows of diameter_mm, z_mm, removed_um in any order, every diameter with
/// every z once; a first line with these names, empty lines and comments after # are allowed.
///
/// Errors    without a key: line and reason
Result<Topography> topography_from_csv(std::string_view csv);

}  // namespace gearwright
