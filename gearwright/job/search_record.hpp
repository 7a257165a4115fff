// Feasible designs as bytes: what a chunk of a large search keeps on disk.
//
// Every number of a row stands in 64 bits, low byte first, row after row; the whole is compressed
// by zstd. Reading gives the same rows, bit for bit.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "gearwright/design/design_row.hpp"

namespace gearwright {

std::string pack_rows(const std::vector<DesignRow>& rows);

/// Throws    IoError where the bytes are not what pack_rows made; `where` names them
std::vector<DesignRow> unpack_rows(std::string_view bytes, const std::string& where);

}  // namespace gearwright
