// Reads a drive of a spec: [planetary], [[stage]] or the graph [drive].
//
// Internal to spec/. The functions throw SpecError, like the readers of single values.
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "gearwright/arrange/given_material.hpp"
#include "gearwright/drive/short_forms.hpp"
#include "gearwright/spec/json.hpp"

namespace gearwright {

/// True if the spec has one of the three tables.
bool is_drive(const Json& tree);

/// The graph of the drive and, for a train, its stages. A short form is expanded to a graph.
DriveInput read_drive(const Json& tree, const std::filesystem::path& folder);

/// The materials of the gears that have their own material, by the names of the gears. The map is
/// empty if the tree has no table of a drive.
std::map<std::string, MaterialInput> drive_materials(const Json& tree);

/// Sets an absent speed of [rating] to the speed of the first input, because a life and a power
/// need a speed.
void lend_speed(Json& tree);

/// Reads a planetary set from a table with the keys of [planetary].
PlanetarySpec read_set(const Json& node, const std::string& path);

/// The spec with its short form replaced by the equivalent [drive].
///
/// Domain    read_drive accepts the spec (contract)
Json expanded_spec(const Json& tree, const DriveInput& drive);

/// Replaces the names in an error of a drive's graph by the keys of the file. For example,
/// `drive.fixed` of a set becomes planetary.fixed.
Error of_drive_table(Error error, const Json& tree);

}  // namespace gearwright
