// Reads a drive of a spec: [planetary], [[stage]] or the graph [drive].
//
// Internal to spec/: throws SpecError, as the readers of single values do.
#pragma once

#include <filesystem>

#include "gearwright/drive/drive.hpp"
#include "gearwright/spec/json.hpp"

namespace gearwright {

/// True if the spec has one of the three tables.
bool is_drive(const Json& tree);

/// The graph into which they expand, with the stages of a train.
DriveInput read_drive(const Json& tree, const std::filesystem::path& folder);

/// An error of a drive's graph with the key of its table: `drive.fixed` of a set is
/// planetary.fixed.
Error of_drive_table(Error error, const Json& tree);

}  // namespace gearwright
