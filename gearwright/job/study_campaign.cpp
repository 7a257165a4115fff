#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "gearwright/base/packing.hpp"
#include "gearwright/job/scatter_study.hpp"
#include "gearwright/spec/parse_spec.hpp"
#include "gearwright/store/chunk_store.hpp"

namespace gearwright {

namespace {

constexpr std::int64_t kMostChunks = 4096;  // greatest number of chunks; with fewer designs, each
                                            // chunk is one design

// Returns the checksums of the files that the modifications name. The spec contains only the names
// of these files.
std::string files_fingerprint(const JobSpec& spec) {
  std::string lines;
  for (const char* gear : {"gear1", "gear2"}) {
    const Json& tables = spec.tree->tables;
    if (!tables.contains(gear) || !tables[gear].contains("modifications")) continue;
    for (const auto& [key, value] : tables[gear]["modifications"].items())
      if (key.ends_with("topography") && value.is_string())
        lines += fmt::format("{}.modifications.{} has the checksum {:08x}\n", gear, key,
                             crc32_of(text_of_file(spec.folder / value.get<std::string>())));
  }
  return lines;
}

std::string study_fingerprint(const JobSpec& spec, const std::vector<ListedDesign>& list,
                              std::int64_t chunk) {
  std::string numbers;
  for (const ListedDesign& d : list) numbers += fmt::format("{} {}\n", d.number, d.trial);
  return search_fingerprint(spec, chunk, {"rating", "errors", "contact", "load", "scatter"}) +
         files_fingerprint(spec) +
         fmt::format("designs = {}\nlist of designs = {:08x}\n", list.size(), crc32_of(numbers));
}

}  // namespace

Result<StudyRun> run_study_campaign(const JobSpec& spec, const Search& search,
                                    const std::vector<ListedDesign>& list,
                                    const StudyOptions& options, std::vector<Json>& rows) {
  const auto all = static_cast<std::int64_t>(list.size());
  const std::int64_t chunk = (all + kMostChunks - 1) / kMostChunks;
  const std::int64_t chunks = (all + chunk - 1) / chunk;
  const auto size_of = [&](std::int64_t c) { return std::min(chunk, all - c * chunk); };
  auto opened = open_campaign({study_fingerprint(spec, list, chunk), chunks}, {"refused"}, options,
                              std::nullopt);
  if (!opened) return opened.error();
  StudyRun run;
  run.of = all;
  std::optional<ChunkStore> joined = std::move(opened).take();
  if (!joined) return run;
  ChunkStore store = *std::move(joined);
  run.notes = store.notes();
  const auto count_done = [&] {
    run.done = all;
    for (const std::int64_t c : store.missing()) run.done -= size_of(c);
  };
  ChunkQueue queue(own_chunks(store, options), chunks, options.next_chunk);
  std::optional<Error> failed;
  while (const auto c = queue.next()) {
    std::string text;
    ChunkCounts counts{size_of(*c), 0, {0}};
    for (std::int64_t i = *c * chunk; i < *c * chunk + size_of(*c) && !failed; ++i) {
      count_done();
      if (options.on_design) options.on_design(run.done, all);
      const auto row = study_row(spec, search, list[static_cast<std::size_t>(i)], options);
      if (!row) {
        failed = row.error();
        break;
      }
      ++(row->contains("reason") ? counts.rejected[0] : counts.feasible);
      text += json_text(*row) + "\n";
    }
    if (failed) break;
    store.put(*c, text, counts);
  }
  const bool ours = options.finish_together ? options.finish_together() : true;
  if (failed) return *failed;
  count_done();
  if (options.on_design) options.on_design(run.done, all);
  if (!ours || run.done < all) return run;
  for (std::int64_t c = 0; c < chunks; ++c) {
    const std::string text = store.get(c);
    for (std::size_t from = 0; from < text.size();) {
      const std::size_t end = text.find('\n', from);
      rows.push_back(parse_json(std::string_view(text).substr(from, end - from)));
      from = end + 1;
    }
  }
  run.finished = true;
  return run;
}

}  // namespace gearwright
