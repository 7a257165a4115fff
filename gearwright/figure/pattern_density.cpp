#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "gearwright/base/contract.hpp"
#include "gearwright/base/units.hpp"
#include "gearwright/figure/contact_figures.hpp"
#include "gearwright/figure/distribution_figures.hpp"
#include "gearwright/figure/markup.hpp"

namespace gearwright {

namespace {

const std::vector<double> kLevels{10, 30, 50, 70, 90};  // % of the samples, limits of the shades

}  // namespace

Figure density_figure(const DensityScene& scene) {
  GW_EXPECTS(scene.diameter.size() >= 2 && scene.height.size() >= 2);
  GW_EXPECTS(scene.share.size() == scene.diameter.size() * scene.height.size());
  FlankRaster raster{scene.diameter, scene.height, {}};
  for (const double share : scene.share) raster.gap.push_back(100 * share);
  Figure f = flank_frame(scene.id, fmt::format("Contact pattern of gear {}", scene.which + 1),
                         raster, scene.side, scene.which);
  const double most = *std::max_element(raster.gap.begin(), raster.gap.end());
  const std::string proportions = std::move(f.caption);
  f.description =
      "The developed usable flank, with the face from left to right, the root below and the tip "
      "above. Shades show the share of the samples whose contact pattern covers a place.";
  f.caption =
      fmt::format(
          ": the share of {} samples in which marking compound of {} µm marks a place during a "
          "full mesh. The greatest share is {} %. Brighter shades show greater shares. ",
          scene.samples, fixed(scene.marking / kMmPerUm, 2), fixed(most, 0)) +
      proportions;
  f.shades = {kLevels, "≤ 100 %", ""};
  remove_diameters(f);
  add_map(f, raster, kLevels, "share of the samples", "%");
  return f;
}

}  // namespace gearwright
