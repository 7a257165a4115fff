// Collects and encodes the values of one column of a row group. Internal to store/.
#pragma once

#include <cstddef>
#include <string>

#include "gearwright/store/parquet.hpp"
#include "gearwright/store/thrift.hpp"

namespace gearwright {

/// The numbers that parquet.thrift gives to the encodings and types used here.
enum ParquetEncoding : std::size_t { kPlain = 0, kRle = 3, kByteStreamSplit = 9 };
std::size_t physical_type(ParquetType type);
ParquetEncoding encoding_of(ParquetType type);

/// Appends the bytes of a number, little-endian.
template <class Number>
void append_bytes(std::string& bytes, Number value) {
  bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

struct ColumnChunk {
  ParquetColumn column;
  std::string values = {};   ///< the values that are not null, in the encoding PLAIN
  std::string defined = {};  ///< one bit per row of an optional column, 1 for a value, 0 for null
  std::size_t count = 0;     ///< number of values that are not null
  bool is_set = false;       ///< true if the value was set in the current row
};

/// Ends row number `row` of the group. If no value was set in this row, the value is null.
void end_row(ColumnChunk& chunk, std::size_t row);

/// Returns the data page before compression. An optional column begins with definition levels.
std::string page_of(const ColumnChunk& chunk, std::size_t rows);

/// Writes the fields of the struct Statistics: the number of nulls, the range of the numbers and,
/// for float64, the number of NaN. The range is omitted if there are no numbers or if one of them
/// is NaN.
void write_statistics(Thrift& out, const ColumnChunk& chunk, std::size_t rows);

}  // namespace gearwright
