// A flank laid flat in a plot: along the face to the right, from the root at the bottom to the tip
// at the top, with its scales and the tooth that stands beyond the usable flank.
#pragma once

#include <algorithm>
#include <functional>
#include <string>
#include <string_view>

#include "gearwright/report/contact_report.hpp"
#include "gearwright/report/plot_axis.hpp"
#include "gearwright/report/svg.hpp"

namespace gearwright {

constexpr double kLowFlank = 170.0,
                 kHighFlank = 330.0;  ///< px, a flank is drawn no lower nor higher

/// The usable flank in a plot: height along the face, radius upwards to the tip.
struct FlankFrame {
  Axis z, rho;
  bool internal;
  double taller;  ///< px per mm of radius over px per mm of face

  Vec2 operator()(const FlankPlace& p) const { return {z(p.height), rho(p.radius)}; }
  double top() const { return std::min(rho.from, rho.to); }
  double bottom() const { return std::max(rho.from, rho.to); }
};

/// In true proportions where that is between `low` and `high` px.
FlankFrame frame_of(const FlankRaster& raster, bool internal, double left, double right, double top,
                    double low, double high);

/// The same with room for its scales, in a picture of its own.
FlankFrame frame_of(const FlankRaster& raster, bool internal, double low = kLowFlank);

/// Node coordinates of a raster to px.
std::function<Vec2(const Vec2&)> nodes_px(const FlankRaster& raster, const FlankFrame& f);

/// The picture of the flank of gear `which` (0, 1): the tooth beyond it, its limits with their names,
/// both scales. What follows is seen only on the flank, until end_group.
Svg flank_picture(std::string_view id, const FlankFrame& f, std::size_t which,
                  std::string_view title, std::string_view description);

/// "True proportions." or how many times higher than wide.
std::string proportions(const FlankFrame& f);

}  // namespace gearwright
