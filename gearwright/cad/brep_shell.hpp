// Writes the faces, edges and vertices of the solid of a toothed body. Internal to cad/.
//
// Circles and cylinders are centred on the z axis, which is the axis of the body.
#pragma once

#include <array>
#include <functional>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "gearwright/cad/brep.hpp"
#include "gearwright/cad/part21.hpp"
#include "gearwright/cad/walls.hpp"

namespace gearwright::brep {

using Id = Part21Id;
using Ids = std::vector<Id>;

struct Corner {
  Id point;
  Id vertex;
};

struct Edge {
  Id edge;
  Ids poles;  ///< from the start to the end; empty for circles and for lines in one level
};

using Corners = std::vector<Corner>;
using Edges = std::vector<Edge>;

/// The edges of a loop in one level, with their vertices.
struct Rim {
  Corners corners;
  Edges edges;
};

struct Rims {
  Rim bottom;
  Rim top;
};

/// The direction of a face's normal relative to the normal of its surface.
enum class Side { along, against };

std::string spline_curve(const Ids& poles, const WallKnots& knots);
std::string spline_surface(const std::vector<Ids>& rows, const WallKnots& u, const WallKnots& v);

class ShellWriter {
 public:
  explicit ShellWriter(Part21& out) : out_(out) {}

  /// Adds one face per wall and slice. `side` is `along` if the metal is inside the loop. The walls
  /// begin at the rim `base`. If `base` is null, the function writes a new rim.
  Rims add_walls(const WallLoop& loop, const HelixSpline& helix, const Band& band, Side side,
                 const Rim* base = nullptr);

  /// The rim of the teeth in the plane of one end of a neck.
  struct NeckEnd {
    const Rim& teeth;
    double z;  ///< mm
  };
  /// Adds a neck and the two plane faces next to it. A neck is a cylinder between two sets of
  /// teeth: between two gears of a solid, or in the groove of a double-helical gear. `side` must be
  /// the value with which the teeth were added.
  void add_neck(double radius, const NeckEnd& below, const NeckEnd& above, Side side);

  /// Adds the bore or the rim and the two end faces, and completes the solid.
  Brep close(const ToothedBody& body, const BodyWalls& walls, const Rims& teeth);

  Corner corner(const Vec3& at);
  Edge edge(const Corner& from, const Corner& to, Id curve, Ids poles);
  Id circle(const Wall& wall, double turn, double z);
  Id cylinder(const Wall& wall, double turn);
  /// Adds an edge along a spline whose inner poles are pole(1) … pole(n − 2).
  Edge spline_edge(const Corner& from, const Corner& to, std::size_t n, const WallKnots& knots,
                   const std::function<Vec3(std::size_t)>& pole);

  /// The edges around a face. `bottom` and `top` run along the loop, and `left` and `right` run
  /// upwards.
  struct Sides {
    const Edge& bottom;
    const Edge& right;
    const Edge& top;
    const Edge& left;
  };
  /// Adds the spline surface that is bounded by `sides`. pole(a, b) returns the inner poles of the
  /// surface. a counts along the loop, and b counts upwards.
  Id spline_between(const Sides& sides, const WallKnots& u, const WallKnots& v,
                    const std::function<Vec3(std::size_t, std::size_t)>& pole);
  /// Returns the bound of a face. The bound runs counter-clockwise, seen from the side to which the
  /// surface normal points.
  Id face_bound(std::span<const Edge> bottom, std::span<const Edge> right,
                std::span<const Edge> top, std::span<const Edge> left);
  /// Adds a face. The first loop is the outer one, and all others are holes. All loops run
  /// counter-clockwise, seen from the side to which the surface normal points.
  void add_face(const Ids& loops, Id surface, Side side);

 private:
  void add_cap(double z, const Edges& outer, const Edges* inner, Side side);
  Brep finish(const std::string& name);
  Id centre(double z);
  Id direction(const Vec3& d);
  Id vector(const Vec3& d);
  Id frame(double z, const Vec3& x);
  Id round_frame(const Wall& wall, double turn, double z);
  Corners corners(const WallLoop& loop, const WallLevel& level);
  Edges level_edges(const WallLoop& loop, const WallLevel& level, const Corners& at);
  Id line(Id from, const Vec3& way);
  Edges upright_edges(const WallLoop& loop, const WallSlice& slice, const Corners& below,
                      const Corners& above);
  Id wall_surface(const Wall& wall, const WallSlice& slice, const Sides& sides,
                  const Corner& begin);
  Id oriented(Id edge, const char* sense);
  Id edge_loop(const Ids& uses);
  Id loop(const Edges& edges);

  Part21& out_;
  Ids faces_;
  std::size_t edge_count_ = 0;
  std::map<double, Id> centres_;  // points on the axis, by height
  std::map<std::array<double, 3>, Id> directions_;
  std::map<std::array<double, 3>, Id> vectors_;
};

// Teeth with flank modifications.
//
//   level   a plane z = const, or the line of a flank at which an end relief begins
//   layer   the part of the teeth between two levels
//   slice   the part of the teeth between two planes; it may contain several layers
//
// Flanks and fillets have one B-spline face per arc and layer (cad/modified_fit.hpp). Lands are
// true cylinders with one face per slice. The upright sides of these faces consist of one edge per
// layer. An edge on a land deviates from the cylinder by at most kHelixTarget_mm.

/// Adds the teeth of a band with flank modifications. `base` is the same as in
/// ShellWriter::add_walls().
///
/// Domain    fit = fit_modified(teeth, …), or its mirror image for the half at z < 0 (contract)
Rims add_modified_teeth(ShellWriter& shell, const ModifiedTeeth& teeth, const Band& band,
                        const ModifiedFit& fit, Side side, const Rim* base);

}  // namespace gearwright::brep
