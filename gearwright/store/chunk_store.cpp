#include "gearwright/store/chunk_store.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <mutex>
#include <optional>
#include <set>
#include <system_error>
#include <utility>

#include "gearwright/base/output_file.hpp"
#include "gearwright/base/packing.hpp"
#include "gearwright/base/system.hpp"
#include "gearwright/store/chunk_file.hpp"
#include "gearwright/store/chunk_journal.hpp"

namespace gearwright {

namespace fs = std::filesystem;

namespace {

using Depth = ChunkFolder::Depth;
using Record = std::map<std::string, std::string>;  // the journal's table `campaign`

constexpr const char* kJournal = "journal.sqlite";
constexpr std::size_t kNamedDifferences = 3;

Record record_of(const Campaign& campaign, const std::vector<std::string>& rejected_names) {
  std::string names;
  for (const std::string& name : rejected_names) {
    GW_EXPECTS(name.find_first_of(",\n") == std::string::npos);
    names += (names.empty() ? "" : ", ") + name;
  }
  return {{"fingerprint", campaign.fingerprint},
          {"chunks", std::to_string(campaign.chunks)},
          {"counts", names}};
}

// Returns all properties that distinguish one campaign from another, as lines "key = value".
std::string text_of(Record record) {
  return record["fingerprint"] + "\nchunks = " + record["chunks"] +
         "\ncounts = " + record["counts"] + "\n";
}

using Line = std::pair<std::string, std::string>;  // key, value

std::vector<Line> lines_of(const std::string& text) {
  std::vector<Line> lines;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    const std::string line = text.substr(at, end - at);
    at = end + 1;
    const std::size_t sign = line.find(" = ");
    if (sign != std::string::npos) {
      lines.emplace_back(line.substr(0, sign), line.substr(sign + 3));
    } else if (!line.empty()) {
      lines.emplace_back(line, "");
    }
  }
  return lines;
}

std::optional<std::string> value_of(const std::vector<Line>& lines, const std::string& key) {
  for (const Line& line : lines) {
    if (line.first == key) return line.second;
  }
  return std::nullopt;
}

}  // namespace

std::string campaign_differences(const std::string& was, const std::string& is) {
  const std::vector<Line> old_lines = lines_of(was);
  const std::vector<Line> new_lines = lines_of(is);
  std::vector<std::string> found;
  for (const auto& [key, value] : old_lines) {
    const auto now = value_of(new_lines, key);
    if (!now) found.push_back(fmt::format("{} was {} and is not set now", key, value));
    if (now && *now != value)
      found.push_back(fmt::format("{} was {} and is now {}", key, value, *now));
  }
  for (const auto& [key, value] : new_lines) {
    if (!value_of(old_lines, key))
      found.push_back(fmt::format("{} was not set and is now {}", key, value));
  }
  if (found.empty()) return "the settings are the same, but their order or number differs";
  std::string text;
  for (std::size_t i = 0; i < std::min(found.size(), kNamedDifferences); ++i) {
    text += (i > 0 ? "; " : "") + found[i];
  }
  if (found.size() > kNamedDifferences) {
    text += fmt::format("; and {} more", found.size() - kNamedDifferences);
  }
  return text;
}

namespace {

Error refused_folder(const fs::path& folder, const std::string& why) {
  return {"--out", native_text(folder), why, FailureKind::option};
}

// Returns the reason why the folder cannot be opened in the mode `as`, or nothing if it can. `old`
// is the content of the journal. It is empty if there is no journal.
std::optional<Error> refusal(const fs::path& folder, const Record& old, const Record& now,
                             const ChunkFolder& files, OpenAs as) {
  const std::vector<std::int64_t> chunks = files.list();
  if (old.empty() && chunks.empty()) {
    if (as != OpenAs::resume) return std::nullopt;
    return refused_folder(folder, "there is no search to resume; start a search without --resume");
  }
  std::string changed;
  if (!old.empty() && text_of(old) != text_of(now))
    changed = campaign_differences(text_of(old), text_of(now));
  for (std::size_t i = 0; i < chunks.size() && old.empty() && changed.empty(); ++i) {
    const auto read = files.read(chunks[i], Depth::header);
    if (!read || read->state != ChunkRead::State::foreign) continue;
    changed = fmt::format("{} belongs to another search, and there is no journal",
                          files.path(chunks[i]).filename().string());
  }
  // If the folder contains this campaign without any chunk, the search was killed before its first
  // chunk was finished, and a fresh search may use the folder.
  const bool just_begun = changed.empty() && chunks.empty();
  if (as == OpenAs::fresh && !just_begun) {
    const std::string all = old.empty() ? now.at("chunks") : Record(old)["chunks"];
    return refused_folder(
        folder,
        changed.empty()
            ? fmt::format("this folder contains a search with {} of {} chunks done; continue it "
                          "with --resume, or use another folder",
                          chunks.size(), all)
            : fmt::format("this folder contains another search with {} of {} chunks done ({}); use "
                          "another folder, because --resume needs the original spec",
                          chunks.size(), all, changed));
  }
  if (changed.empty()) return std::nullopt;
  return refused_folder(folder,
                        "this folder contains a search with another spec (" + changed +
                            "); use the original spec of that search, or use another folder");
}

}  // namespace

struct ChunkStore::Impl {
  Impl(const fs::path& folder, std::int64_t chunk_count, std::size_t constraint_count,
       std::string writer_name, ChunkFolder chunk_files,
       const std::vector<std::string>& rejected_names)
      : count(chunk_count),
        constraints(constraint_count),
        writer(std::move(writer_name)),
        files(std::move(chunk_files)),
        journal(folder / kJournal, rejected_names),
        counted(static_cast<std::size_t>(chunk_count), false) {
    sum.rejected.assign(constraints, 0);
  }

  bool ours(std::int64_t chunk) const { return chunk >= 0 && chunk < count; }
  std::vector<std::int64_t> finished() const;
  std::optional<std::string> retire(std::int64_t chunk);
  ChunkRead read(std::int64_t chunk, Depth depth);
  void add(std::int64_t chunk, const ChunkCounts& counts);
  void square_accounts();

  std::int64_t count;
  std::size_t constraints;
  std::string writer;
  ChunkFolder files;
  std::vector<std::string> notes;

  std::mutex mutex;  // protects all members below
  ChunkJournal journal;
  std::vector<bool> counted;  // per chunk, true if `sum` includes it
  ChunkCounts sum;
};

// Returns the campaign's finished chunks. Files with numbers outside the campaign are ignored.
std::vector<std::int64_t> ChunkStore::Impl::finished() const {
  std::vector<std::int64_t> chunks = files.list();
  while (!chunks.empty() && !ours(chunks.back())) chunks.pop_back();
  return chunks;
}

// Renames a broken chunk and returns its fault. The chunk is first read again under the lock,
// because another process may have renamed or replaced it. Returns nothing if the chunk is no
// longer broken or no longer exists.
std::optional<std::string> ChunkStore::Impl::retire(std::int64_t chunk) {
  const std::lock_guard lock(mutex);
  ChunkJournal::Transaction transaction(journal);
  const auto again = files.read(chunk, Depth::payload);
  if (again && again->state == ChunkRead::State::whole) return std::nullopt;
  if (again) files.set_aside(chunk);
  journal.forget(chunk);
  transaction.commit();
  sum = {0, 0, std::vector<std::int64_t>(constraints, 0)};  // the contribution of this chunk to the
                                                            // sum is no longer known
  counted.assign(counted.size(), false);
  return again ? std::optional(again->damage) : std::nullopt;
}

// Reads a finished chunk. Throws IoError if the chunk is missing or broken.
ChunkRead ChunkStore::Impl::read(std::int64_t chunk, Depth depth) {
  GW_EXPECTS(ours(chunk));
  const std::string path = native_text(files.path(chunk));
  for (;;) {  // repeated only if another process replaces a broken chunk in the meantime
    auto read = files.read(chunk, depth);
    if (!read) throw IoError("cannot read " + path + ": there is no such chunk");
    if (read->state == ChunkRead::State::whole) return *std::move(read);
    if (const auto damage = retire(chunk)) {
      throw IoError(path + " " + *damage + "; it was renamed, and --resume computes it again");
    }
  }
}

void ChunkStore::Impl::add(std::int64_t chunk, const ChunkCounts& counts) {
  const std::lock_guard lock(mutex);
  const auto i = static_cast<std::size_t>(chunk);
  if (counted[i]) return;
  counted[i] = true;
  sum.tested += counts.tested;
  sum.feasible += counts.feasible;
  for (std::size_t k = 0; k < constraints; ++k) sum.rejected[k] += counts.rejected[k];
}

// Checks every chunk file. Adds rows to the journal for files without a row, and removes the rows
// of chunks without a file.
void ChunkStore::Impl::square_accounts() {
  // A process writes the file before the row, and this function reads the rows before the files.
  // Therefore, a row without a file shows that the file was lost.
  const std::set<std::int64_t> rows = journal.chunks();
  std::set<std::int64_t> lost = rows;
  std::vector<ChunkRow> without_row;
  for (const std::int64_t chunk : finished()) {
    lost.erase(chunk);
    const auto read = files.read(chunk, Depth::payload);
    if (!read) continue;  // another process has just renamed the file and updated its row
    if (read->state == ChunkRead::State::whole) {
      add(chunk, read->counts);
      if (rows.count(chunk) == 0) without_row.push_back({chunk, read->counts, read->size});
    } else if (const auto damage = retire(chunk)) {
      notes.push_back(fmt::format("{} {}; it was renamed to .damaged and will be computed again",
                                  native_text(files.path(chunk)), *damage));
    }
  }
  if (lost.empty() && without_row.empty()) return;
  ChunkJournal::Transaction transaction(journal);
  for (const ChunkRow& row : without_row) journal.found(row);
  for (const std::int64_t chunk : lost) {
    if (files.there(chunk)) continue;
    journal.forget(chunk);
    notes.push_back(
        fmt::format("{} is in the journal but not in the folder; it will be computed again",
                    native_text(files.path(chunk))));
  }
  transaction.commit();
}

Result<ChunkStore> ChunkStore::open(const fs::path& folder, const Campaign& campaign,
                                    const std::vector<std::string>& rejected_names, OpenAs as,
                                    std::string writer) {
  GW_EXPECTS(campaign.chunks >= 0 && rejected_names.size() <= kMaxConstraints);
  const Record record = record_of(campaign, rejected_names);
  ChunkFolder files(folder / "chunks", crc32_of(text_of(record)));
  // The mode is checked before the folder is made, so that a rejected request changes nothing.
  if (!is_in(folder)) {
    if (auto error = refusal(folder, {}, record, files, as)) return *std::move(error);
  }
  make_folder(files.folder());
  auto impl = std::make_unique<Impl>(folder, campaign.chunks, rejected_names.size(),
                                     std::move(writer), std::move(files), rejected_names);
  {
    // If several processes start at the same moment, one begins the campaign, and the others find
    // the campaign in the journal.
    ChunkJournal::Transaction transaction(impl->journal);
    const Record old = impl->journal.campaign();
    if (auto error = refusal(folder, old, record, impl->files, as)) return *std::move(error);
    if (old.empty()) impl->journal.begin(record);
    transaction.commit();
  }
  impl->files.remove_stale_parts();
  impl->square_accounts();
  return ChunkStore(std::move(impl));
}

bool ChunkStore::is_in(const fs::path& folder) { return path_exists(folder / kJournal); }

ChunkStore::ChunkStore(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
ChunkStore::ChunkStore(ChunkStore&&) noexcept = default;
ChunkStore& ChunkStore::operator=(ChunkStore&&) noexcept = default;
ChunkStore::~ChunkStore() = default;

bool ChunkStore::done(std::int64_t chunk) const {
  GW_EXPECTS(impl_->ours(chunk));
  return impl_->files.there(chunk);
}

std::vector<std::int64_t> ChunkStore::missing() const {
  const std::vector<std::int64_t> finished = impl_->finished();
  std::vector<std::int64_t> chunks;
  auto next = finished.begin();
  for (std::int64_t chunk = 0; chunk < impl_->count; ++chunk) {
    if (next != finished.end() && *next == chunk) {
      ++next;
    } else {
      chunks.push_back(chunk);
    }
  }
  return chunks;
}

void ChunkStore::put(std::int64_t chunk, std::string_view bytes, const ChunkCounts& counts) {
  GW_EXPECTS(impl_->ours(chunk) && counts.rejected.size() == impl_->constraints);
  impl_->files.write(chunk, bytes, counts);
  {
    const std::lock_guard lock(impl_->mutex);
    impl_->journal.finish({chunk, counts, static_cast<std::int64_t>(bytes.size())}, impl_->writer);
  }
  impl_->add(chunk, counts);
}

std::string ChunkStore::get(std::int64_t chunk) const {
  return impl_->read(chunk, Depth::payload).payload;
}

ChunkCounts ChunkStore::counts(std::int64_t chunk) const {
  return impl_->read(chunk, Depth::header).counts;
}

ChunkCounts ChunkStore::totals() const {
  for (const std::int64_t chunk : impl_->finished()) {
    {
      const std::lock_guard lock(impl_->mutex);
      if (impl_->counted[static_cast<std::size_t>(chunk)]) continue;
    }
    impl_->add(chunk, counts(chunk));
  }
  const std::lock_guard lock(impl_->mutex);
  return impl_->sum;
}

const std::vector<std::string>& ChunkStore::notes() const { return impl_->notes; }

}  // namespace gearwright
