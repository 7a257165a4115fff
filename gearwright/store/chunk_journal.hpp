// Reads and writes the journal of a campaign, which is an SQLite database. A campaign is a search
// that is divided into chunks. The journal is read by users and by the progress output, and its
// locks coordinate the processes that write.
//
//   campaign(key, value)    `fingerprint`, `chunks`, `counts`
//   chunks(chunk, tested, feasible, <one column for each constraint>, bytes, writer, finished)
//
// `bytes` is the length of the payload, and `finished` is the time in UTC. Both `writer` and
// `finished` are null in a row that was restored from the chunk file. No result of a search depends
// on the journal.
//
// Internal to store/, used through chunk_store.hpp.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "gearwright/store/chunk_store.hpp"

struct sqlite3;
struct sqlite3_stmt;

namespace gearwright {

struct ChunkRow {
  std::int64_t chunk = 0;
  ChunkCounts counts;
  std::int64_t bytes = 0;
};

/// The journal is not thread-safe. The store locks a mutex around every call.
///
/// Throws    IoError from every member, with SQLite's message and the path
class ChunkJournal {
 public:
  /// Opens the journal, or makes an empty one.
  ChunkJournal(const std::filesystem::path& path, const std::vector<std::string>& constraints);

  /// Excludes all other writers until commit(). The destructor undoes an uncommitted transaction.
  class Transaction {
   public:
    explicit Transaction(ChunkJournal& journal);
    Transaction(const Transaction&) = delete;
    Transaction& operator=(const Transaction&) = delete;
    ~Transaction();
    void commit();

   private:
    ChunkJournal& journal_;
    bool open_ = true;
  };

  /// Returns the contents of the table `campaign`. The result is empty before a campaign has begun.
  /// The caller must hold a transaction.
  std::map<std::string, std::string> campaign();
  /// Makes the tables and begins the campaign. The caller must hold a transaction.
  void begin(const std::map<std::string, std::string>& campaign);

  std::set<std::int64_t> chunks();
  /// Records a chunk that was just finished. An existing row is replaced.
  void finish(const ChunkRow& row, const std::string& writer);
  /// Records a chunk whose file was found. An existing row remains unchanged.
  void found(const ChunkRow& row);
  void forget(std::int64_t chunk);

 private:
  struct CloseDatabase {
    void operator()(sqlite3* database) const;
  };
  struct CloseStatement {
    void operator()(sqlite3_stmt* statement) const;
  };
  using Statement = std::unique_ptr<sqlite3_stmt, CloseStatement>;

  [[noreturn]] void fail() const;
  void run(const std::string& sql);
  Statement prepare(const std::string& sql) const;
  void bind(const Statement& statement, int place, std::int64_t value) const;
  void bind(const Statement& statement, int place, const std::string& text) const;
  bool step(const Statement& statement) const;  // true if there is a row
  void insert(const char* verb, const ChunkRow& row, const std::string* writer);

  std::filesystem::path path_;
  std::vector<std::string> columns_;                  // quoted column names of the constraints
  std::unique_ptr<sqlite3, CloseDatabase> database_;  // outlives its statements
  std::map<std::string, Statement> inserts_;          // insert statements, by SQL verb
};

}  // namespace gearwright
