// Converts feasible designs to bytes and back, for the chunks of a large search on disk.
//
// Every number of a row has 64 bits with the low byte first. The rows follow each other and are
// compressed by zstd. Reading gives the same rows, bit for bit.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "gearwright/design/design_row.hpp"
#include "gearwright/design/shift_points.hpp"

namespace gearwright {

struct ChunkFinds {
  std::vector<DesignRow> designs;
  std::vector<ShiftPoint> points;  ///< points of the grid of profile shifts, if requested
};

std::string pack(const ChunkFinds& finds);

/// Converts the bytes of pack() back to designs.
///
/// Throws    IoError if the bytes were not made by pack(). `where` names the bytes in the message
ChunkFinds unpack(std::string_view bytes, const std::string& where);

}  // namespace gearwright
