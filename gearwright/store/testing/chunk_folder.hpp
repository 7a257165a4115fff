// Parts shared by the tests of the chunk store: a folder for each test, chunks with known contents,
// SQL queries of the journal, and child processes.
#pragma once

#include <gtest/gtest.h>
#include <sqlite3.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <numeric>
#include <stdexcept>
#include <string>
#include <vector>

#include "gearwright/base/output_file.hpp"
#include "gearwright/base/testing/scratch_folder.hpp"
#include "gearwright/store/chunk_store.hpp"

namespace gearwright::testing::chunks {

namespace fs = std::filesystem;

inline const std::vector<std::string> kNames = {"shift_limits", "contact ratio", "Contact-Ratio",
                                                "bytes"};

inline std::string fingerprint(const std::string& contact_ratio) {
  return "gearwright = 0.1.0\nsearch.chunk = 1000\nsearch.contact_ratio_min = " + contact_ratio +
         "\nsearch.max_module_mm = 5\n";
}

inline Campaign campaign(std::int64_t chunks, const std::string& contact_ratio = "1.2") {
  return {fingerprint(contact_ratio), chunks};
}

// Returns the contents of chunk `k`, which every process can compute. They are bytes of all values,
// up to some hundreds of bytes or none.
inline std::string bytes_of(std::int64_t k, std::size_t length) {
  std::string bytes(length, '\0');
  for (std::size_t i = 0; i < length; ++i) {
    bytes[i] = static_cast<char>(static_cast<std::size_t>(k) * 31 + i * 7 + i / 251);
  }
  return bytes;
}
inline std::string bytes_of(std::int64_t k) {
  return bytes_of(k, static_cast<std::size_t>(k % 5 * 137));
}
inline ChunkCounts counts_of(std::int64_t k) {
  return {1000 + k, k % 7, {k, 2 * k, 3, 1'000'000'000'000}};
}

inline ChunkCounts sum_of(const std::vector<std::int64_t>& chunks) {
  ChunkCounts sum{0, 0, {0, 0, 0, 0}};
  for (const std::int64_t k : chunks) {
    const ChunkCounts c = counts_of(k);
    sum.tested += c.tested;
    sum.feasible += c.feasible;
    for (std::size_t i = 0; i < c.rejected.size(); ++i) sum.rejected[i] += c.rejected[i];
  }
  return sum;
}

inline std::vector<std::int64_t> range(std::int64_t end) {
  std::vector<std::int64_t> all(static_cast<std::size_t>(end));
  std::iota(all.begin(), all.end(), 0);
  return all;
}

inline std::string message_of(const std::function<void()>& act) {
  try {
    act();
  } catch (const IoError& error) {
    return error.what();
  }
  return "";
}

inline bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

// Every column of every row as text.
using Rows = std::vector<std::vector<std::string>>;
inline Rows query(const fs::path& folder, const std::string& sql) {
  Rows rows;
  sqlite3* database = nullptr;
  sqlite3_open_v2((folder / "journal.sqlite").c_str(), &database, SQLITE_OPEN_READWRITE, nullptr);
  char* why = nullptr;
  const auto keep = [](void* out, int n, char** values, char**) {
    auto& row = static_cast<Rows*>(out)->emplace_back();
    for (int i = 0; i < n; ++i) row.emplace_back(values[i] != nullptr ? values[i] : "null");
    return 0;
  };
  sqlite3_exec(database, sql.c_str(), keep, &rows, &why);
  EXPECT_EQ(why, nullptr) << why;
  sqlite3_free(why);
  sqlite3_close(database);
  return rows;
}

class ChunkFolderTest : public ::testing::Test {
 protected:
  Result<ChunkStore> open(OpenAs as, const Campaign& campaign) const {
    return ChunkStore::open(folder_, campaign, kNames, as, "test");
  }
  ChunkStore opened(OpenAs as, const Campaign& campaign) const {
    auto store = open(as, campaign);
    if (!store) throw std::runtime_error(store.error().message());
    return std::move(store).take();
  }
  // Returns the message of a rejection, without its key and value, which must be the folder.
  std::string refusal(OpenAs as, const Campaign& campaign) const {
    const auto store = open(as, campaign);
    if (store) return "";
    EXPECT_EQ(store.error().field, "--out");
    EXPECT_EQ(store.error().value, folder_.string());
    EXPECT_EQ(store.error().message().rfind("--out = " + folder_.string() + ": ", 0), 0u);
    return store.error().message().substr(("--out = " + folder_.string() + ": ").size());
  }
  void put(ChunkStore& store, std::int64_t k) const { store.put(k, bytes_of(k), counts_of(k)); }
  fs::path file(std::int64_t k) const {
    std::string digits = std::to_string(k);
    digits.insert(0, 6 - digits.size(), '0');
    return folder_ / "chunks" / (digits + ".chunk");
  }
  std::vector<std::string> chunk_names() const {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder_ / "chunks")) {
      names.push_back(entry.path().filename().string());
    }
    std::sort(names.begin(), names.end());
    return names;
  }
  std::vector<std::int64_t> journalled() const {
    std::vector<std::int64_t> chunks;
    for (const auto& row : query(folder_, "SELECT chunk FROM chunks ORDER BY chunk")) {
      chunks.push_back(std::stoll(row[0]));
    }
    return chunks;
  }
  // Starts a child process that calls `act`. It exits with 0 if `act` does not throw.
  pid_t child(const std::function<void()>& act) const {
    const pid_t pid = ::fork();
    if (pid != 0) return pid;
    try {
      act();
    } catch (const std::exception& error) {
      ::fprintf(stderr, "child: %s\n", error.what());
      ::_exit(1);
    }
    ::_exit(0);
  }
  static bool went_well(pid_t pid) {
    int status = 0;
    return ::waitpid(pid, &status, 0) == pid && WIFEXITED(status) && WEXITSTATUS(status) == 0;
  }
  // Returns the id of a child process that has ended. No running process has this id.
  pid_t dead_process() const {
    const pid_t pid = child([] {});
    EXPECT_TRUE(went_well(pid));
    return pid;
  }
  static void write(const fs::path& path, const std::string& bytes) {
    std::ofstream(path, std::ios::binary) << bytes;
  }
  static std::string content(const fs::path& path) {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }
  void flip(const fs::path& path, std::size_t at) const {
    std::string bytes = content(path);
    bytes.at(at) = static_cast<char>(bytes.at(at) ^ 0x10);
    write(path, bytes);
  }
  void expect_complete(const ChunkStore& store, std::int64_t n) const {
    EXPECT_TRUE(store.missing().empty());
    EXPECT_EQ(store.totals(), sum_of(range(n)));
    EXPECT_EQ(journalled(), range(n));
    EXPECT_EQ(chunk_names().size(), static_cast<std::size_t>(n));  // no other files remain
    const auto sums = query(folder_, "SELECT sum(tested), sum(feasible) FROM chunks");
    EXPECT_EQ(sums[0][0], std::to_string(sum_of(range(n)).tested));
    EXPECT_EQ(sums[0][1], std::to_string(sum_of(range(n)).feasible));
  }

  ScratchFolder scratch_;
  fs::path root_ = scratch_.path();
  fs::path folder_ = root_ / "runs" / "a";
};

}  // namespace gearwright::testing::chunks
