// Checksum and compression of files: CRC-32 and deflate (RFC 1951), as ZIP has both.
//
// By zlib; a build without it packs with the small compressor of stb_image_write.h, whose bytes are
// others and more, but unpack to the same: packing_without.cpp.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace gearwright {

/// CRC-32 of ISO 3309, what ZIP, PNG and zlib call crc32.
std::uint32_t crc32_of(std::string_view bytes);

/// A raw deflate stream, without zlib's header.
///
/// Domain  less than 2³² bytes, without zlib 2³¹ (contract)
std::string deflated(std::string_view content);

}  // namespace gearwright
