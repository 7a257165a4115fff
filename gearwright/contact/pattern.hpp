// The contact pattern, which marking compound would show on both flanks after a full mesh, and the
// gap between the flanks at one position.
//
//   gap   normal distance of the flanks, mm, at the actual rotation of gear 2; for a pattern, the
//         least over all positions.  [T8.3], [T8.19] of docs/theory/08-contact.md
//
// A raster of the exact field; its rows are diameters, its columns heights along the face.
#pragma once

#include <array>
#include <vector>

#include "gearwright/base/progress.hpp"
#include "gearwright/contact/transmission.hpp"

namespace gearwright {

struct FlankRaster {
  std::vector<double> diameter;  ///< mm, growing: rows
  std::vector<double> height;    ///< mm, growing, z of the gear's own frame: columns
  std::vector<double>
      gap;  ///< mm, [row · columns + column]; infinite where the mating gear never comes

  double at(std::size_t row, std::size_t column) const { return gap[row * height.size() + column]; }
};

struct RasterSize {
  int rows = 33;
  int columns = 65;
};

/// Least gap over `positions` per pitch, on the flank of gear 1 and on that of gear 2.
///
/// Accuracy  between positions the gap is that of the parabola through three of them, which is
///           exact if contact passes at constant speed, with an error of some nm at 64 positions.
///           If the gap is least where the place comes into reach, that of the next position is
///           used
/// Domain    positions ≥ 2, a raster of 2 × 2 or more (contract)
std::array<FlankRaster, 2> contact_pattern(const ContactPair& pair, int positions,
                                           const RasterSize& size = {},
                                           Progress* progress = nullptr);

/// The gap of tooth pair k on the flank of gear 1 at the rotation `rotation1` (housing).
FlankRaster gap_map(const ContactPair& pair, Angle rotation1, int k, const RasterSize& size = {});

}  // namespace gearwright
