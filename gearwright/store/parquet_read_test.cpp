// Tests that an independent reader, DuckDB, reads all values of a table bit for bit
// (tests/search/read_parquet.mjs).
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <functional>
#include <limits>
#include <nlohmann/json.hpp>

#include "gearwright/base/testing/source_file.hpp"
#include "gearwright/base/version.hpp"
#include "gearwright/store/parquet.hpp"
#include "gearwright/store/testing/parquet_table.hpp"

namespace gearwright {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using Limits64 = std::numeric_limits<std::int64_t>;
using Limits32 = std::numeric_limits<std::int32_t>;

constexpr std::size_t kGroup = ParquetWriter::kGroupRows;

std::uint64_t bits(double value) {
  std::uint64_t u = 0;
  std::memcpy(&u, &value, sizeof u);
  return u;
}

// Returns a number as read_parquet.mjs prints it. Numbers that JSON cannot represent are strings.
double real(const json& value) {
  return value.is_string() ? std::strtod(value.get<std::string>().c_str(), nullptr)
                           : value.get<double>();
}

std::int64_t integer(const json& value) {
  return value.is_string() ? std::strtoll(value.get<std::string>().c_str(), nullptr, 10)
                           : value.get<std::int64_t>();
}

class ParquetRead : public ParquetFile {
 protected:
  struct Answer {
    int status;
    std::string text;
  };
  // Runs a query in DuckDB. The view `data` contains the rows.
  Answer ask(const std::string& sql) const {
    const auto quoted = [](const std::string& word) {
      std::string out = "'";
      for (char c : word) out += c == '\'' ? std::string("'\\''") : std::string(1, c);
      return out + "'";
    };
    const char* node = std::getenv("GW_NODE");
    const std::string command = quoted(node != nullptr && *node != '\0' ? node : "node") + " " +
                                quoted(testing::source_file("tests/search/read_parquet.mjs")) +
                                " " + quoted(file_.string()) + " " + quoted(sql) + " 2>&1";
    std::FILE* pipe = ::popen(command.c_str(), "r");
    if (pipe == nullptr) return {-1, "no shell"};
    std::string text;
    char buffer[1 << 16];
    for (std::size_t n = 0; (n = std::fread(buffer, 1, sizeof buffer, pipe)) > 0;) {
      text.append(buffer, n);
    }
    return {::pclose(pipe), text};
  }
  json rows(const std::string& sql) const {
    const Answer answer = ask(sql);
    EXPECT_EQ(answer.status, 0) << answer.text;
    return answer.status == 0 ? json::parse(answer.text) : json::array();
  }
  // Returns the number of rows of each group, in order.
  std::vector<std::size_t> group_rows() const {
    std::vector<std::size_t> found;
    for (const json& group : rows(
             "select row_group_id, any_value(row_group_num_rows) as n from "
             "parquet_metadata(getvariable('file')) group by row_group_id order by row_group_id")) {
      found.push_back(group["n"].get<std::size_t>());
    }
    return found;
  }
};

void write_reals(const fs::path& file, const std::vector<std::optional<double>>& values) {
  ParquetWriter table(file, {{"x", ParquetType::float64, true}});
  for (const auto& value : values) {
    if (value) table.set(0, *value);
    table.end_row();
  }
  table.close();
}

TEST_F(ParquetRead, ManyRowsOfEveryTypeComeBackBitForBit) {
  const std::vector<ParquetRow> written = random_rows(200'000);
  write_rows(file_, written);
  const json found = rows("select * from data");
  ASSERT_EQ(found.size(), written.size());
  std::size_t wrong = 0;
  for (std::size_t i = 0; i < written.size(); ++i) {
    const ParquetRow& w = written[i];
    const json& r = found[i];
    const bool same = integer(r["a"]) == w.a && integer(r["b"]) == w.b &&
                      bits(real(r["c"])) == bits(w.c) && r["d"] == w.d &&
                      r["e"].is_null() == !w.e && r["f"].is_null() == !w.f &&
                      r["g"].is_null() == !w.g && r["h"].is_null() == !w.h &&
                      (!w.e || integer(r["e"]) == *w.e) && (!w.f || integer(r["f"]) == *w.f) &&
                      (!w.g || bits(real(r["g"])) == bits(*w.g)) && (!w.h || r["h"] == *w.h);
    if (!same && ++wrong == 1) ADD_FAILURE() << "row " << i << ": " << r;
  }
  EXPECT_EQ(wrong, 0u);
  EXPECT_EQ(group_rows(), (std::vector<std::size_t>{kGroup, kGroup, kGroup, 200'000 - 3 * kGroup}));
}

TEST_F(ParquetRead, GroupsEndAtTheirRows) {
  for (const std::size_t count :
       {std::size_t{0}, std::size_t{1}, kGroup - 1, kGroup, kGroup + 1, 2 * kGroup}) {
    {
      ParquetWriter table(file_, {{"n", ParquetType::int32}, {"half", ParquetType::float64, true}});
      for (std::size_t i = 0; i < count; ++i) {
        table.set(0, static_cast<std::int32_t>(i));
        if (i % 2 == 0) table.set(1, 0.5 * static_cast<double>(i));
        table.end_row();
      }
      table.close();
    }
    std::vector<std::size_t> groups(count / kGroup, kGroup);
    if (count % kGroup != 0) groups.push_back(count % kGroup);
    EXPECT_EQ(group_rows(), groups) << count;
    const json total = rows(
        "select count(*) as rows, count(half) as halves, count(*) filter (n <> file_row_number) as "
        "misplaced, count(*) filter (half * 2 <> n) as wrong from "
        "read_parquet(getvariable('file'), file_row_number = true)");
    EXPECT_EQ(total[0],
              (json{{"rows", count}, {"halves", (count + 1) / 2}, {"misplaced", 0}, {"wrong", 0}}));
  }
}

TEST_F(ParquetRead, AnEmptyTableHasItsColumns) {
  write_rows(file_, {});
  EXPECT_EQ(rows("select * from data"), json::array());
  json types = json::array();
  for (const json& column : rows("describe data")) {
    types.push_back(column["column_name"].get<std::string>() + " " +
                    column["column_type"].get<std::string>());
  }
  EXPECT_EQ(types, (json{"a INTEGER", "b BIGINT", "c DOUBLE", "d VARCHAR", "e INTEGER", "f BIGINT",
                         "g DOUBLE", "h VARCHAR"}));
}

TEST_F(ParquetRead, ExtremeNumbersComeBack) {
  using Real = std::numeric_limits<double>;
  const std::vector<double> reals = {0.0,
                                     -0.0,
                                     Real::denorm_min(),
                                     -Real::denorm_min(),
                                     Real::min(),
                                     from_bits(0x000fffffffffffff),
                                     Real::max(),
                                     Real::lowest(),
                                     1e308,
                                     -1e308,
                                     Real::epsilon(),
                                     0.1,
                                     1.0 / 3,
                                     1e22,
                                     9007199254740993.0,
                                     Real::infinity(),
                                     -Real::infinity()};
  const std::vector<std::int64_t> whole = {
      0, -1, 1, Limits64::max(), Limits64::min(), (std::int64_t{1} << 53) + 1, Limits64::max() - 1};
  const std::vector<std::int32_t> narrow = {0, -1, Limits32::max(), Limits32::min()};
  ParquetWriter table(
      file_, {{"x", ParquetType::float64}, {"n", ParquetType::int64}, {"k", ParquetType::int32}});
  for (std::size_t i = 0; i < reals.size(); ++i) {
    table.set(0, reals[i]);
    table.set(1, whole[i % whole.size()]);
    table.set(2, narrow[i % narrow.size()]);
    table.end_row();
  }
  table.close();
  const json found = rows("select * from data");
  ASSERT_EQ(found.size(), reals.size());
  for (std::size_t i = 0; i < reals.size(); ++i) {
    EXPECT_EQ(bits(real(found[i]["x"])), bits(reals[i])) << reals[i] << " " << found[i];
    EXPECT_EQ(integer(found[i]["n"]), whole[i % whole.size()]);
    EXPECT_EQ(integer(found[i]["k"]), narrow[i % narrow.size()]);
  }
}

TEST_F(ParquetRead, UnicodeFromItsFirstToItsLastCharacterComesBack) {
  ParquetWriter table(file_, {{"t", ParquetType::text}});
  const std::vector<std::string> right = {"\x7f",         "\xc2\x80",         "\xdf\xbf",
                                          "\xe0\xa0\x80", "\xed\x9f\xbf",     "\xee\x80\x80",
                                          "\xef\xbf\xbf", "\xf0\x90\x80\x80", "\xf4\x8f\xbf\xbf"};
  for (const std::string& text : right) {
    table.set(0, text);
    table.end_row();
  }
  table.close();
  const json found = rows("select t from data");
  ASSERT_EQ(found.size(), right.size());
  for (std::size_t i = 0; i < right.size(); ++i) EXPECT_EQ(found[i]["t"], right[i]);
}

TEST_F(ParquetRead, NullsStandWhereTheyWere) {
  const std::vector<std::function<bool(std::size_t, std::size_t)>> patterns = {
      [](std::size_t, std::size_t) { return true; },
      [](std::size_t, std::size_t) { return false; },
      [](std::size_t i, std::size_t) { return i % 2 == 0; },
      [](std::size_t i, std::size_t) { return i == 0; },
      [](std::size_t i, std::size_t n) { return i + 1 == n; },
      [](std::size_t i, std::size_t n) { return i + 1 != n; },
      [](std::size_t i, std::size_t) { return i / 8 % 2 == 0; }};
  for (const std::size_t n :
       {std::size_t{1}, std::size_t{7}, std::size_t{8}, std::size_t{9}, std::size_t{1000}}) {
    // One table contains all patterns, one in each column.
    std::vector<ParquetColumn> columns;
    for (std::size_t k = 0; k < patterns.size(); ++k) {
      columns.push_back({"p" + std::to_string(k), ParquetType::int64, true});
    }
    {
      ParquetWriter table(file_, columns);
      for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t k = 0; k < patterns.size(); ++k) {
          if (patterns[k](i, n)) table.set(k, static_cast<std::int64_t>(1000 * k + i));
        }
        table.end_row();
      }
      table.close();
    }
    const json found = rows("select * from data");
    ASSERT_EQ(found.size(), n);
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t k = 0; k < patterns.size(); ++k) {
        const json expected = patterns[k](i, n) ? json(1000 * k + i) : json();
        EXPECT_EQ(found[i][columns[k].name], expected) << "row " << i << " of " << n;
      }
    }
  }
}

TEST_F(ParquetRead, RangesAndNullsAreCounted) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  std::vector<std::optional<double>> values;
  const std::vector<std::vector<std::optional<double>>> starts = {
      {-3.5, 2.25}, {0.0, -1.0}, {-0.0, 1.0}, {{}, nan, 5.0}, {{}}};
  for (const auto& start : starts) {  // each start makes one group, which repeats its first value
    for (std::size_t i = 0; i < kGroup; ++i)
      values.push_back(i < start.size() ? start[i] : start[0]);
  }
  write_reals(file_, values);
  const json found = rows(
      "select stats_min_value as low, stats_max_value as high, stats_null_count as nulls from "
      "parquet_metadata(getvariable('file')) order by row_group_id");
  ASSERT_EQ(found.size(), starts.size());
  EXPECT_EQ(found[0], (json{{"low", "-3.5"}, {"high", "2.25"}, {"nulls", 0}}));
  EXPECT_EQ(found[1], (json{{"low", "-1.0"}, {"high", "0.0"}, {"nulls", 0}}));
  EXPECT_EQ(found[2], (json{{"low", "-0.0"}, {"high", "1.0"}, {"nulls", 0}}));
  EXPECT_EQ(found[3], (json{{"low", nullptr}, {"high", nullptr}, {"nulls", kGroup - 2}}));
  EXPECT_EQ(found[4], (json{{"low", nullptr}, {"high", nullptr}, {"nulls", kGroup}}));
  // Tests how DuckDB uses the ranges. Equal zeros are found, and so is NaN, which DuckDB orders
  // above all numbers.
  EXPECT_EQ(rows("select count(*) as n from data where x = 0")[0]["n"], 2 * kGroup - 2);
  EXPECT_EQ(rows("select count(*) as n from data where x > 100")[0]["n"], 1);
  EXPECT_EQ(rows("select count(*) as n from data where x > 2")[0]["n"], 1 + 2);
  EXPECT_EQ(rows("select count(*) as n from data where x is null")[0]["n"], 2 * kGroup - 2);
}

TEST_F(ParquetRead, IntegersHaveRangesToo) {
  {
    ParquetWriter table(
        file_,
        {{"k", ParquetType::int32}, {"n", ParquetType::int64, true}, {"t", ParquetType::text}});
    for (int i = -5; i < 7; ++i) {
      table.set(0, 3 - i);
      if (i > -5 && i < 6) table.set(1, i == 0 ? Limits64::min() : std::int64_t{i});
      table.set(2, "t");
      table.end_row();
    }
    table.close();
  }
  const json found = rows(
      "select stats_min_value as low, stats_max_value as high, stats_null_count as nulls from "
      "parquet_metadata(getvariable('file')) order by column_id");
  EXPECT_EQ(found[0], (json{{"low", "-3"}, {"high", "8"}, {"nulls", 0}}));
  EXPECT_EQ(found[1], (json{{"low", "-9223372036854775808"}, {"high", "5"}, {"nulls", 2}}));
  EXPECT_EQ(found[2], (json{{"low", nullptr}, {"high", nullptr}, {"nulls", 0}}));
}

TEST_F(ParquetRead, LongTextsEndAGroup) {
  constexpr std::size_t kMiB = std::size_t{1} << 20;
  constexpr int kPerGroup = static_cast<int>(ParquetWriter::kGroupTextBytes / kMiB);
  {
    ParquetWriter table(file_, {{"t", ParquetType::text}});
    for (int i = 0; i < kPerGroup + 6; ++i) {
      table.set(0, std::string(kMiB, static_cast<char>('0' + i % 10)));
      table.end_row();
    }
    table.close();
  }
  EXPECT_EQ(group_rows(), (std::vector<std::size_t>{kPerGroup, 6}));
  const json found = rows("select length(t) as n, t[1] as first, t[-1] as last from data");
  ASSERT_EQ(found.size(), kPerGroup + 6u);
  for (int i = 0; i < kPerGroup + 6; ++i) {
    const std::string digit = std::to_string(i % 10);
    EXPECT_EQ(found[static_cast<std::size_t>(i)],
              (json{{"n", kMiB}, {"first", digit}, {"last", digit}}));
  }
}

TEST_F(ParquetRead, TheFooterNamesWhatItIsToldAndTheProgram) {
  const std::string spec = "[gear1]\nteeth = 17  # α = 20°\n" + std::string(5000, '#');
  write_rows(file_, random_rows(3), {{"spec", spec}, {"empty", ""}});
  EXPECT_EQ(rows("select key, value from parquet_kv_metadata(getvariable('file'))"),
            (json{{{"key", "spec"}, {"value", spec}}, {{"key", "empty"}, {"value", ""}}}));
  EXPECT_EQ(
      rows("select created_by, num_rows from parquet_file_metadata(getvariable('file'))"),
      (json{{{"created_by", std::string("gearwright version ") + kVersion}, {"num_rows", 3}}}));
}

// Lists of 15 or more elements have a different header.
TEST_F(ParquetRead, ManyColumnsAndGroupsAreListed) {
  for (const std::size_t width :
       {std::size_t{13}, std::size_t{14}, std::size_t{15}, std::size_t{16}, std::size_t{200}}) {
    std::vector<ParquetColumn> columns;
    for (std::size_t k = 0; k < width; ++k)
      columns.push_back({"c" + std::to_string(k), ParquetType::int32});
    {
      ParquetWriter table(file_, columns);
      for (std::size_t k = 0; k < width; ++k) table.set(k, static_cast<std::int32_t>(k * k));
      table.end_row();
      table.close();
    }
    const json found = rows("select * from data");
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0].size(), width);
    for (std::size_t k = 0; k < width; ++k) EXPECT_EQ(found[0][columns[k].name], k * k);
  }
  for (const std::size_t groups : {std::size_t{14}, std::size_t{15}, std::size_t{16}}) {
    std::vector<std::optional<double>> values(groups * kGroup);
    for (std::size_t i = 0; i < values.size(); i += 3) values[i] = 1;
    write_reals(file_, values);
    EXPECT_EQ(group_rows(), std::vector<std::size_t>(groups, kGroup));
    EXPECT_EQ(rows("select count(x) as n from data")[0]["n"], (values.size() + 2) / 3);
  }
}

TEST_F(ParquetRead, ChunksFillTheFile) {
  write_rows(file_, random_rows(70'000));
  const json chunks = rows(
      "select data_page_offset as begin, total_compressed_size as size, total_uncompressed_size as "
      "plain, row_group_bytes as group_plain, row_group_compressed_bytes as group_size, "
      "row_group_id as id from parquet_metadata(getvariable('file')) order by row_group_id, "
      "column_id");
  ASSERT_EQ(chunks.size(), 2 * kEveryType.size());
  std::size_t position = 4;
  std::size_t plain[2] = {}, size[2] = {};
  for (const json& chunk : chunks) {
    EXPECT_EQ(chunk["begin"], position);
    position += chunk["size"].get<std::size_t>();
    const auto id = chunk["id"].get<std::size_t>();
    plain[id] += chunk["plain"].get<std::size_t>();
    size[id] += chunk["size"].get<std::size_t>();
  }
  for (const json& chunk : chunks) {
    EXPECT_EQ(chunk["group_plain"], plain[chunk["id"].get<std::size_t>()]);
    EXPECT_EQ(chunk["group_size"], size[chunk["id"].get<std::size_t>()]);
  }
  // A page contains 8 bytes for each double of column c, and a header of about 20 bytes.
  EXPECT_GT(chunks[2]["plain"].get<std::size_t>(), 8 * kGroup);
  EXPECT_LT(chunks[2]["plain"].get<std::size_t>(), 8 * kGroup + 40);
  const std::string bytes = content(file_);
  std::uint32_t footer = 0;
  std::memcpy(&footer, bytes.data() + bytes.size() - 8, sizeof footer);
  EXPECT_EQ(position + footer + 8, bytes.size());
}

TEST_F(ParquetRead, DamageIsNoticed) {
  write_rows(file_, random_rows(1000));
  ASSERT_EQ(ask("select * from data").status, 0);
  std::string bytes = content(file_);
  // The random doubles of column c cannot be compressed, so the file contains the bytes of their
  // page.
  bytes[bytes.size() / 2] = static_cast<char>(bytes[bytes.size() / 2] ^ 1);
  std::ofstream(file_, std::ios::binary) << bytes;
  EXPECT_NE(ask("select * from data").status, 0);
}

TEST_F(ParquetRead, WithoutCloseItIsNoTable) {
  {
    ParquetWriter table(file_, {{"n", ParquetType::int32}});
    for (std::size_t i = 0; i <= kGroup; ++i) {
      table.set(0, 1);
      table.end_row();
    }
  }
  EXPECT_GT(fs::file_size(file_), 4u);
  const Answer answer = ask("select * from data");
  EXPECT_NE(answer.status, 0);
  EXPECT_NE(answer.text.find("No magic bytes found at end of file"), std::string::npos)
      << answer.text;
}

}  // namespace
}  // namespace gearwright
