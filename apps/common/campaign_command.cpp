#include "apps/common/campaign_command.hpp"

#include <charconv>

#include "gearwright/base/system.hpp"

namespace gearwright::apps {

namespace {

// Describes one of several processes that share a folder. Shards are counted from 1.
struct Shard {
  int which = 1, of = 1;
};

// Reads a shard such as "3/8". Returns nothing if the text is not a shard.
std::optional<Shard> parse_shard(const std::string& text) {
  const auto slash = text.find('/');
  if (slash == std::string::npos) return std::nullopt;
  Shard s;
  const auto number = [&](std::size_t from, std::size_t to, int& value) {
    const char* end = text.data() + to;
    const auto [at, error] = std::from_chars(text.data() + from, end, value);
    return error == std::errc() && at == end;
  };
  if (!number(0, slash, s.which) || !number(slash + 1, text.size(), s.of)) return std::nullopt;
  return s.which >= 1 && s.which <= s.of && s.of <= 1'000'000 ? std::optional(s) : std::nullopt;
}

}  // namespace

std::optional<std::string> fill_campaign(const CampaignCommand& c, const Together* together,
                                         const std::string& verb, const std::string& noun,
                                         CampaignOptions& options) {
  if (c.out && c.out->empty()) return "--out needs the name of a folder";
  if (!c.out && (c.resume || c.shard))
    return std::string(c.resume ? "--resume" : "--shard") + " needs --out DIR, the folder of the " +
           noun;
  if (c.shard) {
    const auto shard = parse_shard(*c.shard);
    if (together) return "--shard cannot be used under mpirun, whose ranks share one queue";
    if (!shard) return "--shard takes i/N with 1 <= i <= N, for example --shard 3/8";
    options.shard = shard->which;
    options.shards = shard->of;
    options.many = true;
  }
  if (together && !c.out)
    return "a " + noun + " on several ranks needs --out DIR, the folder that they share";
  options.out = c.out.value_or("");
  options.resume = c.resume;
  options.writer = c.shard ? "shard " + *c.shard : verb;
  if (!together) return std::nullopt;
  options.writer = "rank " + std::to_string(together->rank);
  options.many = together->rank > 0;
  options.together = true;
  options.next_chunk = together->next_chunk;
  options.folder_is_open = together->folder_is_open;
  options.finish_together = together->finish_together;
  return std::nullopt;
}

int threads_of(const CampaignCommand& c, const Together* together) {
  return together && c.threads == 0 ? 1 : c.threads;
}

std::string written_files(const std::vector<std::filesystem::path>& files) {
  std::string text;
  for (const auto& file : files) text += "  " + native_text(file) + "\n";
  return text.empty() ? text : "\nfiles\n" + text;
}

}  // namespace gearwright::apps
