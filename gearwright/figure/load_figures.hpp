// The figures of teeth under load. Each of several torques has its curve. Pressures and stresses
// are those of the chosen one.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "gearwright/contact/pattern.hpp"
#include "gearwright/figure/load_scene.hpp"

namespace gearwright {

/// Transmission error, load shares, stiffness and greatest root stress over the rotation; none if
/// no position has a value.
std::optional<Figure> loaded_te_figure(const LoadScene& scene);
std::optional<Figure> share_figure(const LoadScene& scene);
std::optional<Figure> stiffness_figure(const LoadScene& scene);
std::optional<Figure> root_turn_figure(const LoadScene& scene);
/// Values over the torque, the Harris map; none with one torque.
std::optional<Figure> harris_figure(const LoadScene& scene);

/// The greatest pressure over a mesh on gear `which` (0, 1), in MPa instead of the gap: 0 without
/// contact. Between positions and slices it is linear.
FlankRaster pressure_raster(const LoadScene& scene, std::size_t which);

/// The greatest pressure at each place of a flank over a mesh, and a frame for each position with
/// its loaded contact lines; and the same along the face.
///
/// Domain    teeth that touch along lines (contract)
Figure pressure_figure(const LoadScene& scene, std::size_t which);
Figure pressure_along_figure(const LoadScene& scene);

/// Point contact: the ellipses of a tooth on its way through the mesh on the flank of gear `which`,
/// and its pressure.
///
/// Domain    teeth that touch at points, at least one position in contact (contract)
Figure ellipse_figure(const LoadScene& scene, std::size_t which);
std::optional<Figure> point_pressure_figure(const LoadScene& scene);

/// The greatest root stress along the fillet over the face, of both gears.
std::optional<Figure> root_face_figure(const LoadScene& scene);

}  // namespace gearwright
