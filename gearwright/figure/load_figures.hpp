// Makes the figures of teeth under load. Each torque has its own curve. Pressures and stresses
// belong to the selected torque.
#pragma once

#include <optional>
#include <vector>

#include "gearwright/contact/pattern.hpp"
#include "gearwright/figure/load_scene.hpp"

namespace gearwright {

/// Draw the transmission error over the rotation of gear 1, and the load share of one tooth pair
/// during its mesh. There is no figure if no position has a value.
std::optional<Figure> loaded_te_figure(const LoadScene& scene);
std::optional<Figure> share_figure(const LoadScene& scene);
/// Draws the load shares of all tooth pairs at the shown torque over two pitches, in the colours of
/// pair_style().
std::optional<Figure> pair_share_figure(const LoadScene& scene);
/// Draw the stiffness and the greatest root stress over the rotation of gear 1. There is no figure
/// if no position has a value.
std::optional<Figure> stiffness_figure(const LoadScene& scene);
std::optional<Figure> root_turn_figure(const LoadScene& scene);
/// A curve of the transmission error, ″, over the rotation of gear 1, °. The points are evenly
/// spaced over a pitch.
struct TeCurve {
  std::string style, words;
  std::vector<Vec2> points;
};
/// Draws curves of one pair with different flank modifications, each relative to its mean. There is
/// no figure if no point has a value.
std::optional<Figure> compared_te_figure(const std::vector<TeCurve>& curves);
/// Draws the Harris map, which is the transmission error over the torque. There is no figure if no
/// two torques differ, or if no torque has a result.
std::optional<Figure> harris_figure(const LoadScene& scene);

/// Returns the greatest pressure during a mesh at each point of a flank of gear `which` (0, 1). The
/// raster contains pressures in MPa instead of gaps. The pressure is 0 at points that are never in
/// contact. Pressures are interpolated linearly between positions and between slices.
FlankRaster pressure_raster(const LoadScene& scene, std::size_t which);

/// The first function draws the greatest pressure at each point of a flank during a mesh. For each
/// position of the slider, its figure also shows the loaded contact lines. The second function
/// draws the pressure along the face.
///
/// Domain    teeth that touch along lines (contract)
Figure pressure_figure(const LoadScene& scene, std::size_t which);
Figure pressure_along_figure(const LoadScene& scene);

/// The first function draws the contact ellipses of a tooth with point contact during its mesh, on
/// the flank of gear `which`. The second function draws the pressure in these ellipses.
///
/// Domain    teeth that touch at points, at least one position in contact (contract)
Figure ellipse_figure(const LoadScene& scene, std::size_t which);
std::optional<Figure> point_pressure_figure(const LoadScene& scene);

/// Draws the greatest root stress along the fillet of both gears over the position along the face.
std::optional<Figure> root_face_figure(const LoadScene& scene);

}  // namespace gearwright
