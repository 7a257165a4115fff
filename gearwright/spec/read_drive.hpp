// Reads a drive of a spec: [planetary], [[stage]] or the graph [drive].
//
// Internal to spec/: throws SpecError, as the readers of single values do.
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

/// The graph into which they expand, with the stages of a train.
DriveInput read_drive(const Json& tree, const std::filesystem::path& folder);

/// The materials of gears that have their own, by the names of the gears; empty for a table that
/// does not describe a drive.
std::map<std::string, MaterialInput> drive_materials(const Json& tree);

/// Sets the speed of [rating] to that of the first input if it is absent, because a life and a
/// power need a speed.
void lend_speed(Json& tree);

/// The set of a table with the keys of [planetary].
PlanetarySpec read_set(const Json& node, const std::string& path);

/// The spec with its short form replaced by the equivalent [drive].
///
/// Domain    a spec with a drive that was read (contract)
Json expanded_spec(const Json& tree, const DriveInput& drive);

/// Replaces members of a drive's graph in an error by keys of the file: `drive.fixed` of a set is
/// planetary.fixed.
Error of_drive_table(Error error, const Json& tree);

}  // namespace gearwright
