// Writes the result tables of a search as Apache Parquet files, which DuckDB, pandas, Spark and
// MATLAB can read.
//
// A table is flat. It has named columns, each of one type, and rows are added one after another.
// Rows are kept in memory until a row group is full and are then written column by column. For each
// written row group, only about 100 bytes of footer per column remain in memory.
//
//   int32, int64   PLAIN
//   float64        BYTE_STREAM_SPLIT: first bytes of all values, then second bytes, ..., which
//                  places similar exponents next to each other
//   text           PLAIN, UTF-8
//
// All pages are compressed by zstd and contain a checksum, so a reader detects a damaged file. For
// each column of numbers without NaN, a row group states the least and the greatest value, so that
// readers can skip groups that a query does not need. The same rows and the same version of zstd
// give the same bytes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace gearwright {

enum class ParquetType { int32, int64, float64, text };

struct ParquetColumn {
  std::string name;  ///< UTF-8, unique in its table even if the case of A to Z is ignored
  ParquetType type;
  bool optional = false;  ///< true if a row may omit the value, which is then null
};

/// Writes one table. The values of a row are set in any order, and end_row() then adds the row:
///
///     ParquetWriter table(part, {{"teeth", ParquetType::int32}, {"loss", ParquetType::float64}});
///     table.set(0, 17);
///     table.set(1, 0.012);
///     table.end_row();
///     table.close();
///
/// Throws    IoError naming the path and the system's reason, from the constructor, end_row() and
///           close(); the writer is then unusable and the file is not a table
class ParquetWriter {
 public:
  static constexpr std::size_t kGroupRows = 65'536;
  /// A row group also ends when its texts have this many bytes in total. This limits the memory for
  /// long texts, and keeps a page below the 2 GiB that the format allows.
  static constexpr std::size_t kGroupTextBytes = std::size_t{64} << 20;

  /// Opens `part_file` under exactly this name. The caller renames it when the table is
  /// complete (write_file_by in base/output_file.hpp). The `key_values` are written into the
  /// footer.
  ///
  /// Domain    at least one column; names not empty and unique; UTF-8 throughout (contract)
  ParquetWriter(const std::filesystem::path& part_file, std::vector<ParquetColumn> columns,
                std::vector<std::pair<std::string, std::string>> key_values = {});

  /// If close() was not called, the file has no footer, and readers reject it.
  ~ParquetWriter();
  ParquetWriter(const ParquetWriter&) = delete;
  ParquetWriter& operator=(const ParquetWriter&) = delete;

  /// Sets the value of `column`, counted from 0, in the current row. The value is stored exactly.
  ///
  /// Domain    the column has the type of the value and was not set in this row before; the value
  ///           of an int32 column fits into int32; text is UTF-8 below 1 GiB (contract)
  void set(std::size_t column, double value);
  void set(std::size_t column, std::int64_t value);
  void set(std::size_t column, std::int32_t value) { set(column, std::int64_t{value}); }
  void set(std::size_t column, std::string_view value);

  /// Ends the row. An optional column that was not set is null.
  ///
  /// Domain    every other column was set (contract)
  void end_row();

  /// Writes the remaining rows and the footer, which completes the table.
  ///
  /// Domain    every row that was begun has been ended (contract)
  void close();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Returns the value of a key in the footer of a table made by ParquetWriter, or nothing if there
/// is no such table or key.
///
/// Throws    IoError if the file exists and cannot be read
std::optional<std::string> parquet_note(const std::filesystem::path& file, std::string_view key);

}  // namespace gearwright
