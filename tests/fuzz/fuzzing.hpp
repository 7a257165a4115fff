// Functions that the fuzz targets share.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "gearwright/spec/spec.hpp"

namespace gearwright::fuzz {

inline void require(bool condition) {
  if (!condition) std::abort();
}

inline std::string_view text_of(const std::uint8_t* data, std::size_t size) {
  return {reinterpret_cast<const char*>(data), size};
}

inline Result<JobSpec> spec_of(std::string_view text) {
  const bool json = !text.empty() && text.front() == '{';
  return read_spec(text, json ? SpecFormat::json : SpecFormat::toml);
}

}  // namespace gearwright::fuzz
