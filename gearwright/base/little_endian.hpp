// Appends numbers to the bytes of a binary file, and reads numbers from such bytes. The least
// significant byte comes first on every machine.
#pragma once

#include <cstdint>
#include <cstring>
#include <limits>
#include <string>
#include <string_view>

namespace gearwright {

inline void append_u16(std::string& out, std::uint16_t value) {
  out += static_cast<char>(value & 0xffU);
  out += static_cast<char>(value >> 8U);
}

inline void append_u32(std::string& out, std::uint32_t value) {
  const char bytes[4] = {static_cast<char>(value & 0xffU), static_cast<char>((value >> 8U) & 0xffU),
                         static_cast<char>((value >> 16U) & 0xffU),
                         static_cast<char>(value >> 24U)};
  out.append(bytes, 4);
}

/// The number that begins at byte `at`.   Domain: within the bytes
inline std::uint16_t u16_at(std::string_view bytes, std::size_t at) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(bytes[at + i]); };
  return static_cast<std::uint16_t>(byte(0) | byte(1) << 8U);
}

inline std::uint32_t u32_at(std::string_view bytes, std::size_t at) {
  return u16_at(bytes, at) | static_cast<std::uint32_t>(u16_at(bytes, at + 2)) << 16U;
}

/// Appends a number in IEEE 754 single precision.
inline void append_f32(std::string& out, float value) {
  static_assert(std::numeric_limits<float>::is_iec559 && sizeof(float) == 4);
  std::uint32_t bits = 0;
  std::memcpy(&bits, &value, sizeof bits);
  append_u32(out, bits);
}

}  // namespace gearwright
