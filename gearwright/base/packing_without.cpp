// The version without zlib computes CRC-32 with a table of 256 remainders. It compresses with
// stb_image_write.h (libstb-dev), which uses fixed Huffman codes and finds matches within 32 kB. It
// unpacks with stb_image.h.
#include <algorithm>
#include <array>
#include <climits>
#include <cstdlib>
#include <new>

#include "gearwright/base/contract.hpp"
#include "gearwright/base/packing.hpp"

#define STB_IMAGE_WRITE_STATIC
#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STBI_WRITE_NO_STDIO
#include <stb/stb_image_write.h>
#define STB_IMAGE_STATIC
#define STB_IMAGE_IMPLEMENTATION
#define STBI_NO_STDIO
#define STBI_ONLY_PNG
#include <stb/stb_image.h>

namespace gearwright {

namespace {

constexpr int kQuality = 8;  // number of candidates compared for a match, at least 5; a larger
                             // number takes more time
constexpr std::size_t kZlibHeader = 2;   // bytes before the deflate stream
constexpr std::size_t kZlibTrailer = 4;  // bytes of the Adler-32 checksum after it

constexpr std::array<std::uint32_t, 256> remainders() {
  std::array<std::uint32_t, 256> table{};
  for (std::uint32_t byte = 0; byte < 256; ++byte) {
    std::uint32_t r = byte;
    for (int bit = 0; bit < 8; ++bit) r = (r & 1U) != 0 ? 0xedb88320U ^ (r >> 1U) : r >> 1U;
    table[byte] = r;
  }
  return table;
}

}  // namespace

std::uint32_t crc32_of(std::string_view bytes) {
  static constexpr std::array<std::uint32_t, 256> kTable = remainders();
  std::uint32_t crc = 0xffffffffU;
  for (const char c : bytes)
    crc = kTable[(crc ^ static_cast<unsigned char>(c)) & 0xffU] ^ (crc >> 8U);
  return crc ^ 0xffffffffU;
}

std::string deflated(std::string_view content) {
  GW_EXPECTS(content.size() <= INT_MAX);
  int length = 0;
  // stbi_zlib_compress() does not write to its input, although the parameter is not const.
  auto* data = reinterpret_cast<unsigned char*>(const_cast<char*>(content.data()));
  unsigned char* packed =
      stbi_zlib_compress(data, static_cast<int>(content.size()), &length, kQuality);
  if (!packed) throw std::bad_alloc();
  GW_ENSURES(length >= static_cast<int>(kZlibHeader + kZlibTrailer));
  const std::string out(reinterpret_cast<const char*>(packed) + kZlibHeader,
                        static_cast<std::size_t>(length) - kZlibHeader - kZlibTrailer);
  std::free(packed);
  return out;
}

std::string inflated(std::string_view stream, std::size_t most) {
  GW_EXPECTS(stream.size() <= INT_MAX && most <= INT_MAX);
  std::string out(most, '\0');
  const int length = stbi_zlib_decode_noheader_buffer(
      out.data(), static_cast<int>(most), stream.data(), static_cast<int>(stream.size()));
  out.resize(static_cast<std::size_t>(std::max(length, 0)));
  return out;
}

}  // namespace gearwright
