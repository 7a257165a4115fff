// Feasible designs as bytes, for the chunks of a large search on disk.
//
// Every number of a row has 64 bits, low byte first, row after row; the whole is compressed by
// zstd. Reading gives the same rows, bit for bit.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "gearwright/design/design_row.hpp"
#include "gearwright/design/shift_points.hpp"

namespace gearwright {

struct ChunkFinds {
  std::vector<DesignRow> designs;
  std::vector<ShiftPoint> points;  ///< of the grid of shifts, if requested
};

std::string pack(const ChunkFinds& finds);

/// Throws    IoError if pack() did not make the bytes; `where` names them
ChunkFinds unpack(std::string_view bytes, const std::string& where);

}  // namespace gearwright
