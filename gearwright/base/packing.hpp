// Checksum and compression of files: CRC-32 and deflate (RFC 1951), as in ZIP.
//
// zlib does both. A build without zlib uses the small compressor of stb_image_write.h
// (packing_without.cpp), whose output is larger but unpacks to the same bytes.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace gearwright {

/// CRC-32 of ISO 3309, called crc32 by ZIP, PNG and zlib.
std::uint32_t crc32_of(std::string_view bytes);

/// A raw deflate stream, without zlib's header.
///
/// Domain  fewer than 2³² bytes, or fewer than 2³¹ in a build without zlib (contract)
std::string deflated(std::string_view content);

/// The content of a raw deflate stream, up to `most` bytes. If the stream is broken or has more
/// bytes, the result is empty.
///
/// Domain  as deflated() (contract)
std::string inflated(std::string_view stream, std::size_t most);

}  // namespace gearwright
