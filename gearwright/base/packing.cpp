#include "gearwright/base/packing.hpp"

#include <zlib.h>

#include "gearwright/base/contract.hpp"

namespace gearwright {

namespace {

constexpr int kLevel = 6;
constexpr int kRawDeflate = -15;  // a 32 kB window, no zlib header
constexpr int kMemory = 8;

}  // namespace

std::uint32_t crc32_of(std::string_view bytes) {
  return static_cast<std::uint32_t>(
      crc32_z(0, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()));
}

std::string deflated(std::string_view content) {
  GW_EXPECTS(content.size() <= 0xffffffffU);
  z_stream stream{};
  int status = deflateInit2(&stream, kLevel, Z_DEFLATED, kRawDeflate, kMemory, Z_DEFAULT_STRATEGY);
  GW_ENSURES(status == Z_OK);
  std::string out(deflateBound(&stream, static_cast<uLong>(content.size())), '\0');
  // zlib does not write to its input. Its interface is older than const, so a cast is needed.
  stream.next_in = const_cast<Bytef*>(reinterpret_cast<const Bytef*>(content.data()));
  stream.avail_in = static_cast<uInt>(content.size());
  stream.next_out = reinterpret_cast<Bytef*>(out.data());
  stream.avail_out = static_cast<uInt>(out.size());
  status = deflate(&stream, Z_FINISH);
  GW_ENSURES(status == Z_STREAM_END);
  out.resize(stream.total_out);
  deflateEnd(&stream);
  return out;
}

std::string inflated(std::string_view packed, std::size_t most) {
  GW_EXPECTS(packed.size() <= 0xffffffffU && most <= 0xffffffffU);
  z_stream stream{};
  int status = inflateInit2(&stream, kRawDeflate);
  GW_ENSURES(status == Z_OK);
  std::string out(most, '\0');
  stream.next_in = const_cast<Bytef*>(reinterpret_cast<const Bytef*>(packed.data()));
  stream.avail_in = static_cast<uInt>(packed.size());
  stream.next_out = reinterpret_cast<Bytef*>(out.data());
  stream.avail_out = static_cast<uInt>(out.size());
  status = inflate(&stream, Z_FINISH);
  out.resize(status == Z_STREAM_END ? stream.total_out : 0);
  inflateEnd(&stream);
  return out;
}

}  // namespace gearwright
