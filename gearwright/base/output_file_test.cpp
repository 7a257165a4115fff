#include "gearwright/base/output_file.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "gearwright/base/testing/scratch_folder.hpp"

namespace gearwright {
namespace {

namespace fs = std::filesystem;

class OutputFile : public ::testing::Test {
 protected:
  std::vector<std::string> names() const {
    std::vector<std::string> found;
    for (const auto& entry : fs::directory_iterator(folder_)) {
      found.push_back(entry.path().filename().string());
    }
    std::sort(found.begin(), found.end());
    return found;
  }
  static std::string content(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }

  testing::ScratchFolder scratch_;
  fs::path folder_ = scratch_.path();
};

std::string message_of(const std::function<void()>& act) {
  try {
    act();
  } catch (const IoError& error) {
    return error.what();
  }
  return "";
}

TEST_F(OutputFile, HoldsEveryByte) {
  std::string bytes;
  for (int i = 0; i < 3'000'000; ++i) bytes.push_back(static_cast<char>(i * 7 + i / 251));
  write_file(folder_ / "a.stl", bytes);
  EXPECT_EQ(content(folder_ / "a.stl"), bytes);
  write_file(folder_ / "a.stl", "");  // an existing file is replaced completely
  EXPECT_EQ(content(folder_ / "a.stl"), "");
  EXPECT_EQ(names(), std::vector<std::string>{"a.stl"});
}

TEST_F(OutputFile, MissingFolderIsAnIoErrorThatNamesThePath) {
  const fs::path path = folder_ / "nowhere" / "a.stl";
  const std::string message = message_of([&] { write_file(path, "solid"); });
  EXPECT_NE(message.find(path.string()), std::string::npos) << message;
  EXPECT_NE(message.find("No such file or directory"), std::string::npos) << message;
  try {
    write_file(path, "solid");
    FAIL();
  } catch (const IoError& error) {
    EXPECT_EQ(error.code(), ENOENT);
    EXPECT_EQ(error.path(), path);
  }
  EXPECT_TRUE(names().empty());
}

TEST_F(OutputFile, FailureAtTheRenameLeavesNothing) {
  const fs::path path = folder_ / "a.stl";
  fs::create_directory(path);  // a folder cannot be replaced by a file
  EXPECT_THROW(write_file(path, "solid"), IoError);
  EXPECT_THROW(write_file_by(path, [](const fs::path& part) { std::ofstream(part) << "solid"; }),
               IoError);
  EXPECT_EQ(names(), std::vector<std::string>{"a.stl"});
  EXPECT_TRUE(fs::is_directory(path));
}

TEST_F(OutputFile, DevicesAndPipesAreWrittenNotReplaced) {
  const fs::path pipe = folder_ / "pipe";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  const int reader = ::open(pipe.c_str(), O_RDONLY | O_NONBLOCK);
  ASSERT_GE(reader, 0);
  write_file(pipe, "solid");
  char text[6] = {};
  EXPECT_EQ(::read(reader, text, 5), 5);
  ::close(reader);
  EXPECT_STREQ(text, "solid");
  EXPECT_TRUE(fs::is_fifo(pipe));
  EXPECT_THROW(write_file_by(pipe, [](const fs::path&) {}), IoError);
  EXPECT_EQ(names(), std::vector<std::string>{"pipe"});
}

TEST_F(OutputFile, ALinkKeepsLeadingToTheFile) {
  write_file(folder_ / "real.stl", "old");
  fs::create_symlink("real.stl", folder_ / "link.stl");
  write_file(folder_ / "link.stl", "new");
  EXPECT_TRUE(fs::is_symlink(folder_ / "link.stl"));
  EXPECT_EQ(content(folder_ / "real.stl"), "new");
}

TEST_F(OutputFile, AFolderIsRefused) {
  EXPECT_NE(message_of([&] { write_file(folder_, "solid"); }).find("directory"), std::string::npos);
}

// Root may write everywhere, so a child process writes with the user id of `nobody`.
TEST_F(OutputFile, NoPermissionIsAnIoError) {
  fs::permissions(folder_, fs::perms::owner_read | fs::perms::owner_exec | fs::perms::others_read |
                               fs::perms::others_exec);
  const pid_t child = ::fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    constexpr uid_t kNobody = 65534;
    if (::geteuid() == 0 && ::setuid(kNobody) != 0) ::_exit(2);
    const std::string message = message_of([&] { write_file(folder_ / "a.stl", "solid"); });
    ::_exit(message.find("Permission denied") == std::string::npos ? 1 : 0);
  }
  int status = 0;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  EXPECT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 0);
  EXPECT_TRUE(names().empty());
}

TEST_F(OutputFile, AFailedWriterLeavesTheOldFile) {
  const fs::path path = folder_ / "a.step";
  write_file(path, "old");
  EXPECT_THROW(write_file_by(path,
                             [](const fs::path& part) {
                               std::ofstream(part) << "half";
                               throw std::runtime_error("the writer gave up");
                             }),
               std::runtime_error);
  EXPECT_EQ(content(path), "old");
  EXPECT_EQ(names(), std::vector<std::string>{"a.step"});
}

TEST_F(OutputFile, AWriterThatWritesNothingIsAnIoError) {
  EXPECT_THROW(write_file_by(folder_ / "a.step", [](const fs::path&) {}), IoError);
  EXPECT_TRUE(names().empty());
}

TEST_F(OutputFile, AWriterGetsAPathBesideTheFile) {
  const fs::path path = folder_ / "a.step";
  fs::path seen;
  write_file_by(path, [&](const fs::path& part) {
    seen = part;
    EXPECT_FALSE(fs::exists(path));
    std::ofstream(part) << "whole";
  });
  EXPECT_EQ(seen.parent_path(),
            folder_);  // the temporary file is on the same file system, so renaming is atomic
  EXPECT_EQ(content(path), "whole");
  EXPECT_EQ(names(), std::vector<std::string>{"a.step"});
}

}  // namespace
}  // namespace gearwright
