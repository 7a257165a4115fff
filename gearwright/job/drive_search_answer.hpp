// The answer of a search for drives. Internal to job/ and the programs.
#pragma once

#include <cstddef>

#include "gearwright/job/verbs.hpp"

namespace gearwright {

/// Default number of drives in an answer.
inline constexpr std::size_t kDefaultDrives = 100;

/// True if the spec has a [search] for drives.
bool searches_drives(const JobSpec& spec);

/// The best drives of the search, each computed by the verb drive. `specs` contains their specs.
///
/// Domain    a spec with a search for drives (contract)
/// Errors    the errors of search_drives(), with the keys of the spec
Result<Answer> answer_drive_search(const JobSpec& spec, std::size_t top = kDefaultDrives,
                                   int threads = 0);

}  // namespace gearwright
