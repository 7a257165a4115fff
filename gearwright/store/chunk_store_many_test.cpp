// Tests many processes that write into one folder at the same time, any of which may be killed at
// any moment.
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <thread>

#include "gearwright/store/chunk_store.hpp"
#include "gearwright/store/testing/chunk_folder.hpp"

namespace gearwright {
namespace {

using namespace testing::chunks;  // NOLINT(google-build-using-namespace)

using ChunkStoreMany = ChunkFolderTest;

TEST_F(ChunkStoreMany, threads_put_into_one_store) {
  constexpr std::int64_t kChunks = 80;
  ChunkStore store = opened(OpenAs::fresh, campaign(kChunks));
  std::vector<std::thread> threads;
  for (int t = 0; t < 4; ++t) {
    threads.emplace_back([&store, this, t] {
      for (std::int64_t k = t / 2; k < kChunks; k += 2) {  // two threads write every chunk
        put(store, k);
        EXPECT_GE(store.totals().tested, counts_of(k).tested);
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  expect_complete(store, kChunks);
  for (const std::int64_t k : range(kChunks)) EXPECT_EQ(store.get(k), bytes_of(k));
}

TEST_F(ChunkStoreMany, two_processes_put_into_one_folder) {
  constexpr std::int64_t kChunks = 200;
  std::vector<pid_t> children;
  for (int p = 0; p < 2; ++p) {
    children.push_back(child([this, p] {
      ChunkStore store = opened(OpenAs::join, campaign(kChunks));
      for (std::int64_t k = p; k < kChunks; k += 2) put(store, k);
    }));
  }
  for (const pid_t pid : children) EXPECT_TRUE(went_well(pid));
  EXPECT_EQ(journalled(), range(kChunks));  // the journal is complete before the folder is opened
                                            // again
  EXPECT_EQ(query(folder_, "SELECT count(*) FROM chunks WHERE writer IS NOT 'test'")[0][0], "0");
  const ChunkStore store = opened(OpenAs::resume, campaign(kChunks));
  expect_complete(store, kChunks);
  for (const std::int64_t k : range(kChunks)) EXPECT_EQ(store.get(k), bytes_of(k));
}

// The children wait and then all begin at the same moment, in a folder that does not exist yet.
TEST_F(ChunkStoreMany, a_campaign_begun_by_many_at_once_is_one) {
  constexpr int kWriters = 8;
  for (int round = 0; round < 10; ++round) {
    for (const OpenAs as : {OpenAs::join, OpenAs::fresh}) {
      fs::remove_all(folder_);
      int gate[2];
      ASSERT_EQ(::pipe(gate), 0);
      std::vector<pid_t> children;
      for (int p = 0; p < kWriters; ++p) {
        children.push_back(child([&, p] {
          ::close(gate[1]);
          char byte = 0;
          while (::read(gate[0], &byte, 1) > 0) {  // ends when the parent closes its end of the
                                                   // pipe
          }
          auto store = open(as, campaign(kWriters));
          if (!store) ::_exit(1);
          ChunkStore own = std::move(store).take();
          put(own, p);
        }));
      }
      ::close(gate[0]);
      ::close(gate[1]);
      int well = 0;
      for (const pid_t pid : children) well += went_well(pid) ? 1 : 0;
      // With `fresh`, only the processes that open the folder before the first chunk is finished
      // succeed. There is at least one.
      EXPECT_GE(well, as == OpenAs::join ? kWriters : 1);
      EXPECT_EQ(journalled().size(), static_cast<std::size_t>(well));
      EXPECT_TRUE(opened(OpenAs::resume, campaign(kWriters)).notes().empty());
    }
  }
}

TEST_F(ChunkStoreMany, killed_again_and_again_it_still_completes) {
  constexpr std::int64_t kChunks = 60;
  constexpr std::size_t kLength = 300'000;  // long enough that a process can be killed while it
                                            // writes a chunk
  std::size_t kept = 0;
  int kills = 0;
  for (int round = 0; kept < kChunks; ++round) {
    std::vector<pid_t> children;
    for (int p = 0; p < 2; ++p) {
      children.push_back(child([this, p] {
        ChunkStore store = opened(OpenAs::join, campaign(kChunks));
        std::vector<std::int64_t> work = store.missing();
        if (p == 1) std::reverse(work.begin(), work.end());
        for (const std::int64_t k : work) store.put(k, bytes_of(k, kLength), counts_of(k));
      }));
    }
    // In every round, at least one more chunk must be finished. After that, the processes are
    // killed at an arbitrary moment.
    const auto finished = [this] {
      const auto names =
          fs::exists(folder_ / "chunks") ? chunk_names() : std::vector<std::string>();
      return static_cast<std::size_t>(std::count_if(names.begin(), names.end(), [](const auto& n) {
        return fs::path(n).extension() == ".chunk";
      }));
    };
    for (int wait = 0; finished() < std::min<std::size_t>(kept + 1, kChunks); ++wait) {
      ASSERT_LT(wait, 100'000);
      ::usleep(200);
    }
    ::usleep(static_cast<useconds_t>(271 * round % 2000));
    for (const pid_t pid : children) ::kill(pid, SIGKILL);
    for (const pid_t pid : children) {
      int status = 0;
      ASSERT_EQ(::waitpid(pid, &status, 0), pid);
      kills += WIFSIGNALED(status) ? 1 : 0;
      EXPECT_TRUE(WIFSIGNALED(status) || WEXITSTATUS(status) == 0);
    }
    const auto found = ChunkStore::open(folder_, campaign(kChunks), kNames, OpenAs::join, "parent");
    ASSERT_TRUE(found) << found.error().message();
    EXPECT_TRUE(found->notes().empty());  // no chunk is half written, and no row precedes its file
    const std::size_t done = kChunks - found->missing().size();
    EXPECT_GE(done, kept);  // finished chunks remain finished
    kept = done;
    EXPECT_EQ(journalled().size(), done);
  }
  EXPECT_GE(kills, 3);
  const ChunkStore store = opened(OpenAs::resume, campaign(kChunks));
  expect_complete(store, kChunks);
  for (const std::int64_t k : range(kChunks)) EXPECT_EQ(store.get(k), bytes_of(k, kLength));
}

}  // namespace
}  // namespace gearwright
