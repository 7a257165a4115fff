#include "gearwright/job/search_job.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <mutex>
#include <nlohmann/json.hpp>
#include <numeric>

#include "gearwright/base/version.hpp"
#include "gearwright/job/loaded_designs.hpp"
#include "gearwright/job/search_files.hpp"
#include "gearwright/job/search_workers.hpp"
#include "gearwright/spec/json.hpp"
#include "gearwright/spec/parse_spec.hpp"
#include "gearwright/spec/read_search.hpp"

namespace gearwright {

namespace {

constexpr std::int64_t kMinChunk = 1 << 18;
constexpr std::int64_t kShare =
    1 << 16;  // greatest number of trials that a thread takes at a time in a search in memory
// Greatest default number of trials in a chunk. A thread keeps the designs of its chunk in memory.
constexpr std::int64_t kMaxChunk = 1 << 22;

void flatten(const Json& node, const std::string& path, std::string& lines) {
  if (node.is_object()) {
    for (const auto& [key, value] : node.items())
      flatten(value, path.empty() ? key : path + "." + key, lines);
    return;
  }
  lines += path + " = " + json_text(node) + "\n";
}

// Runs the search with all designs in memory. It serves small searches and searches without files.
SearchRun run_in_memory(const JobSpec& spec, const Search& search, std::int64_t chunk,
                        const SearchOptions& options) {
  SearchRun run = begun(spec, search);
  run.chunks = (*search.space().size() + chunk - 1) / chunk;
  std::vector<std::int64_t> todo(static_cast<std::size_t>(run.chunks));
  std::iota(todo.begin(), todo.end(), 0);
  BestDesigns best(search.problem(),
                   designs_to_keep(search.problem(), options.top.value_or(kDefaultDesigns)));
  SearchCounts counts;
  std::map<std::int64_t, ChunkFinds> all;  // filled only if files are written
  std::mutex mutex;
  SearchWorkers workers(search, chunk, std::move(todo), options);
  workers.run([&](std::int64_t c, ChunkFinds finds, const SearchCounts& n) {
    const std::lock_guard lock(mutex);
    counts += n;
    for (const DesignRow& row : finds.designs) best.add(row);
    if (!options.out.empty()) all.emplace(c, std::move(finds));
    ++run.chunks_done;
  });
  run.stopped = workers.stopped();
  if (run.stopped) return run;
  run.answer = std::move(best).answer(counts);
  if (!load_designs(spec, search, options, run)) return run;
  if (!complete_regions(search, options, run)) return run;
  if (!look_for_changes(search, options, run)) return run;
  run.finished = true;
  if (!options.out.empty()) {
    auto at = all.begin();
    run.files =
        write_search_files(spec, search, run, options.out, options.top, [&](ChunkFinds& finds) {
          if (at == all.end()) return false;
          finds = std::move((at++)->second);
          return true;
        });
  }
  return run;
}

// Returns the number of trials in a chunk, for a search with this number of trials.
std::int64_t chunk_size(const SearchProblem& problem, std::int64_t trials) {
  constexpr std::int64_t kChunks = 4096;
  const std::int64_t size = std::clamp((trials + kChunks - 1) / kChunks, kMinChunk, kMaxChunk);
  if (!problem.shift_step) return size;
  // The grid points of a chunk must fit into memory. The area of a region is about one square
  // module, so the number of grid points follows approximately from the number of trials. The chunk
  // size is limited accordingly.
  constexpr double kPoints = 5e4;
  const double step = *problem.shift_step;
  return std::clamp<std::int64_t>(static_cast<std::int64_t>(kPoints * step * step), 1, size);
}

}  // namespace

namespace {

// Returns the factors of a rating that are 1, because [rating] does not give their inputs. A rating
// by VDI 2736 has no factors of the oil and of the roughness.
std::vector<AssumedFactor> assumed_factors(const JobSpec& spec) {
  constexpr std::array kFactors{AssumedFactor{"K_A", "K_A", "application_factor"},
                                AssumedFactor{"K_gamma", "K_γ", "mesh_load_factor"},
                                AssumedFactor{"Z_NT", "Z_NT", "life_h"},
                                AssumedFactor{"Z_L", "Z_L", "lubricant_viscosity_40C_mm2_s"},
                                AssumedFactor{"Z_v", "Z_v", "speed_rpm"},
                                AssumedFactor{"Z_R", "Z_R", "flank_roughness_um"},
                                AssumedFactor{"Y_NT", "Y_NT", "life_h"},
                                AssumedFactor{"Y_R_relT", "Y_RrelT", "root_roughness_um"}};
  const bool plastic = spec.rating.input.edition == RatingEdition::vdi_2736;
  std::vector<AssumedFactor> assumed;
  constexpr std::size_t kOfPlastics = 2;  // the first two factors also apply to VDI 2736
  for (std::size_t i = 0; i < (plastic ? kOfPlastics : kFactors.size()); ++i)
    if (!spec.given.contains(fmt::format("rating.{}", kFactors[i].input)))
      assumed.push_back(kFactors[i]);
  return assumed;
}

}  // namespace

SearchRun begun(const JobSpec& spec, const Search& search) {
  SearchRun run;
  run.problem = &search.problem();
  const Json& tables = spec.tree->tables;
  run.pair_not_read = tables.contains("pair");
  for (const char* gear : {"gear1", "gear2"})
    if (tables.contains(gear) && tables.at(gear).contains("teeth")) run.teeth_not_read = true;
  run.rating_not_read = spec.rating.given && !search.problem().rating;
  if (search.problem().rating && has_default_face_load(spec))
    run.default_face_load = spec.rating.input.face_load_factor;
  if (search.problem().rating) run.assumed = assumed_factors(spec);
  return run;
}

std::string search_fingerprint(const JobSpec& spec, std::int64_t chunk,
                               const std::vector<std::string>& more) {
  const Json& tree = spec.tree->tables;
  std::string lines;
  std::vector<std::string> tables{"search", "gear1", "gear2"};
  if (spec.search && spec.search->rating) tables.emplace_back("rating");
  if (spec.search && spec.search->loads_designs()) tables.insert(tables.end(), {"errors", "load"});
  tables.insert(tables.end(), more.begin(), more.end());
  for (const std::string& table : tables)
    if (tree.contains(table)) flatten(tree[table], table, lines);
  lines += fmt::format("trials of a chunk = {}\nversion = {}\n", chunk, kVersion);
  return lines;
}

Result<SearchRun> run_search(const JobSpec& spec, const Search& search,
                             const SearchOptions& options) {
  if (!options.out.empty()) {
    if (auto error = refuse_folder()) return *error;
  }
  if (options.out.empty() && (options.resume || options.shards > 1)) {
    const std::string flag = options.resume ? "--resume" : "--shard";
    return Error{flag, "", "needs --out DIR, the folder of the search", FailureKind::option};
  }
  if (auto error = refuse_large(search, options)) return *error;
  const std::int64_t trials = *search.space().size();
  const double chunks =
      std::ceil(static_cast<double>(trials) /
                static_cast<double>(options.chunk.value_or(chunk_size(search.problem(), trials))));
  if (chunks > kMaxChunks) {
    return Error{
        "search", fmt::format("{:.3g}", static_cast<double>(trials)),
        fmt::format(
            "the search has {:.3g} chunks of candidates, but at most {} are allowed; divide the "
            "list of modules or the band of `pinion_teeth` among several searches{}",
            chunks, kMaxChunks, options.chunk ? ", or use a larger --chunk" : "")};
  }
  if (trials == 0) return no_tooth_numbers();
  const std::int64_t chunk = options.chunk.value_or(chunk_size(search.problem(), trials));
  const bool campaign =
      !options.out.empty() &&
      (trials > chunk || options.many || options.together || options.resume || options.chunk);
  if (!campaign && !options.out.empty()) {
    if (auto error = refuse_other_search(options.out, spec)) return *error;
  }
  return campaign
             ? run_campaign(spec, search, chunk, options)
             : Result<SearchRun>(run_in_memory(spec, search, std::min(chunk, kShare), options));
}

}  // namespace gearwright
