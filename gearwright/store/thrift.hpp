// Writes structs in Thrift's compact protocol, which Parquet uses for headers and footer.
//
// Integers are zigzag varints. A field is identified by the difference between its number and the
// number of the previous field in the same struct. A struct ends with a zero byte. Fields must be
// given in ascending order of their numbers in the protocol. Internal to store/.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "gearwright/base/contract.hpp"

namespace gearwright {

/// Appends the value with seven bits in each byte, the lowest bits first. The top bit is set in all
/// bytes except the last.
inline void append_varint(std::string& bytes, std::uint64_t value) {
  for (; value >= 128; value >>= 7) bytes += static_cast<char>(value | 128);
  bytes += static_cast<char>(value);
}

class Thrift {
 public:
  enum class Kind { i32 = 5, i64 = 6, binary = 8, list = 9, structure = 12 };

  // These functions write fields of the struct that is currently open. In a new Thrift, the
  // outermost struct is open.
  void i32(int field, std::size_t value) { header(field, Kind::i32), element(value); }
  void i64(int field, std::size_t value) { header(field, Kind::i64), element(value); }
  void binary(int field, std::string_view bytes) { header(field, Kind::binary), element(bytes); }
  void open(int field) { header(field, Kind::structure), open(); }
  void list(int field, Kind of, std::size_t size) {
    header(field, Kind::list);
    const auto kind = static_cast<std::size_t>(of);
    bytes_ += static_cast<char>((size < 15 ? size << 4 : 0xf0) | kind);
    if (size >= 15) append_varint(bytes_, size);
  }

  // These functions write elements of a list.
  void element(std::size_t value) { append_varint(bytes_, std::uint64_t{value} << 1); }
  void element(std::string_view bytes) { append_varint(bytes_, bytes.size()), bytes_ += bytes; }
  void finished_elements(std::string_view structs) { bytes_ += structs; }
  void open() { last_.push_back(0); }

  /// Ends the struct that was opened last.
  void close() { bytes_ += '\0', last_.pop_back(); }

  /// Ends the outermost struct and returns its bytes.
  std::string whole() {
    close();
    GW_EXPECTS(last_.empty());
    return std::move(bytes_);
  }

 private:
  void header(int field, Kind kind) {
    const int step = field - last_.back();
    GW_EXPECTS(step > 0 && step < 16);
    bytes_ += static_cast<char>(step << 4 | static_cast<int>(kind));
    last_.back() = field;
  }

  std::string bytes_;
  std::vector<int> last_{0};  // for every open struct, the number of its previous field
};

}  // namespace gearwright
