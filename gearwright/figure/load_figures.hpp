// The figures of teeth under load. Each of several torques has its curve. Pressures and stresses
// are those of the selected torque.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "gearwright/contact/pattern.hpp"
#include "gearwright/figure/load_scene.hpp"

namespace gearwright {

/// Transmission error, load shares, stiffness and greatest root stress over the rotation. There is
/// none if no position has a value.
std::optional<Figure> loaded_te_figure(const LoadScene& scene);
std::optional<Figure> share_figure(const LoadScene& scene);
/// The load shares of all tooth pairs at the shown torque over two pitches, each pair in its colour.
std::optional<Figure> pair_share_figure(const LoadScene& scene);
std::optional<Figure> stiffness_figure(const LoadScene& scene);
std::optional<Figure> root_turn_figure(const LoadScene& scene);
/// A transmission error over the rotation of gear 1: °, ″. The points are evenly spaced over a pitch.
struct TeCurve {
  std::string style, words;
  std::vector<Vec2> points;
};
/// Curves of several pairs with the same teeth, each from its mean. There is none if no point has a value.
std::optional<Figure> compared_te_figure(const std::vector<TeCurve>& curves);
/// Values over the torque, the Harris map. There is none if only one torque is given.
std::optional<Figure> harris_figure(const LoadScene& scene);

/// The greatest pressure over a mesh on gear `which` (0, 1). The raster contains it in MPa instead
/// of the gap, with 0 where there is no contact. It is linear between positions and slices.
FlankRaster pressure_raster(const LoadScene& scene, std::size_t which);

/// The greatest pressure at each point of a flank over a mesh, with a frame for each position that
/// shows its loaded contact lines. A second figure shows the same along the face.
///
/// Domain    teeth that touch along lines (contract)
Figure pressure_figure(const LoadScene& scene, std::size_t which);
Figure pressure_along_figure(const LoadScene& scene);

/// The contact ellipses of a tooth with point contact on its way through the mesh, on the flank of gear
/// `which`. A second figure shows the pressure in them.
///
/// Domain    teeth that touch at points, at least one position in contact (contract)
Figure ellipse_figure(const LoadScene& scene, std::size_t which);
std::optional<Figure> point_pressure_figure(const LoadScene& scene);

/// The greatest root stress along the fillet over the face, for both gears.
std::optional<Figure> root_face_figure(const LoadScene& scene);

}  // namespace gearwright
