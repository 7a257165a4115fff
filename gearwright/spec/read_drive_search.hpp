// Reads [search] with a kind: a search for drives.
//
// Internal to spec/: throws SpecError, as the readers of single values do.
#pragma once

#include "gearwright/design/drive_search.hpp"
#include "gearwright/spec/json.hpp"

namespace gearwright {

/// True if the table is a search for drives.
bool is_drive_search(const Json& search);

DriveSearchProblem read_drive_search(const Json& search);

/// The keys of [search] that every set has in [planetary], or every stage of a train.
Json shared_keys(const Json& search, bool train);

}  // namespace gearwright
