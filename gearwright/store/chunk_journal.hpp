// The account of a campaign in SQLite, for people, progress lines and meeting other writers.
//
//   campaign(key, value)    `fingerprint`, `chunks`, `counts`
//   chunks(chunk, tested, feasible, <one column for each constraint>, bytes, writer, finished)
//
// `bytes` is the length of the payload, `finished` the time in UTC. Both `writer` and `finished`
// are null in a row that was made up later from its file. Nothing that a search gives depends on
// what stands here.
//
// Internal to store/: chunk_store.hpp is the door.
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

/// One row of `chunks`.
struct ChunkRow {
  std::int64_t chunk = 0;
  ChunkCounts counts;
  std::int64_t bytes = 0;
};

/// Not for several threads at once: the store holds its lock.
///
/// Throws    IoError from every member, with SQLite's sentence and the path
class ChunkJournal {
 public:
  /// Opens the journal, or makes an empty one.
  ChunkJournal(const std::filesystem::path& path, const std::vector<std::string>& constraints);

  /// Keeps all other writers out until commit(), or until its end, when it is undone.
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

  /// What `campaign` holds; empty where nobody has begun one. Within a transaction.
  std::map<std::string, std::string> campaign();
  /// Makes the tables and begins the campaign. Within a transaction.
  void begin(const std::map<std::string, std::string>& campaign);

  std::set<std::int64_t> chunks();
  /// A chunk that was finished now; a row that is there already is replaced.
  void finish(const ChunkRow& row, const std::string& writer);
  /// A chunk whose file was found; a row that is there already is the better one.
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
  bool step(const Statement& statement) const;  // whether there is a row
  void insert(const char* verb, const ChunkRow& row, const std::string* writer);

  std::filesystem::path path_;
  std::vector<std::string> columns_;                  // of the constraints, quoted
  std::unique_ptr<sqlite3, CloseDatabase> database_;  // outlives its statements
  std::map<std::string, Statement> inserts_;          // by verb
};

}  // namespace gearwright
