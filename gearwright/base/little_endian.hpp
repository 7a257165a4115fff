// Appends numbers to binary files, with the least significant byte first on every machine.
#pragma once

#include <cstdint>
#include <cstring>
#include <limits>
#include <string>

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

/// Appends a number in IEEE 754 single precision.
inline void append_f32(std::string& out, float value) {
  static_assert(std::numeric_limits<float>::is_iec559 && sizeof(float) == 4);
  std::uint32_t bits = 0;
  std::memcpy(&bits, &value, sizeof bits);
  append_u32(out, bits);
}

}  // namespace gearwright
