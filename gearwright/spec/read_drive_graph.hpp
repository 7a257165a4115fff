// Reads the graph of a drive, the table [drive], and values that several tables of a drive have.
//
// Internal to spec/. The functions throw SpecError.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "gearwright/arrange/given_gear.hpp"
#include "gearwright/drive/drive_graph.hpp"
#include "gearwright/spec/json.hpp"
#include "gearwright/spec/table_reader.hpp"

namespace gearwright {

/// One name or a list of names; none if the key is absent.
std::optional<std::vector<std::string>> read_names(TableReader& t, const std::string& key);

/// One number or a list of numbers; empty if the key is absent.
std::vector<double> read_list(TableReader& t, const std::string& key);

/// Reads the speeds and the torque of inputs that turn. Only one torque may be given.
void read_input_loads(TableReader& t, std::vector<double>& speeds, std::optional<double>& torque);

/// Rejects keys that apply to a single gear but not to a drive.
void refuse_in_drive(const Json& node, const std::string& path);

/// Rejects a double-helical gear without a face width.
void need_whole_face(const GearInput& gear, const std::string& path);

/// The graph of the table [drive]. Files of its gears are in `folder`.
DriveGraph read_graph(const Json& node, const std::filesystem::path& folder);

}  // namespace gearwright
