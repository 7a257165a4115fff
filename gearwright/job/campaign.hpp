// The folder of a campaign, a search or a study whose finished chunks stay on disk, opened as its
// options say. Internal to job/.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "gearwright/base/result.hpp"
#include "gearwright/job/chunk_queue.hpp"
#include "gearwright/store/chunk_store.hpp"

namespace gearwright {

/// The store; none if the first process could not open the folder. `refused` is a reason why the
/// folder must not be used.
///
/// Throws    IoError
/// Errors    `refused`; as ChunkStore::open
Result<std::optional<ChunkStore>> open_campaign(const Campaign& campaign,
                                                const std::vector<std::string>& count_names,
                                                const CampaignOptions& options,
                                                const std::optional<Error>& refused);

/// The missing chunks of this process, ascending.
std::vector<std::int64_t> own_chunks(const ChunkStore& store, const CampaignOptions& options);

}  // namespace gearwright
