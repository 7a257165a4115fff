// Reads a drive of a spec: [planetary], [[stage]] or the graph [drive].
//
// Internal to spec/. The functions throw SpecError, like the readers of single values.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "gearwright/arrange/given_pair.hpp"
#include "gearwright/drive/drive_graph.hpp"
#include "gearwright/drive/short_forms.hpp"
#include "gearwright/spec/json.hpp"
#include "gearwright/spec/table_reader.hpp"

namespace gearwright {

/// True if the spec has [planetary], [[stage]] or [drive].
bool is_drive(const Json& tree);

/// Returns the graph of the drive and, for a train, its stages. The short forms [planetary] and
/// [[stage]] are expanded to a graph.
DriveInput read_drive(const Json& tree, const std::filesystem::path& folder);

/// Returns the materials of a drive or of a search for drives, by the names of the gears. A gear
/// has a material if its own table, or the table of its stage, its planetary set or the search,
/// gives one.
std::map<std::string, MaterialInput> drive_materials(const Json& tree);

/// If [rating] gives no speed, sets it to the magnitude of the speed of the first input. Without a
/// speed, neither a life nor a power can be computed.
void lend_speed(Json& tree);

/// K_γ of the meshes of a drive, as [rating] gives it.
struct MeshLoadFactors {
  PerMesh given;
  bool computed = false;  ///< true if K_γ of the drive under [load] applies
};
MeshLoadFactors read_mesh_load_factors(const Json& tree);

/// Reads a planetary set from a table with the keys of [planetary].
PlanetarySpec read_set(const Json& node, const std::string& path);

/// Rejects a number or a material of a gear or a mesh that the set does not have. `node` is a table
/// with keys of [planetary], read by `t`.
void check_set_names(const TableReader& t, const Json& node, const PlanetarySpec& set);

/// Fails as check_speeds() if the table gives other than one number for each input of the drive.
void need_speeds(const TableReader& t, const std::vector<double>& speeds_rpm, std::size_t inputs);

/// Returns the spec with [planetary] or [[stage]] replaced by the equivalent [drive].
///
/// Domain    read_drive accepts the spec (contract)
Json expanded_spec(const Json& tree, const DriveInput& drive);

/// Replaces the names in an error of a drive's graph by the keys of the table that describes the
/// drive or the search for drives. For example, `drive.fixed` of a set becomes planetary.fixed.
Error of_drive_table(Error error, const Json& tree);

// Reads the table [drive], which is the graph of a drive.

/// Rejects keys that apply to a single gear but not to a drive.
void refuse_in_drive(const Json& node, const std::string& path);

/// Rejects a double-helical gear without a face width.
void need_whole_face(const GearInput& gear, const std::string& path);

/// If the table `t` gives the length of a rack, sets the number of whole teeth that fit into this
/// length. `pitch` is the transverse pitch in mm. Without a pitch, a given length is an error.
void set_rack_length(TableReader& t, std::optional<double> pitch, RackBar& bar);

/// Returns the graph of the table [drive]. File names of its gears are relative to `folder`.
DriveGraph read_graph(const Json& node, const std::filesystem::path& folder);

}  // namespace gearwright
