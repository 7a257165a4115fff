#include "gearwright/job/campaign.hpp"

#include "gearwright/store/chunk_store.hpp"

namespace gearwright {

std::optional<Error> refuse_folder() { return std::nullopt; }

Result<std::optional<ChunkStore>> open_campaign(const Campaign& campaign,
                                                const std::vector<std::string>& count_names,
                                                const CampaignOptions& options,
                                                const std::optional<Error>& refused) {
  const bool first = !options.many;
  if (options.folder_is_open && !first && !options.folder_is_open(true))
    return std::optional<ChunkStore>();
  // A scheduler starts and restarts ranks with the same command, which contains --resume. The first
  // rank therefore continues a campaign if there is one, and otherwise starts one.
  const OpenAs as = options.many || (options.together && options.resume) ? OpenAs::join
                    : options.resume                                     ? OpenAs::resume
                                                                         : OpenAs::fresh;
  auto opened = refused ? Result<ChunkStore>(*refused)
                        : ChunkStore::open(options.out, campaign, count_names, as, options.writer);
  if (options.folder_is_open && first) options.folder_is_open(static_cast<bool>(opened));
  if (!opened) return opened.error();
  return std::optional<ChunkStore>(std::move(opened).take());
}

std::vector<std::int64_t> own_chunks(const ChunkStore& store, const CampaignOptions& options) {
  std::vector<std::int64_t> todo = store.missing();
  if (!options.next_chunk)
    std::erase_if(todo, [&](std::int64_t c) { return c % options.shards != options.shard - 1; });
  return todo;
}

}  // namespace gearwright
