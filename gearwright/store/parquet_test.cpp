// Tests the beginning and end of a file, a full disk, and the contracts of the writer.
//
// parquet_read_test.cpp tests with an independent reader that the rows are correct.
#include "gearwright/store/parquet.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmath>
#include <csignal>
#include <cstring>
#include <functional>
#include <limits>

#include "gearwright/base/output_file.hpp"
#include "gearwright/base/testing/violation.hpp"
#include "gearwright/store/testing/parquet_table.hpp"

namespace gearwright {
namespace {

namespace fs = std::filesystem;
using Limits32 = std::numeric_limits<std::int32_t>;

std::string message_of(const std::function<void()>& act) {
  try {
    act();
  } catch (const IoError& error) {
    return error.what();
  }
  return "";
}

TEST_F(ParquetFile, BeginsAndEndsAsTheFormatSays) {
  for (const std::size_t count : {std::size_t{0}, std::size_t{1}, std::size_t{1000}}) {
    write_rows(file_, random_rows(count));
    const std::string bytes = content(file_);
    ASSERT_GT(bytes.size(), 12u);
    EXPECT_EQ(bytes.substr(0, 4), "PAR1");
    EXPECT_EQ(bytes.substr(bytes.size() - 4), "PAR1");
    std::uint32_t footer = 0;
    std::memcpy(&footer, bytes.data() + bytes.size() - 8, sizeof footer);
    ASSERT_LE(footer, bytes.size() - 12);
    EXPECT_EQ(footer == bytes.size() - 12, count == 0);
    // The footer begins with the version of the format, field 1, an int32 of value 1. It ends with
    // the order of the range of each column, field 7, a list of 8 unions that contain an empty
    // struct.
    EXPECT_EQ(bytes.substr(bytes.size() - 8 - footer, 2), "\x15\x02");
    std::string orders = "\x19\x8c";
    for (std::size_t i = 0; i < kEveryType.size(); ++i) orders += std::string("\x1c\0\0", 3);
    orders += '\0';
    EXPECT_EQ(bytes.substr(bytes.size() - 8 - orders.size(), orders.size()), orders);
  }
}

TEST_F(ParquetFile, GivesItsNotesBack) {
  EXPECT_FALSE(parquet_note(file_, "spec"));  // the file does not exist
  const std::string long_text(70'000, 'x');
  write_rows(file_, random_rows(1000),
             {{"program", "a"}, {"spec", "teeth = 17"}, {"long", long_text}});
  EXPECT_EQ(parquet_note(file_, "spec"), "teeth = 17");
  EXPECT_EQ(parquet_note(file_, "long"), long_text);
  EXPECT_EQ(parquet_note(file_, "program"), "a");
  EXPECT_FALSE(parquet_note(file_, "spe"));
  const std::string whole = content(file_);
  std::ofstream(file_, std::ios::binary) << whole.substr(0, whole.size() - 1);  // the file is not a
                                                                                // table
  EXPECT_FALSE(parquet_note(file_, "spec"));
  std::ofstream(file_, std::ios::binary) << "";
  EXPECT_FALSE(parquet_note(file_, "spec"));
}

TEST_F(ParquetFile, TheSameRowsAreTheSameBytes) {
  auto rows = random_rows(70'000);
  write_rows(file_, rows, {{"spec", "teeth = 17"}});
  const std::string first = content(file_);
  write_rows(file_, rows, {{"spec", "teeth = 17"}});
  EXPECT_TRUE(content(file_) == first);
  rows[69'999].c = std::nextafter(rows[69'999].c, 0.0);
  write_rows(file_, rows, {{"spec", "teeth = 17"}});
  EXPECT_FALSE(content(file_) == first);
}

TEST_F(ParquetFile, AFullDiskIsAnIoError) {
  const std::string message = message_of([] {
    ParquetWriter table("/dev/full", {{"n", ParquetType::int32}});
  });
  EXPECT_EQ(message, "cannot write /dev/full: No space left on device");
  const fs::path nowhere = folder_ / "nowhere" / "a.parquet";
  EXPECT_EQ(message_of([&] {
              ParquetWriter table(nowhere, {{"n", ParquetType::int32}});
            }),
            "cannot write " + nowhere.string() + ": No such file or directory");
}

// Simulates a disk that becomes full, in a child process whose files may not grow beyond `limit`
// bytes. Returns "as expected" if `act` fails with the expected message.
std::string message_at_limit(const fs::path& file, rlim_t limit, const std::function<void()>& act) {
  const pid_t child = ::fork();
  if (child == 0) {
    std::signal(SIGXFSZ, SIG_IGN);
    const rlimit most{limit, limit};
    if (::setrlimit(RLIMIT_FSIZE, &most) != 0) ::_exit(2);
    const std::string expected = "cannot write " + file.string() + ": File too large";
    ::_exit(message_of(act) == expected ? 0 : 1);
  }
  int status = -1;
  if (child < 0 || ::waitpid(child, &status, 0) != child) return "no child";
  if (!WIFEXITED(status)) return "the child was killed";
  return WEXITSTATUS(status) == 0 ? "as expected" : "another message";
}

TEST_F(ParquetFile, ADiskThatFillsUpIsAnIoErrorFromTheRowOrTheEnd) {
  const std::vector<ParquetRow> rows = random_rows(200'000);
  const auto all = [&] { write_rows(file_, rows); };
  EXPECT_EQ(message_at_limit(file_, 1'000'000, all), "as expected");  // in the first group
  EXPECT_EQ(message_at_limit(file_, 100, all), "as expected");
  const auto few = [&] { write_rows(file_, {rows[0]}); };  // fails in close()
  EXPECT_EQ(message_at_limit(file_, 100, few), "as expected");
  few();
  const auto whole = static_cast<rlim_t>(fs::file_size(file_));
  EXPECT_EQ(message_at_limit(file_, whole - 1, few), "as expected");  // at the last byte
  EXPECT_EQ(message_at_limit(file_, whole, few), "another message");  // there is no error, because
                                                                      // the file fits
}

using ParquetDeathTest = ParquetFile;

TEST_F(ParquetDeathTest, ContractsHold) {
  const std::vector<ParquetColumn> columns = {
      {"n", ParquetType::int32}, {"x", ParquetType::float64, true}, {"t", ParquetType::text, true}};
  // A table that violated a contract is unusable, so each violation has a table of its own.
  const auto violates = [&](const auto& act) {
    ParquetWriter table(file_, columns);
    GW_EXPECT_VIOLATION(act(table));
  };
  using Table = ParquetWriter;
  violates([](Table& t) { t.set(3, 1.0); });
  violates([](Table& t) { t.set(0, 1.0); });
  violates([](Table& t) { t.set(1, 1); });
  violates([](Table& t) { t.set(1, "text"); });
  violates([](Table& t) { t.set(0, std::int64_t{Limits32::max()} + 1); });
  violates([](Table& t) { t.set(0, std::int64_t{Limits32::min()} - 1); });
  violates([](Table& t) { t.end_row(); });  // column n is not set
  const auto violates_after = [&](const auto& before, const auto& act) {
    ParquetWriter table(file_, columns);
    before(table);
    GW_EXPECT_VIOLATION(act(table));
  };
  const auto set = [](Table& t) { t.set(0, 1); };
  violates_after(set, set);
  violates_after(set, [](Table& t) { t.close(); });  // the row has not ended
  const auto row = [](Table& t) {
    t.set(0, 1);
    t.end_row();
  };
  violates_after(row, [](Table& t) { t.end_row(); });
  const auto whole = [row](Table& t) {
    row(t);
    t.close();
  };
  violates_after(whole, set);
  violates_after(whole, [](Table& t) { t.end_row(); });
  violates_after(whole, [](Table& t) { t.close(); });
  const auto make = [&](const std::vector<ParquetColumn>& of) { ParquetWriter other(file_, of); };
  GW_EXPECT_VIOLATION(make({}));
  GW_EXPECT_VIOLATION(make({{"", ParquetType::int32}}));
  GW_EXPECT_VIOLATION(make({{"x1", ParquetType::int32}, {"X1", ParquetType::int32}}));
}

TEST_F(ParquetDeathTest, TextsAreUtf8) {
  for (const char* wrong :
       {"\x80", "\xc3", "\xc3(", "\xc0\x80", "\xc1\xbf", "\xe0\x9f\xbf", "\xed\xa0\x80",
        "\xf0\x8f\xbf\xbf", "\xf4\x90\x80\x80", "\xf5\x80\x80\x80", "\xff", "a\xe2\x9a"}) {
    ParquetWriter table(file_, {{"t", ParquetType::text}});
    GW_EXPECT_VIOLATION(table.set(0, wrong)) << wrong;
  }
}

}  // namespace
}  // namespace gearwright
