// Writes files with this layout:                   format: github.com/apache/parquet-format
//
//   PAR1 | chunk of column 0, group 0 | chunk of column 1, group 0 | ... | footer | its size | PAR1
//
// A chunk consists of one data page of version 1: the header of the page, followed by the page
// itself, which is compressed by zstd. Headers and footer are Thrift structs. The numbers of
// fields, types and encodings are those of parquet.thrift.
#include "gearwright/store/parquet.hpp"

#include <fmt/format.h>
#include <zstd.h>

#include <algorithm>
#include <cstring>
#include <fstream>
#include <limits>
#include <new>

#include "gearwright/base/contract.hpp"
#include "gearwright/base/output_file.hpp"
#include "gearwright/base/printable.hpp"
#include "gearwright/base/system.hpp"
#include "gearwright/base/version.hpp"
#include "gearwright/store/parquet_column.hpp"
#include "gearwright/store/thrift.hpp"

namespace gearwright {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view kParquetMagic = "PAR1";
constexpr std::size_t kZstd = 6;
constexpr std::size_t kUtf8 = 0;
// Level of zstd. For 2 million rows of 5 doubles and 2 integers, level 1 takes 0.25 s and gives
// 20.6 MB. Level 3 takes 0.22 s and gives 20.3 MB. Level 6 takes 0.39 s and gives 20.1 MB.
constexpr int kZstdLevel = 3;
constexpr std::size_t kTextLimit = std::size_t{1} << 30;  // greatest length of a text, bytes
// The size of a page must fit into an int32. Together, all texts of a group except the last one
// have fewer than kGroupTextBytes bytes. A page also contains the last text, the length of each
// text, and the definition levels.
static_assert(ParquetWriter::kGroupTextBytes + kTextLimit + 5 * ParquetWriter::kGroupRows <
              std::numeric_limits<std::int32_t>::max());

}  // namespace

struct ParquetWriter::State {
  std::filesystem::path path;
  std::vector<ColumnChunk> chunks = {};  // columns of the group being filled
  std::vector<std::pair<std::string, std::string>> key_values = {};
  std::unique_ptr<ZSTD_CCtx, decltype(&ZSTD_freeCCtx)> zstd{ZSTD_createCCtx(), ZSTD_freeCCtx};
  FileHandle file;                 // open as long as rows may be added
  std::size_t position = 0;        // bytes written
  std::size_t rows = 0;            // rows of the group being filled
  std::size_t text_bytes = 0;      // bytes of all texts of this group
  std::size_t written_rows = 0;    // rows of the groups that have been written
  std::size_t written_groups = 0;  // number of groups that have been written
  std::string group_entries = {};  // footer entries of the groups that have been written

  explicit State(const std::filesystem::path& part) : path(part) {
    if (!zstd) throw std::bad_alloc();
    ZSTD_CCtx_setParameter(zstd.get(), ZSTD_c_compressionLevel, kZstdLevel);
    ZSTD_CCtx_setParameter(zstd.get(), ZSTD_c_checksumFlag, 1);
  }
  State(const State&) = delete;
  State& operator=(const State&) = delete;

  [[noreturn]] void fail(int error) {
    file.close();
    throw IoError("cannot write", path, error);
  }

  void write(std::string_view bytes) {
    position += bytes.size();
    if (const int error = file.write(bytes)) fail(error);
  }

  ColumnChunk& chunk_to_set(std::size_t column) {
    GW_EXPECTS(file.is_open());
    GW_EXPECTS(column < chunks.size());
    ColumnChunk& chunk = chunks[column];
    GW_EXPECTS(!chunk.is_set);
    chunk.is_set = true;
    return chunk;
  }

  std::string compressed(const std::string& page) {
    std::string bytes(ZSTD_compressBound(page.size()), '\0');
    const std::size_t size =
        ZSTD_compress2(zstd.get(), bytes.data(), bytes.size(), page.data(), page.size());
    if (ZSTD_isError(size))
      throw std::bad_alloc();  // the only possible failure, because the buffer is large enough
    bytes.resize(size);
    return bytes;
  }

  void write_group();
  std::size_t write_chunk(const ColumnChunk& chunk, Thrift& group);
  std::string footer() const;
};

// Writes a chunk to the file, and its entry to the metadata of the group. Returns the size that the
// chunk would have without compression.
std::size_t ParquetWriter::State::write_chunk(const ColumnChunk& chunk, Thrift& group) {
  const ParquetColumn& column = chunk.column;
  const std::string page = page_of(chunk, rows);
  const std::string content = compressed(page);
  Thrift header;
  header.i32(1, 0);  // a data page, version 1
  header.i32(2, page.size());
  header.i32(3, content.size());
  header.open(5);
  header.i32(1, rows);
  header.i32(2, encoding_of(column.type));
  header.i32(3, kRle);  // definition levels
  header.i32(4, kRle);  // repetition levels; required, although a flat table has none
  header.close();
  const std::string head = header.whole();
  const std::size_t begin = position;
  write(head);
  write(content);

  group.open();
  group.i64(2, 0);  // file_offset; 0, because only the footer contains metadata
  group.open(3);
  group.i32(1, physical_type(column.type));
  group.list(2, Thrift::Kind::i32, column.optional ? 2 : 1);
  group.element(encoding_of(column.type));
  if (column.optional) group.element(kRle);
  group.list(3, Thrift::Kind::binary, 1);
  group.element(column.name);
  group.i32(4, kZstd);
  group.i64(5, rows);
  group.i64(6, head.size() + page.size());
  group.i64(7, position - begin);
  group.i64(9, begin);
  group.open(12);
  write_statistics(group, chunk, rows);
  group.close();
  group.close();
  group.close();
  return head.size() + page.size();
}

void ParquetWriter::State::write_group() {
  const std::size_t begin = position;
  std::size_t uncompressed = 0;
  Thrift group;
  group.list(1, Thrift::Kind::structure, chunks.size());
  for (ColumnChunk& chunk : chunks) {
    uncompressed += write_chunk(chunk, group);
    chunk.values.clear();
    chunk.defined.clear();
    chunk.count = 0;
  }
  group.i64(2, uncompressed);
  group.i64(3, rows);
  group.i64(5, begin);
  group.i64(6, position - begin);
  group_entries += group.whole();
  ++written_groups;
  written_rows += rows;
  rows = text_bytes = 0;
}

std::string ParquetWriter::State::footer() const {
  Thrift out;
  out.i32(1, 1);  // version of the format
  out.list(2, Thrift::Kind::structure, chunks.size() + 1);
  out.open();
  out.binary(4, "schema");
  out.i32(5, chunks.size());
  out.close();
  for (const ColumnChunk& chunk : chunks) {
    out.open();
    out.i32(1, physical_type(chunk.column.type));
    out.i32(3, chunk.column.optional ? 1 : 0);
    out.binary(4, chunk.column.name);
    if (chunk.column.type == ParquetType::text) {
      out.i32(6, kUtf8);
      // Field 10 is a union by which newer readers recognise UTF-8. Its member 1 is the empty
      // struct for strings.
      out.open(10);
      out.open(1);
      out.close();
      out.close();
    }
    out.close();
  }
  out.i64(3, written_rows);
  out.list(4, Thrift::Kind::structure, written_groups);
  out.finished_elements(group_entries);
  if (!key_values.empty()) {
    out.list(5, Thrift::Kind::structure, key_values.size());
    for (const auto& [key, value] : key_values) {
      out.open();
      out.binary(1, key);
      out.binary(2, value);
      out.close();
    }
  }
  out.binary(6, fmt::format("gearwright version {}", kVersion));
  out.list(7, Thrift::Kind::structure, chunks.size());
  for (std::size_t i = 0; i < chunks.size(); ++i) {
    out.open();
    out.open(1);  // minima and maxima follow the order of the column's type
    out.close();
    out.close();
  }
  return out.whole();
}

ParquetWriter::ParquetWriter(const std::filesystem::path& part_file,
                             std::vector<ParquetColumn> columns,
                             std::vector<std::pair<std::string, std::string>> key_values)
    : state_(std::make_unique<State>(part_file)) {
  State& s = *state_;
  GW_EXPECTS(!columns.empty());
  std::vector<std::string> names;
  for (ParquetColumn& column : columns) {
    GW_EXPECTS(!column.name.empty() && is_utf8(column.name));
    names.push_back(lower_case(column.name));
    s.chunks.push_back({std::move(column)});
  }
  std::sort(names.begin(), names.end());
  GW_EXPECTS(std::adjacent_find(names.begin(), names.end()) == names.end());
  for (const auto& [key, value] : key_values) GW_EXPECTS(is_utf8(key) && is_utf8(value));
  s.key_values = std::move(key_values);
  s.file = FileHandle::create(part_file);
  if (!s.file.is_open()) s.fail(s.file.error());
  s.write(kParquetMagic);
}

ParquetWriter::~ParquetWriter() = default;

void ParquetWriter::set(std::size_t column, double value) {
  ColumnChunk& chunk = state_->chunk_to_set(column);
  GW_EXPECTS(chunk.column.type == ParquetType::float64);
  append_bytes(chunk.values, value);
}

void ParquetWriter::set(std::size_t column, std::int64_t value) {
  ColumnChunk& chunk = state_->chunk_to_set(column);
  if (chunk.column.type == ParquetType::int32) {
    const auto narrow = static_cast<std::int32_t>(value);
    GW_EXPECTS(narrow == value);
    append_bytes(chunk.values, narrow);
  } else {
    GW_EXPECTS(chunk.column.type == ParquetType::int64);
    append_bytes(chunk.values, value);
  }
}

void ParquetWriter::set(std::size_t column, std::string_view value) {
  ColumnChunk& chunk = state_->chunk_to_set(column);
  GW_EXPECTS(chunk.column.type == ParquetType::text);
  GW_EXPECTS(value.size() < kTextLimit && is_utf8(value));
  append_bytes(chunk.values, static_cast<std::uint32_t>(value.size()));
  chunk.values += value;
  state_->text_bytes += value.size();
}

void ParquetWriter::end_row() {
  State& s = *state_;
  GW_EXPECTS(s.file.is_open());
  for (ColumnChunk& chunk : s.chunks) gearwright::end_row(chunk, s.rows);
  ++s.rows;
  if (s.rows == kGroupRows || s.text_bytes >= kGroupTextBytes) s.write_group();
}

void ParquetWriter::close() {
  State& s = *state_;
  GW_EXPECTS(s.file.is_open());
  for (const ColumnChunk& chunk : s.chunks) GW_EXPECTS(!chunk.is_set);
  if (s.rows > 0) s.write_group();
  std::string end = s.footer();
  GW_ENSURES(end.size() <= std::numeric_limits<std::uint32_t>::max());
  append_bytes(end, static_cast<std::uint32_t>(end.size()));
  end += kParquetMagic;
  s.write(end);
  if (const int error = s.file.close()) s.fail(error);
}

std::optional<std::string> parquet_note(const fs::path& file, std::string_view key) {
  constexpr std::size_t kEnd = 8;  // bytes of the footer's size and of PAR1 at the end of the file
  std::error_code error;
  if (!fs::exists(file, error)) return std::nullopt;
  std::ifstream in(file, std::ios::binary | std::ios::ate);
  if (!in) throw IoError("cannot read " + native_text(file));
  const auto size = static_cast<std::size_t>(in.tellg());
  const auto last = [&](std::size_t count) {
    std::string bytes(count, '\0');
    in.seekg(static_cast<std::streamoff>(size - count));
    if (!in.read(bytes.data(), static_cast<std::streamsize>(count)))
      throw IoError("cannot read " + native_text(file));
    return bytes;
  };
  if (size < kEnd) return std::nullopt;
  const std::string end = last(kEnd);
  if (end.compare(4, 4, kParquetMagic) != 0) return std::nullopt;
  std::uint32_t length = 0;
  for (std::size_t i = 4; i-- > 0;) length = length << 8U | static_cast<unsigned char>(end[i]);
  if (length > size - kEnd) return std::nullopt;
  const std::string footer = last(length + kEnd);
  // A key and its value form a struct of two binary fields. Field 1 is the key, and field 2 the
  // value.
  std::string before = "\x18";
  append_varint(before, key.size());
  before += key;
  before += '\x18';
  std::size_t at = footer.find(before);
  if (at == std::string::npos) return std::nullopt;
  at += before.size();
  std::uint64_t count = 0;
  for (unsigned shift = 0; at < footer.size() && shift < 64; shift += 7) {
    const auto byte = static_cast<unsigned char>(footer[at++]);
    count |= static_cast<std::uint64_t>(byte & 127U) << shift;
    if (byte < 128) break;
  }
  if (count > footer.size() - at) return std::nullopt;
  return footer.substr(at, count);
}

}  // namespace gearwright
