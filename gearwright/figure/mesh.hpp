// Shows the gears of a spec in section. The housing frame is seen from +z with axis 1 on the left,
// axis 2 on the right (also for an internal gear) and y up. On crossed axes, both gears are drawn
// side by side, each along its axis.
//
// On parallel axes, gear 1 turns clockwise, and its leading flank touches gear 2 at the pitch point
// C. If there is backlash, the gap is at the trailing flank. The gears are shapes that a script
// turns, and the contact slides along the path (`FigureSlide`).
//
//   t    rotation of gear 1 from this position, in pitches
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "gearwright/figure/figure.hpp"
#include "gearwright/pair/pair.hpp"

namespace gearwright {

struct NamedCircle {
  std::string symbol;      ///< "d_a"
  double radius;           ///< mm
  const char* style = "";  ///< style classes, with a leading space
  std::string words = {};  ///< "tip diameter", shown at the pointer
};

/// Returns the symbol with the number of gear `i` (0, 1) in its index, for example "d_a1". The
/// result is empty if the circle has no symbol.
std::string symbol_of(const NamedCircle& circle, std::size_t i);

/// Returns the line style that belongs to the symbol. It is solid for tip and root circles,
/// dash-dotted for pitch circles, dashed for base circles, and dotted for other circles.
const char* style_of_circle(std::string_view symbol);

/// Tip, working pitch and base circle of gear `i` (0, 1).
std::vector<NamedCircle> mesh_circles(const InvolutePair& pair, std::size_t i);

struct MeshScene {
  std::vector<const Gear*> gears;          ///< one or two
  const MountedGears* pair = nullptr;      ///< null if the gears are not mounted
  const InvolutePair* involute = nullptr;  ///< the same pair if it is involute, else null
  std::array<std::string, 2> shapes;       ///< names of the definitions (gear_shape.hpp)
  std::array<std::vector<NamedCircle>, 2> circles{};
};
/// Makes the scene of a pair with the circles of mesh_circles() and the root circle of each gear
/// without an outline.
MeshScene mesh_scene(const InvolutePair& pair, const std::array<std::string, 2>& shapes);

/// The extent of a picture, which shows the whole gears, their mesh, or the path of contact. Gears
/// that do not mesh are shown whole.
enum class MeshFrame { whole, mesh, flank };
/// Returns the box, enlarged to this ratio of width to height.
Bounds with_aspect(const Bounds& box, double aspect);
Bounds mesh_window(const MeshScene& scene, MeshFrame frame, double aspect);

/// Draws bodies and circles with their names and axes, and for an involute pair both lines of
/// action and the path of contact with its letters.
Figure mesh_figure(const MeshScene& scene, const Bounds& window);

/// Draws the whole gears with their directions of rotation. A frame marks `framed`, the window of
/// another picture.
Figure whole_figure(const MeshScene& scene, const Bounds& window, const Bounds& framed);

Figure bodies_figure(const MeshScene& scene, const Bounds& window);

/// Draws the filled bodies of the gears and then their outlines, so that an overlap is visible.
/// `angles` are in degrees.
void add_bodies(Figure& figure, const MeshScene& scene, const std::array<double, 2>& angles);

void add_circles(Figure& figure, const MeshScene& scene, bool named);

/// Returns the rotations of gear 1 and gear 2 from the rest position of pair/pair.hpp to the
/// position in which the leading flanks touch at C, counter-clockwise seen from +z. Each rotation
/// moves the flank's point on the working pitch circle onto the centre line.
///
/// Formula   φ_1 = ψ_1, φ_2 = −σ (π/|z_2| − ψ_2). ψ_i is half of the angle of a tooth on the
///           working pitch circle, ψ_i = s_bti/d_bi − inv α_wt. If gear 2 is internal, σ = −1 and
///           ψ_2 = s_bt2/d_b2 + inv α_wt. Otherwise σ = 1
/// Units     rad
/// Domain    parallel axes
std::array<double, 2> rotation_to_pitch_point(const InvolutePair& pair);

/// Returns the angle, in degrees, by which gear `i` (0, 1) turns while gear 1 turns clockwise by
/// one pitch. Clockwise is positive, as in SVG.
///
/// Formula   360/z_1, −σ 360/|z_2|; σ = −1 if gear 2 is internal, else 1
double turn_per_pitch(const MountedGears& pair, std::size_t i);

}  // namespace gearwright
