// The answer of a search for drives. Internal to job/ and the programs.
#pragma once

#include <cstddef>

#include "gearwright/job/verbs.hpp"

namespace gearwright {

/// Drives that an answer holds if nothing else is said.
inline constexpr std::size_t kDefaultDrives = 100;

/// The spec has a [search] with a kind of drive.
bool searches_drives(const JobSpec& spec);

/// The best of the search, each computed as the verb drive computes its spec; `specs` has these.
///
/// Domain    a spec with a search for drives (contract)
/// Errors    as search_drives(), with the keys of the spec
Result<Answer> answer_drive_search(const JobSpec& spec, std::size_t top = kDefaultDrives,
                                   int threads = 0);

}  // namespace gearwright
