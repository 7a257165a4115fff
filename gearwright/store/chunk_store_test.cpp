// Tests the folder of a search: finished chunks remain finished, and broken files are detected.
#include "gearwright/store/chunk_store.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <csignal>

#include "gearwright/store/testing/chunk_folder.hpp"

namespace gearwright {

namespace testing {
std::atomic<int> syncs{0};
}

namespace {

using namespace testing::chunks;  // NOLINT(google-build-using-namespace)

using ChunkStoreTest = ChunkFolderTest;

TEST_F(ChunkStoreTest, a_whole_life) {
  {
    ChunkStore store = opened(OpenAs::fresh, campaign(6));
    EXPECT_EQ(store.missing(), range(6));
    EXPECT_EQ(store.totals(), sum_of({}));
    for (const std::int64_t k : {4, 0, 5}) put(store, k);
    EXPECT_EQ(store.missing(), (std::vector<std::int64_t>{1, 2, 3}));
    EXPECT_TRUE(store.done(4));
    EXPECT_FALSE(store.done(3));
    EXPECT_EQ(store.totals(), sum_of({0, 4, 5}));
  }
  {
    ChunkStore store = opened(OpenAs::resume, campaign(6));
    EXPECT_EQ(store.missing(), (std::vector<std::int64_t>{1, 2, 3}));
    EXPECT_EQ(store.totals(), sum_of({0, 4, 5}));
    for (const std::int64_t k : store.missing()) put(store, k);
    put(store, 4);  // an existing chunk is replaced by the same bytes
    expect_complete(store, 6);
    for (const std::int64_t k : range(6)) {
      EXPECT_EQ(store.get(k), bytes_of(k));
      EXPECT_EQ(store.counts(k), counts_of(k));
    }
    EXPECT_TRUE(store.notes().empty());
  }
  // The columns have the names of the constraints, changed so that they are valid and unique.
  const auto row = query(folder_,
                         "SELECT tested, feasible, shift_limits, contact_ratio, Contact_Ratio_2, "
                         "bytes_2, bytes, writer, finished FROM chunks WHERE chunk = 4");
  ASSERT_EQ(row.size(), 1u);
  EXPECT_EQ(std::vector<std::string>(row[0].begin(), row[0].end() - 1),
            (std::vector<std::string>{"1004", "4", "4", "8", "3", "1000000000000", "548", "test"}));
  EXPECT_EQ(row[0].back().size(), std::string("2024-01-01T00:00:00Z").size());
  EXPECT_EQ(query(folder_, "SELECT value FROM campaign WHERE key = 'fingerprint'")[0][0],
            fingerprint("1.2"));
  EXPECT_EQ(query(folder_, "PRAGMA journal_mode")[0][0], "delete");
}

// A put must not wait for the disk. If each row were synced, all threads would wait until the
// chunks of all threads are on the disk.
TEST_F(ChunkStoreTest, a_put_waits_for_no_platter) {
  ChunkStore store = opened(OpenAs::fresh, campaign(40));
  const int before = testing::syncs;
  for (const std::int64_t k : range(40)) put(store, k);
  EXPECT_EQ(testing::syncs - before, 0);
  expect_complete(store, 40);
}

TEST_F(ChunkStoreTest, two_runs_write_the_same_files) {
  {
    ChunkStore store = opened(OpenAs::fresh, campaign(5));
    put(store, 3);
  }
  const std::string first = content(file(3));
  fs::remove_all(folder_);
  auto other = ChunkStore::open(folder_, campaign(5), kNames, OpenAs::join, "another writer");
  ASSERT_TRUE(other) << other.error().message();
  ChunkStore store = std::move(other).take();
  put(store, 3);
  EXPECT_EQ(content(file(3)), first);
}

TEST_F(ChunkStoreTest, a_fresh_search_takes_no_other_ones_place) {
  EXPECT_FALSE(fs::exists(folder_));
  EXPECT_TRUE(contains(refusal(OpenAs::resume, campaign(40)), "there is no search to resume"));
  EXPECT_FALSE(fs::exists(folder_));  // the folder was not created
  fs::create_directories(folder_);
  write(folder_ / "notes.txt", "a note");
  EXPECT_TRUE(contains(refusal(OpenAs::resume, campaign(40)), "there is no search to resume"));
  {
    ChunkStore store = opened(OpenAs::fresh, campaign(40));
    for (const std::int64_t k : {7, 8, 9}) put(store, k);
  }
  EXPECT_EQ(refusal(OpenAs::fresh, campaign(40)),
            "this folder contains a search with 3 of 40 chunks done; continue it with --resume, or "
            "use another folder");
  EXPECT_EQ(refusal(OpenAs::fresh, campaign(41, "1.3")),
            "this folder contains another search with 3 of 40 chunks done "
            "(search.contact_ratio_min was 1.2 and is now 1.3; chunks was 40 and is now 41); use "
            "another folder, "
            "because --resume needs the original spec");
  EXPECT_EQ(opened(OpenAs::join, campaign(40)).missing().size(), 37u);
}

TEST_F(ChunkStoreTest, a_changed_campaign_is_told_by_its_lines) {
  { opened(OpenAs::join, campaign(40)); }
  for (const OpenAs as : {OpenAs::resume, OpenAs::join}) {
    EXPECT_EQ(
        refusal(as, campaign(40, "1.3")),
        "this folder contains a search with another spec (search.contact_ratio_min was 1.2 and is "
        "now 1.3); use the original spec of that search, or use another folder");
  }
  const auto changed = [&](const std::string& text) { return refusal(OpenAs::resume, {text, 40}); };
  EXPECT_TRUE(contains(changed(fingerprint("1.2") + "search.beta = 1 = 2\n"),
                       "(search.beta was not set and is now 1 = 2)"));
  EXPECT_TRUE(
      contains(changed("gearwright = 0.2.0\nsearch.chunk = 2000\n"),
               "(gearwright was 0.1.0 and is now 0.2.0; search.chunk was 1000 and is now 2000; "
               "search.contact_ratio_min was 1.2 and is not set now; and 1 more)"));
  EXPECT_TRUE(
      contains(changed(fingerprint("1.2") + fingerprint("1.2")), "the settings are the same"));
  const auto names = ChunkStore::open(folder_, campaign(40), {"one"}, OpenAs::resume, "test");
  ASSERT_FALSE(names);
  EXPECT_TRUE(contains(names.error().message(), "counts was shift_limits, contact ratio,"));
  EXPECT_TRUE(contains(names.error().message(), " and is now one)"));
  opened(OpenAs::resume, campaign(40));  // none of the rejected requests changed the folder
}

TEST_F(ChunkStoreTest, goes_on_after_a_kill) {
  {
    ChunkStore store = opened(OpenAs::fresh, campaign(9));
    for (const std::int64_t k : range(8)) put(store, k);
  }
  // The test damages the folder. Chunk 2 has no row, and row 6 has no file. File 1 is too short,
  // and file 7 is empty. File 3 has a wrong bit in its payload, and file 4 in its header. File 5 is
  // a copy of chunk 2.
  query(folder_, "DELETE FROM chunks WHERE chunk = 2");
  fs::resize_file(file(1), fs::file_size(file(1)) - 1);
  flip(file(3), fs::file_size(file(3)) - 10);
  flip(file(4), 22);
  fs::copy_file(file(2), file(5), fs::copy_options::overwrite_existing);
  fs::remove(file(6));
  write(file(7), "");
  // There are four unfinished files. They belong to a dead process, to a live process, and to
  // processes of another host, of which one file is recent and one is old.
  char host[256] = {};
  ASSERT_EQ(::gethostname(host, sizeof host - 1), 0);
  const std::string here = std::string(".0.part.") + host + ".";
  const std::string gone = std::to_string(dead_process());
  const std::string dead = file(8).string() + here + gone;
  const std::string live = file(8).string() + here + std::to_string(::getppid());
  const std::string away = file(8).string() + ".0.part.not-" + host + "." + gone;
  const std::string old = file(8).string() + ".1.part.not-" + host + "." + gone;
  for (const std::string& part : {dead, live, away, old}) write(part, "half");
  fs::last_write_time(old, fs::file_time_type::clock::now() - std::chrono::hours(25));

  ChunkStore store = opened(OpenAs::resume, campaign(9));
  EXPECT_FALSE(fs::exists(dead));
  EXPECT_TRUE(fs::exists(live));
  EXPECT_TRUE(fs::exists(away));
  EXPECT_FALSE(fs::exists(old));
  EXPECT_EQ(store.missing(), (std::vector<std::int64_t>{1, 3, 4, 5, 6, 7, 8}));
  EXPECT_EQ(journalled(), (std::vector<std::int64_t>{0, 2}));
  EXPECT_EQ(store.totals(), sum_of({0, 2}));
  EXPECT_EQ(query(folder_, "SELECT tested, bytes, writer, finished FROM chunks WHERE chunk = 2"),
            (Rows{{"1002", "274", "null", "null"}}));
  const std::vector<std::pair<int, std::string>> told = {
      {1, "is 224 bytes long instead of 225 bytes"},
      {3, "has a wrong checksum; it was renamed"},
      {4, "has a wrong checksum in its header"},
      {5, "contains chunk 2"},
      {7, "is only 0 bytes long"},
      {6, "is in the journal but not in"}};
  ASSERT_EQ(store.notes().size(), told.size());
  for (std::size_t i = 0; i < told.size(); ++i) {
    const auto& [k, what] = told[i];
    EXPECT_TRUE(contains(store.notes()[i], file(k).string() + " " + what)) << store.notes()[i];
    EXPECT_EQ(fs::exists(file(k).string() + ".damaged"), k != 6);
    fs::remove(file(k).string() + ".damaged");
  }
  fs::remove(live);
  fs::remove(away);
  for (const std::int64_t k : store.missing()) put(store, k);
  expect_complete(store, 9);
  EXPECT_TRUE(opened(OpenAs::resume, campaign(9)).notes().empty());
}

TEST_F(ChunkStoreTest, damage_while_it_runs) {
  ChunkStore store = opened(OpenAs::fresh, campaign(4));
  for (const std::int64_t k : range(4)) put(store, k);
  flip(file(2), 60);
  EXPECT_TRUE(contains(message_of([&] { store.counts(2); }), file(2).string() + " has a wrong"));
  flip(file(3), fs::file_size(file(3)) - 1);
  EXPECT_EQ(store.counts(3), counts_of(3));  // the header is whole
  EXPECT_TRUE(contains(message_of([&] { store.get(3); }), "wrong checksum; it was renamed"));
  EXPECT_TRUE(contains(message_of([&] { store.get(3); }), "there is no such chunk"));
  EXPECT_EQ(store.missing(), (std::vector<std::int64_t>{2, 3}));
  EXPECT_EQ(store.totals(), sum_of({0, 1}));
  EXPECT_EQ(journalled(), (std::vector<std::int64_t>{0, 1}));
  put(store, 2);
  EXPECT_EQ(store.totals(), sum_of({0, 1, 2}));
}

TEST_F(ChunkStoreTest, every_bit_of_a_chunk_is_guarded) {
  ChunkStore store = opened(OpenAs::fresh, campaign(2));
  put(store, 1);
  const std::string whole = content(file(1));
  for (std::size_t at = 0; at < whole.size(); ++at) {
    flip(file(1), at);
    EXPECT_NE(message_of([&] { store.get(1); }), "") << at;
    write(file(1), whole);
    EXPECT_EQ(store.get(1), bytes_of(1));
  }
  for (std::size_t length = 0; length < whole.size(); ++length) {
    write(file(1), whole.substr(0, length));
    EXPECT_NE(message_of([&] { store.counts(1); }), "") << length;
  }
  write(file(1), whole + "x");
  EXPECT_NE(message_of([&] { store.counts(1); }), "");
}

TEST_F(ChunkStoreTest, the_chunks_outlive_the_journal) {
  {
    ChunkStore store = opened(OpenAs::fresh, campaign(5));
    for (const std::int64_t k : {0, 1, 2}) put(store, k);
  }
  write(folder_ / "journal.sqlite", std::string(5000, 'x'));
  const std::string message = message_of([&] { opened(OpenAs::resume, campaign(5)); });
  EXPECT_TRUE(contains(message, (folder_ / "journal.sqlite").string() + ": file is not a database"))
      << message;
  EXPECT_TRUE(contains(message, "move the journal to another folder and continue with --resume"))
      << message;
  for (const bool empty : {false, true}) {
    fs::remove(folder_ / "journal.sqlite");
    // as if the process had been killed before the first row.
    if (empty) write(folder_ / "journal.sqlite", "");
    EXPECT_TRUE(contains(refusal(OpenAs::fresh, campaign(5)),
                         "3 of 5 chunks done; continue it with --resume"));
    for (const OpenAs as : {OpenAs::fresh, OpenAs::resume, OpenAs::join}) {
      EXPECT_TRUE(
          contains(refusal(as, campaign(5, "1.3")), "000000.chunk belongs to another search"));
    }
    EXPECT_EQ(fs::exists(folder_ / "journal.sqlite"), empty);
    ChunkStore store = opened(OpenAs::resume, campaign(5));
    EXPECT_EQ(store.missing(), (std::vector<std::int64_t>{3, 4}));
    EXPECT_EQ(journalled(), range(3));
    EXPECT_EQ(store.totals(), sum_of(range(3)));
  }
}

TEST_F(ChunkStoreTest, what_is_not_of_the_campaign_is_left_alone) {
  {
    ChunkStore store = opened(OpenAs::fresh, campaign(3));
    put(store, 0);
  }
  fs::copy_file(file(0), file(3));  // the campaign has no chunk with this number
  for (const char* name :
       {"1.chunk", "0000001.chunk", "-00001.chunk", "000001.chunk.bak", "x.part.y"}) {
    write(folder_ / "chunks" / name, "mine");
  }
  const auto names = chunk_names();
  ChunkStore store = opened(OpenAs::resume, campaign(3));
  EXPECT_EQ(store.missing(), (std::vector<std::int64_t>{1, 2}));
  EXPECT_EQ(store.totals(), sum_of({0}));
  EXPECT_EQ(chunk_names(), names);
  EXPECT_TRUE(store.notes().empty());
}

TEST_F(ChunkStoreTest, a_folder_that_cannot_be_is_an_io_error) {
  write(root_ / "runs", "a file");  // root may write everywhere, but a file cannot contain a folder
  for (const OpenAs as : {OpenAs::fresh, OpenAs::join}) {
    const std::string message = message_of([&] { opened(as, campaign(3)); });
    EXPECT_TRUE(contains(message, "cannot make the folder " + folder_.string())) << message;
    EXPECT_TRUE(contains(message, "Not a directory")) << message;
  }
  EXPECT_TRUE(contains(refusal(OpenAs::resume, campaign(3)), "no search to resume"));
  fs::remove(root_ / "runs");
  fs::create_directories(folder_ / "journal.sqlite");
  const std::string message = message_of([&] { opened(OpenAs::resume, campaign(3)); });
  EXPECT_TRUE(contains(message, "journal.sqlite: unable to open database file")) << message;
}

// A limit on the length of files simulates a full file system.
TEST_F(ChunkStoreTest, a_full_disk_leaves_nothing_half_written) {
  { opened(OpenAs::fresh, campaign(3)); }
  const pid_t pid = child([this] {
    ChunkStore store = opened(OpenAs::resume, campaign(3));
    ::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{100'000, 100'000};
    if (::setrlimit(RLIMIT_FSIZE, &limit) != 0) throw std::runtime_error("no limit");
    const std::string message =
        message_of([&] { store.put(1, bytes_of(1, 200'000), counts_of(1)); });
    if (message != "cannot write " + file(1).string() + ": File too large") {
      throw std::runtime_error("said: " + message);
    }
    put(store, 2);
  });
  EXPECT_TRUE(went_well(pid));
  EXPECT_EQ(chunk_names(), std::vector<std::string>{"000002.chunk"});
  EXPECT_EQ(journalled(), std::vector<std::int64_t>{2});
}

TEST_F(ChunkStoreTest, a_journal_that_cannot_be_written_costs_its_row_alone) {
  ChunkStore store = opened(OpenAs::fresh, campaign(2));
  query(folder_,
        "CREATE TRIGGER full BEFORE INSERT ON chunks BEGIN SELECT RAISE(ABORT, 'full'); END");
  const std::string message = message_of([&] { put(store, 1); });
  EXPECT_EQ(message, "the journal " + (folder_ / "journal.sqlite").string() + ": full");
  EXPECT_TRUE(store.done(1));
  EXPECT_EQ(store.totals(), sum_of({1}));
  query(folder_, "DROP TRIGGER full");
  EXPECT_EQ(opened(OpenAs::resume, campaign(2)).get(1), bytes_of(1));
  EXPECT_EQ(journalled(), std::vector<std::int64_t>{1});
}

}  // namespace
}  // namespace gearwright

// These functions replace the functions of the system. They count the calls and then perform them.
extern "C" int fdatasync(int file) {
  ++gearwright::testing::syncs;
  return static_cast<int>(::syscall(SYS_fdatasync, file));
}
extern "C" int fsync(int file) {
  ++gearwright::testing::syncs;
  return static_cast<int>(::syscall(SYS_fsync, file));
}
