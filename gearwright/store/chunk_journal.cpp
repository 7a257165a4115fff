#include "gearwright/store/chunk_journal.hpp"

#include <fmt/format.h>
#include <sqlite3.h>

#include <algorithm>
#include <cstring>

#include "gearwright/base/contract.hpp"
#include "gearwright/base/output_file.hpp"
#include "gearwright/base/system.hpp"

namespace gearwright {

namespace fs = std::filesystem;

namespace {

// A call waits this long for a lock and then fails. A process that holds a lock for longer is
// assumed to hang.
constexpr int kBusyMilliseconds = 60'000;
constexpr int kLongestNap = 5;  // longest wait between two attempts, ms

// SQLite calls this function while it waits for a lock. `before` is the number of earlier calls.
// SQLite tries again if the result is 1. With SQLite's default handler, which sleeps up to 100 ms,
// two processes that wrote continuously kept each other waiting for 20 s.
int nap(void*, int before) {
  const int longest_of_all = kBusyMilliseconds / kLongestNap;
  if (before >= longest_of_all) return 0;
  sqlite3_sleep(std::min(before + 1, kLongestNap));
  return 1;
}

bool is_word(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}

// Returns the quoted column names of the constraints. SQLite ignores case, so names that differ
// only in case get a number.
std::vector<std::string> column_names(const std::vector<std::string>& constraints) {
  std::set<std::string> taken = {"chunk", "tested", "feasible", "bytes", "writer", "finished"};
  std::vector<std::string> columns;
  for (const std::string& name : constraints) {
    std::string word;
    for (const char c : name) word += is_word(c) ? c : '_';
    if (word.empty()) word.push_back('_');
    std::string column = word;
    for (int n = 2;; ++n) {
      std::string lower;
      for (const char c : column) lower += c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c;
      if (taken.insert(lower).second) break;
      column = fmt::format("{}_{}", word, n);
    }
    columns.push_back('"' + column + '"');
  }
  return columns;
}

}  // namespace

void ChunkJournal::CloseDatabase::operator()(sqlite3* database) const { sqlite3_close(database); }
void ChunkJournal::CloseStatement::operator()(sqlite3_stmt* statement) const {
  sqlite3_finalize(statement);
}

ChunkJournal::ChunkJournal(const fs::path& path, const std::vector<std::string>& constraints)
    : path_(path), columns_(column_names(constraints)) {
  sqlite3* database = nullptr;
  const std::u8string name = path.u8string();  // SQLite reads names in UTF-8 on all systems
  const int status = sqlite3_open_v2(reinterpret_cast<const char*>(name.c_str()), &database,
                                     SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE, nullptr);
  database_.reset(database);  // required even after a failure, because fail() reads the message
                              // from the connection
  if (status != SQLITE_OK) fail();
  if (sqlite3_busy_handler(database, nap, nullptr) != SQLITE_OK) fail();
  // A rollback journal is used, because the write-ahead log needs memory shared by all writers,
  // which cluster nodes do not have.
  run("PRAGMA journal_mode = DELETE");
  // Writes are not synchronous, because each row would otherwise wait three times until the chunks
  // of all threads are on the disk. The journal need not survive a power failure, because the chunk
  // files contain the same data.
  run("PRAGMA synchronous = OFF");
}

void ChunkJournal::fail() const {
  std::string why = sqlite3_errmsg(database_.get());
  const int code = sqlite3_errcode(database_.get());
  const int reason = database_ ? sqlite3_system_errno(database_.get()) : 0;
  if (reason != 0 && (code == SQLITE_IOERR || code == SQLITE_CANTOPEN || code == SQLITE_FULL)) {
    why += fmt::format(" ({})", std::strerror(reason));
  }
  if (code == SQLITE_CORRUPT || code == SQLITE_NOTADB) {
    why +=
        "; move the journal to another folder and continue with --resume; the chunk files are "
        "complete without the journal";
  }
  throw IoError(fmt::format("the journal {}: {}", native_text(path_), why));
}

ChunkJournal::Statement ChunkJournal::prepare(const std::string& sql) const {
  sqlite3_stmt* statement = nullptr;
  const int status = sqlite3_prepare_v2(database_.get(), sql.c_str(),
                                        static_cast<int>(sql.size()) + 1, &statement, nullptr);
  if (status != SQLITE_OK) fail();
  return Statement(statement);
}

void ChunkJournal::bind(const Statement& statement, int place, std::int64_t value) const {
  if (sqlite3_bind_int64(statement.get(), place, value) != SQLITE_OK) fail();
}

void ChunkJournal::bind(const Statement& statement, int place, const std::string& text) const {
  const int status = sqlite3_bind_text64(statement.get(), place, text.data(), text.size(),
                                         SQLITE_TRANSIENT, SQLITE_UTF8);
  if (status != SQLITE_OK) fail();
}

bool ChunkJournal::step(const Statement& statement) const {
  const int status = sqlite3_step(statement.get());
  if (status != SQLITE_ROW && status != SQLITE_DONE) {
    // SQLite stores the message in the connection, so sqlite3_reset() does not erase it.
    // Without the reset, a lock would remain.
    sqlite3_reset(statement.get());
    fail();
  }
  return status == SQLITE_ROW;
}

void ChunkJournal::run(const std::string& sql) {
  const Statement statement = prepare(sql);
  while (step(statement)) {
  }
}

ChunkJournal::Transaction::Transaction(ChunkJournal& journal) : journal_(journal) {
  // IMMEDIATE takes the write lock at once. Otherwise, two transactions that begin as readers and
  // then write would block each other.
  journal_.run("BEGIN IMMEDIATE");
}

ChunkJournal::Transaction::~Transaction() {
  if (open_) sqlite3_exec(journal_.database_.get(), "ROLLBACK", nullptr, nullptr, nullptr);
}

void ChunkJournal::Transaction::commit() {
  journal_.run("COMMIT");
  open_ = false;
}

std::map<std::string, std::string> ChunkJournal::campaign() {
  std::map<std::string, std::string> found;
  const Statement table =
      prepare("SELECT 1 FROM sqlite_master WHERE type = 'table' AND name = 'campaign'");
  if (!step(table)) return found;
  const Statement rows = prepare("SELECT key, value FROM campaign");
  const auto text = [&](int column) {
    const auto* start = reinterpret_cast<const char*>(sqlite3_column_text(rows.get(), column));
    const auto length = static_cast<std::size_t>(sqlite3_column_bytes(rows.get(), column));
    return start != nullptr ? std::string(start, length) : std::string();
  };
  while (step(rows)) found[text(0)] = text(1);
  return found;
}

void ChunkJournal::begin(const std::map<std::string, std::string>& campaign) {
  run("CREATE TABLE campaign (key TEXT PRIMARY KEY, value TEXT)");
  std::string counts;
  for (const std::string& column : columns_) counts += column + " INTEGER NOT NULL, ";
  run("CREATE TABLE chunks (chunk INTEGER PRIMARY KEY, tested INTEGER NOT NULL, "
      "feasible INTEGER NOT NULL, " +
      counts + "bytes INTEGER NOT NULL, writer TEXT, finished TEXT)");
  for (const auto& [key, value] : campaign) {
    const Statement insert = prepare("INSERT INTO campaign (key, value) VALUES (?, ?)");
    bind(insert, 1, key);
    bind(insert, 2, value);
    step(insert);
  }
}

std::set<std::int64_t> ChunkJournal::chunks() {
  std::set<std::int64_t> found;
  const Statement rows = prepare("SELECT chunk FROM chunks");
  while (step(rows)) found.insert(sqlite3_column_int64(rows.get(), 0));
  return found;
}

// `verb` is the SQL verb, which determines how an existing row is treated. If `writer` is null, the
// columns `writer` and `finished` of the row are null.
void ChunkJournal::insert(const char* verb, const ChunkRow& row, const std::string* writer) {
  GW_EXPECTS(row.counts.rejected.size() == columns_.size());
  Statement& statement = inserts_[verb];
  if (!statement) {
    std::string columns;
    std::string places;
    for (const std::string& column : columns_) {
      columns += column + ", ";
      places += "?, ";
    }
    statement = prepare(fmt::format(
        "{} INTO chunks (chunk, tested, feasible, {}bytes, writer, finished) VALUES (?, ?, ?, {}?, "
        "?, {})",
        verb, columns, places,
        writer != nullptr ? "strftime('%Y-%m-%dT%H:%M:%SZ', 'now')" : "NULL"));
  }
  int place = 0;
  bind(statement, ++place, row.chunk);
  bind(statement, ++place, row.counts.tested);
  bind(statement, ++place, row.counts.feasible);
  for (const std::int64_t n : row.counts.rejected) bind(statement, ++place, n);
  bind(statement, ++place, row.bytes);
  if (writer != nullptr) bind(statement, ++place, *writer);
  step(statement);
  sqlite3_reset(statement.get());
}

void ChunkJournal::finish(const ChunkRow& row, const std::string& writer) {
  insert("INSERT OR REPLACE", row, &writer);
}

void ChunkJournal::found(const ChunkRow& row) { insert("INSERT OR IGNORE", row, nullptr); }

void ChunkJournal::forget(std::int64_t chunk) {
  const Statement statement = prepare("DELETE FROM chunks WHERE chunk = ?");
  bind(statement, 1, chunk);
  step(statement);
}

}  // namespace gearwright
