// Parts shared by the tests of Parquet files: a folder, and a table with columns of every type from
// a fixed seed.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "gearwright/base/testing/scratch_folder.hpp"
#include "gearwright/store/parquet.hpp"

namespace gearwright {

class ParquetFile : public ::testing::Test {
 protected:
  testing::ScratchFolder scratch_;
  std::filesystem::path folder_ = scratch_.path();
  std::filesystem::path file_ = folder_ / "table.parquet";
};

inline std::string content(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

inline double from_bits(std::uint64_t u) {
  double value = 0;
  std::memcpy(&value, &u, sizeof u);
  return value;
}

// One column of every type, and one of every type with nulls.
struct ParquetRow {
  std::int32_t a;
  std::int64_t b;
  double c;
  std::string d;
  std::optional<std::int32_t> e;
  std::optional<std::int64_t> f;
  std::optional<double> g;
  std::optional<std::string> h;
};

inline const std::vector<ParquetColumn> kEveryType = {
    {"a", ParquetType::int32},         {"b", ParquetType::int64},
    {"c", ParquetType::float64},       {"d", ParquetType::text},
    {"e", ParquetType::int32, true},   {"f", ParquetType::int64, true},
    {"g", ParquetType::float64, true}, {"h", ParquetType::text, true}};

inline std::vector<ParquetRow> random_rows(std::size_t count) {
  std::mt19937_64 random(20240607);
  const std::vector<std::string> texts = {"", "rack", "Größe α_wt", "歯車 ⚙ \U0001F529",
                                          "it's \"so\"\n\t\\"};
  const auto number = [&] {
    double value = 0;
    do {
      value = from_bits(random());
    } while (!std::isfinite(value));
    return value;
  };
  std::vector<ParquetRow> made;
  for (std::size_t i = 0; i < count; ++i) {
    ParquetRow row{static_cast<std::int32_t>(random()),
                   static_cast<std::int64_t>(random()),
                   number(),
                   texts[random() % texts.size()],
                   {},
                   {},
                   {},
                   {}};
    if (random() % 3 != 0) row.e = static_cast<std::int32_t>(random());
    if (i >= 70'000)
      row.f = static_cast<std::int64_t>(random());  // the first group contains only
                                                    // nulls
    if (i < 100'000) row.g = number();
    if (random() % 100 == 0) row.h = texts[random() % texts.size()] + std::to_string(i);
    made.push_back(row);
  }
  return made;
}

inline void write_rows(const std::filesystem::path& file, const std::vector<ParquetRow>& rows,
                       const std::vector<std::pair<std::string, std::string>>& key_values = {}) {
  ParquetWriter table(file, kEveryType, key_values);
  for (const ParquetRow& row : rows) {
    table.set(0, row.a);
    table.set(1, row.b);
    table.set(2, row.c);
    table.set(3, row.d);
    if (row.h) table.set(7, *row.h);  // the columns are set in any order
    if (row.e) table.set(4, *row.e);
    if (row.f) table.set(5, *row.f);
    if (row.g) table.set(6, *row.g);
    table.end_row();
  }
  table.close();
}

}  // namespace gearwright
