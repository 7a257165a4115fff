#include "gearwright/store/parquet_column.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>
#include <limits>
#include <type_traits>

#include "gearwright/base/contract.hpp"

namespace gearwright {

static_assert(std::endian::native == std::endian::little, "Parquet's values are little-endian");
static_assert(std::numeric_limits<double>::is_iec559);

namespace {

// Returns the definition levels, which are 1 for a value and 0 for null. The format requires a
// length in bytes, followed by the levels as runs of equal levels or as single bits. If there are
// no nulls, or only nulls, one run represents all rows. Otherwise, only bits are used, which take
// at most 8 kB before compression. Runs would take up to 16 times as many bytes.
std::string definition_levels(const ColumnChunk& chunk, std::size_t rows) {
  std::string hybrid;
  if (chunk.count == 0 || chunk.count == rows) {
    append_varint(hybrid, rows << 1);
    hybrid += static_cast<char>(chunk.count == rows ? 1 : 0);
  } else {
    append_varint(hybrid, chunk.defined.size() << 1 | 1);  // counted in groups of 8 rows
    hybrid += chunk.defined;
  }
  std::string levels;
  append_bytes(levels, static_cast<std::uint32_t>(hybrid.size()));
  return levels + hybrid;
}

// Appends byte 0 of every value, then byte 1 of every value, and so on.
void append_split(std::string& page, const std::string& values) {
  const std::size_t n = values.size() / sizeof(double), begin = page.size();
  page.resize(begin + values.size());
  for (std::size_t byte = 0; byte < sizeof(double); ++byte) {
    char* stream = page.data() + begin + byte * n;
    for (std::size_t i = 0; i < n; ++i) stream[i] = values[i * sizeof(double) + byte];
  }
}

template <class Number>
void write_range(Thrift& out, const std::string& values) {
  constexpr bool real = std::is_floating_point_v<Number>;
  std::vector<Number> numbers(values.size() / sizeof(Number));
  if (!numbers.empty()) std::memcpy(numbers.data(), values.data(), values.size());
  std::size_t not_numbers = 0;
  if constexpr (real) {
    not_numbers = static_cast<std::size_t>(
        std::count_if(numbers.begin(), numbers.end(), [](Number x) { return x != x; }));
  }
  // Different readers order NaN differently, so no range is written for values that include NaN.
  if (!numbers.empty() && not_numbers == 0) {
    auto [least, greatest] = std::minmax_element(numbers.begin(), numbers.end());
    Number range[] = {*least, *greatest};
    if constexpr (real) {
      // The numbers −0 and +0 compare equal. Therefore, the format requires that a range with one
      // of them as an end also includes the other.
      if (range[0] == 0) range[0] = -0.0;
      if (range[1] == 0) range[1] = 0.0;
    }
    const char* bytes = reinterpret_cast<const char*>(range);
    out.binary(5, {bytes + sizeof(Number), sizeof(Number)});  // greatest
    out.binary(6, {bytes, sizeof(Number)});                   // least
  }
  if constexpr (real) out.i64(9, not_numbers);
}

}  // namespace

std::size_t physical_type(ParquetType type) {
  switch (type) {
    case ParquetType::int32: return 1;
    case ParquetType::int64: return 2;
    case ParquetType::float64: return 5;
    case ParquetType::text: return 6;
  }
  contract_failed("precondition", "known column type", __FILE__, __LINE__);
}

ParquetEncoding encoding_of(ParquetType type) {
  return type == ParquetType::float64 ? kByteStreamSplit : kPlain;
}

void end_row(ColumnChunk& chunk, std::size_t row) {
  GW_EXPECTS(chunk.is_set || chunk.column.optional);
  if (chunk.column.optional) {
    if (row % 8 == 0) chunk.defined += '\0';
    if (chunk.is_set) chunk.defined.back() = static_cast<char>(chunk.defined.back() | 1 << row % 8);
  }
  chunk.count += chunk.is_set ? 1 : 0;
  chunk.is_set = false;
}

std::string page_of(const ColumnChunk& chunk, std::size_t rows) {
  std::string page = chunk.column.optional ? definition_levels(chunk, rows) : std::string();
  if (encoding_of(chunk.column.type) == kByteStreamSplit) {
    append_split(page, chunk.values);
  } else {
    page += chunk.values;
  }
  return page;
}

void write_statistics(Thrift& out, const ColumnChunk& chunk, std::size_t rows) {
  out.i64(3, rows - chunk.count);
  switch (chunk.column.type) {
    case ParquetType::int32: return write_range<std::int32_t>(out, chunk.values);
    case ParquetType::int64: return write_range<std::int64_t>(out, chunk.values);
    case ParquetType::float64: return write_range<double>(out, chunk.values);
    case ParquetType::text: return;
  }
}

}  // namespace gearwright
