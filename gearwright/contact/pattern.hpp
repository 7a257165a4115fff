// Computes the contact pattern, which marking compound would show on both flanks after a full mesh,
// and the gap between the flanks at one position.
//
//   gap   normal distance of the flanks, mm, at the actual rotation of gear 2; in a pattern, the
//         least distance over all positions.  [T8.3], [T8.19] of docs/theory/08-contact.md
//
// The rows of a raster are diameters, and the columns are heights along the face.
#pragma once

#include <array>
#include <vector>

#include "gearwright/base/progress.hpp"
#include "gearwright/contact/transmission.hpp"

namespace gearwright {

struct FlankRaster {
  /// mm, diameters of the rows, ascending. On a rack, heights above the datum line.
  std::vector<double> diameter;
  std::vector<double> height;  ///< mm, z of the columns in the gear's own frame, ascending
  /// mm, in the order [row · columns + column]; infinite where the mating flank is never opposite.
  std::vector<double> gap;

  double at(std::size_t row, std::size_t column) const { return gap[row * height.size() + column]; }
};

struct RasterSize {
  int rows = 33;
  int columns = 65;
};

/// Least gap over all positions of a mesh, with `positions` per pitch, on the flanks of both gears.
///
/// Accuracy  between positions, the gap is interpolated by the parabola through three positions. If
///           the contact moves at constant speed, the gap is exact. Otherwise, the error is some nm
///           with 64 positions per pitch. If the gap at a point is least when the point begins to
///           lie opposite the mating flank, the gap at the next position is used
/// Domain    positions ≥ 2, a raster of 2 × 2 or more (contract)
std::array<FlankRaster, 2> contact_pattern(const ContactPair& pair, int positions,
                                           const RasterSize& size = {},
                                           Progress* progress = nullptr);

/// The gap of tooth pair k on the flank of gear 1, at a rotation of gear 1 in the housing. All gaps
/// are infinite if no tooth pair touches at this rotation.
///
/// Domain    a raster of 2 × 2 or more (contract)
FlankRaster gap_map(const ContactPair& pair, Angle rotation1, int k, const RasterSize& size = {});

}  // namespace gearwright
