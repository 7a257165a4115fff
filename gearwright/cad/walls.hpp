// Divides the surface of a toothed body into walls. A wall is a piece of a closed loop of the
// section. Each wall gives one face per slice.
//
//   wall      a piece of a loop, counter-clockwise: a spline, a circle about the axis, or a line
//   loop      walls in order: each starts at the end of the previous one, and the loop is closed
//   slice     a layer of the body: a body with a large twist is divided into layers of equal height
//
// Tooth 0 is symmetric about the x axis. Its lower half is the mirrored outline (root to tip), and
// its upper half is the outline itself (tip to root). Tooth k is tooth 0 turned by 2πk/z. Quarter
// turns are exact.
//
// Rules that ensure valid faces
//   lands     an arc named a land is a true circle if its radius is constant within 1e-8 mm. The
//             two halves of a tip land form one wall unless the land spans more than half a turn,
//             which is possible for z = 1. The same applies to a root land. Any other arc is a
//             spline, and so is its mirror image.
//   slivers   an arc shorter than kShortestArc_mm gives no wall. The next wall begins at the start
//             of this arc. If a whole land is omitted, its two neighbours meet on the centre line.
//   slices    the number is the smallest for which a slice turns by at most π, and this turn plus
//             the angle of the widest circle is at most 3π/2. No face then meets itself, and the u
//             range of a cylinder is always less than a full turn.
#pragma once

#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "gearwright/base/result.hpp"
#include "gearwright/cad/screw_spline.hpp"
#include "gearwright/cad/toothed_body.hpp"

namespace gearwright {

inline constexpr double kShortestArc_mm = 1e-6;

enum class WallShape { spline, circle, line };

/// Knots of a spline. The knots of a section spline run from 0 to 1, counter-clockwise, and all
/// teeth share them.
struct WallKnots {
  int degree;
  std::vector<double> distinct;
  std::vector<int> multiplicity;
};

WallKnots knots_of(const BSplineBasis& basis);
/// Returns the knots of the spline in the reversed direction.
WallKnots backward(WallKnots knots);

struct Wall {
  WallShape shape;
  Complex begin;
  Complex end;
  std::shared_ptr<const WallKnots> knots;  ///< for a spline
  std::vector<Complex> poles;              ///< for a spline
  double radius = 0.0;                     ///< for a circle, mm
  double begin_angle = 0.0;                ///< for a circle, rad
  double end_angle = 0.0;  ///< for a circle, rad; at most one turn beyond begin_angle
};

struct WallLoop {
  std::vector<Wall> walls;
  int slices = 1;  ///< number of slices of each screw motion of the body
};

/// The face data for one arc of the half outline.
struct ArcFit {
  ArcName name;
  std::optional<SectionSpline> spline;  ///< absent for a true circle
};

struct BodyWalls {
  WallLoop teeth;
  std::optional<WallLoop> bore;      ///< bore, or rim of an internal gear
  std::vector<HelixSpline> helices;  ///< rotation over one slice, for each screw motion
  std::vector<ArcFit> arcs;          ///< half a tooth from root to tip, without the slivers
  double inner_radius;               ///< smallest radius of the outline, mm
  double outer_radius;               ///< greatest radius of the outline, mm
};

/// Returns the outline without slivers. It ends exactly on the centre lines of space and tooth.
///
/// Domain    the laws of the outline hold within 1e-6 mm (contract)
Outline tidied(const Outline& outline);

/// True if the arc is a land and a circle about the axis within 1e-8 mm.
bool round_land(const Arc& arc);

/// Returns the error for a face that no spline approximates within kSectionMax_mm.
Error no_spline(std::string_view face, double deviation);

/// Cuts a body into walls.
///
/// Errors    a bore that hole_error rejects (`bore.diameter_mm` and the keys of its keyway); an
///           internal gear without a rim around its roots (its bore is the rim) or with a keyway;
///           flanks that cross or a root beyond the axis (`teeth`); an arc for which no spline is
///           within kSectionMax_mm
/// Domain    face width > 0, outline.teeth ≠ 0, the laws of the outline hold within 1e-6 mm
///           (contract)
Result<BodyWalls> make_walls(const ToothedBody& body);

// The layers of a body, and the path of a section point through one layer. A layer is the part
// between two planes that cut the walls. Pole (j, i) of a wall in a slice is h_j c_i at the height
// z_j. h_j and z_j belong to the slice, and c_i belongs to the wall.

/// A plane z = const. The section in this plane is turned by an angle φ, which is τz for a body
/// with one screw motion.
struct WallLevel {
  double z;      ///< mm
  double angle;  ///< φ  rad
  Complex turn;  ///< e^{iφ}
};

/// The layer between two levels. Its helix is the helix of the body, turned by the mean angle of
/// the two levels.
struct WallSlice {
  WallLevel low;
  WallLevel high;
  double middle_angle;         ///< rad, mean of the angles of the two levels
  std::vector<Complex> helix;  ///< h_j; it begins and ends with low.turn and high.turn
  std::vector<double> height;  ///< z_j  mm
  WallKnots knots;             ///< knots in z, mm

  bool straight() const { return low.angle == high.angle; }
};

/// Returns the levels of the band of one screw motion, from bottom to top.
std::vector<WallLevel> levels_of(const Band& band, int slices);

WallSlice slice_between(const WallLevel& low, const WallLevel& high, const HelixSpline& helix);

Vec3 point_at(Complex section_point, const WallLevel& level);

/// Returns pole j of the path of a section point, 0 ≤ j < helix.size().
Vec3 climbing_pole(Complex section_point, const WallSlice& slice, std::size_t j);

}  // namespace gearwright
