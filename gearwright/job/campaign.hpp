// Opens the folder of a campaign, in which the finished chunks of a search or a study stay on disk.
// Internal to job/.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "gearwright/base/result.hpp"
#include "gearwright/job/chunk_queue.hpp"
#include "gearwright/store/chunk_store.hpp"

namespace gearwright {

/// The store, or nothing if the first process could not open the folder. If `refused` is set, the
/// folder must not be used, and `refused` is the error.
///
/// Throws    IoError
/// Errors    `refused`; the errors of ChunkStore::open
Result<std::optional<ChunkStore>> open_campaign(const Campaign& campaign,
                                                const std::vector<std::string>& count_names,
                                                const CampaignOptions& options,
                                                const std::optional<Error>& refused);

/// The missing chunks of this process, in ascending order.
std::vector<std::int64_t> own_chunks(const ChunkStore& store, const CampaignOptions& options);

}  // namespace gearwright
