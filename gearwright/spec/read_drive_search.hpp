// Reads a table [search] with the key `kind`, which is a search for drives.
//
// Internal to spec/. The functions throw SpecError, like the readers of single values.
#pragma once

#include "gearwright/design/drive_search.hpp"
#include "gearwright/spec/json.hpp"

namespace gearwright {

/// True if the table is a search for drives.
bool is_drive_search(const Json& search);

DriveSearchProblem read_drive_search(const Json& search);

/// The keys of [search] that are copied to [planetary] of every set, or to every stage of a train.
Json shared_keys(const Json& search, bool train);

}  // namespace gearwright
