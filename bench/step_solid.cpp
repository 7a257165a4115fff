#include "bench/step_solid.hpp"

#include <BRep_Builder.hxx>
#include <Geom_Plane.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Vertex.hxx>
#include <TopoDS_Wire.hxx>
#include <algorithm>
#include <optional>
#include <utility>

#include "bench/step_geometry.hpp"
#include "gearwright/base/contract.hpp"

namespace gearwright {
namespace {

using Edges = std::vector<TopoDS_Edge>;
using Vertices = std::vector<TopoDS_Vertex>;

struct Rims {
  Edges bottom;
  Edges top;
};

class ShellBuilder {
 public:
  ShellBuilder() { build_.MakeShell(shell_); }

  /// One face per wall and slice; `side` is FORWARD where the metal is inside the loop.
  Rims add_walls(const WallLoop& loop, const HelixSpline& helix, double face_width,
                 TopAbs_Orientation side) {
    const std::vector<StepLevel> levels = levels_of(loop, face_width);
    Vertices below = vertices(loop, levels.front());
    Edges floor = level_edges(loop, levels.front(), below);
    Rims rims{floor, {}};
    for (std::size_t s = 0; s + 1 < levels.size(); ++s) {
      const StepSlice slice = slice_between(levels[s], levels[s + 1], helix);
      Vertices above = vertices(loop, slice.high);
      Edges ceiling = level_edges(loop, slice.high, above);
      const Edges uprights = upright_edges(loop, slice, below, above);
      const std::size_t n = loop.walls.size();
      for (std::size_t i = 0; i < n; ++i) {
        add_wall(loop.walls[i], slice, {floor[i], uprights[(i + 1) % n], ceiling[i], uprights[i]},
                 side);
      }
      below = std::move(above);
      floor = std::move(ceiling);
    }
    rims.top = std::move(floor);
    return rims;
  }

  /// The plane at z inside `outer` and outside `inner`; REVERSED where it looks down.
  void add_cap(double z, const Edges& outer, const Edges* inner, TopAbs_Orientation side) {
    TopoDS_Face face;
    const gp_Ax3 frame(gp_Pnt(0.0, 0.0, z), gp_Dir(0.0, 0.0, 1.0), gp_Dir(1.0, 0.0, 0.0));
    build_.MakeFace(face, new Geom_Plane(frame), kStepTolerance_mm);
    build_.Add(face, wire(outer));
    if (inner != nullptr) build_.Add(face, wire(*inner).Reversed());
    add(face, side);
  }

  TopoDS_Solid finish() {
    shell_.Closed(Standard_True);
    TopoDS_Solid solid;
    build_.MakeSolid(solid);
    build_.Add(solid, shell_);
    return solid;
  }

  std::size_t face_count() const { return face_count_; }
  std::size_t edge_count() const { return edge_count_; }

 private:
  struct Sides {
    TopoDS_Edge bottom;
    TopoDS_Edge right;
    TopoDS_Edge top;
    TopoDS_Edge left;
  };

  Vertices vertices(const WallLoop& loop, const StepLevel& level) {
    Vertices result(loop.walls.size());
    for (std::size_t i = 0; i < result.size(); ++i) {
      build_.MakeVertex(result[i], point_at(loop.walls[i].begin, level), kStepTolerance_mm);
    }
    return result;
  }

  TopoDS_Edge edge(const Handle(Geom_Curve) & curve, StepRange range, const TopoDS_Vertex& from,
                   const TopoDS_Vertex& to) {
    TopoDS_Edge result;
    build_.MakeEdge(result, curve, kStepTolerance_mm);
    build_.Add(result, from.Oriented(TopAbs_FORWARD));
    build_.Add(result, to.Oriented(TopAbs_REVERSED));
    build_.Range(result, range.first, range.last);
    ++edge_count_;
    return result;
  }

  Edges level_edges(const WallLoop& loop, const StepLevel& level, const Vertices& at) {
    const std::size_t n = loop.walls.size();
    Edges result;
    for (std::size_t i = 0; i < n; ++i) {
      const Wall& wall = loop.walls[i];
      result.push_back(edge(level_curve(wall, level), u_range(wall), at[i], at[(i + 1) % n]));
    }
    return result;
  }

  Edges upright_edges(const WallLoop& loop, const StepSlice& slice, const Vertices& below,
                      const Vertices& above) {
    Edges result;
    for (std::size_t i = 0; i < loop.walls.size(); ++i) {
      result.push_back(edge(upright_curve(loop.walls[i].begin, slice), {slice.low.z, slice.high.z},
                            below[i], above[i]));
    }
    return result;
  }

  void add_wall(const Wall& wall, const StepSlice& slice, const Sides& sides,
                TopAbs_Orientation side) {
    TopoDS_Face face;
    build_.MakeFace(face, wall_surface(wall, slice), kStepTolerance_mm);
    // Planes draw their edges from the curves in space.
    if (wall.shape != WallShape::line) {
      const StepRange u = u_range(wall);
      trace(sides.bottom, level_trace(wall, slice, slice.low), face);
      trace(sides.top, level_trace(wall, slice, slice.high), face);
      if (sides.left.IsSame(sides.right)) {
        // One wall all the way round: the edge is a seam, met at both ends of u.
        build_.UpdateEdge(sides.left, upright_trace(wall, slice, u.last),
                          upright_trace(wall, slice, u.first), face, kStepTolerance_mm);
      } else {
        trace(sides.left, upright_trace(wall, slice, u.first), face);
        trace(sides.right, upright_trace(wall, slice, u.last), face);
      }
    }
    TopoDS_Wire loop;
    build_.MakeWire(loop);
    build_.Add(loop, sides.bottom.Oriented(TopAbs_FORWARD));
    build_.Add(loop, sides.right.Oriented(TopAbs_FORWARD));
    build_.Add(loop, sides.top.Oriented(TopAbs_REVERSED));
    build_.Add(loop, sides.left.Oriented(TopAbs_REVERSED));
    loop.Closed(Standard_True);
    build_.Add(face, loop);
    add(face, side);
  }

  void trace(const TopoDS_Edge& edge, const Handle(Geom2d_Curve) & curve, const TopoDS_Face& face) {
    build_.UpdateEdge(edge, curve, face, kStepTolerance_mm);
  }

  TopoDS_Shape wire(const Edges& edges) {
    TopoDS_Wire result;
    build_.MakeWire(result);
    for (const TopoDS_Edge& edge : edges) build_.Add(result, edge.Oriented(TopAbs_FORWARD));
    result.Closed(Standard_True);
    return result;
  }

  void add(const TopoDS_Face& face, TopAbs_Orientation side) {
    build_.Add(shell_, face.Oriented(side));
    ++face_count_;
  }

  BRep_Builder build_;
  TopoDS_Shell shell_;
  std::size_t face_count_ = 0;
  std::size_t edge_count_ = 0;
};

std::vector<StepFace> half_tooth(const BodyWalls& walls) {
  std::vector<StepFace> faces;
  for (const ArcFit& arc : walls.arcs) {
    if (!arc.spline) {
      faces.push_back({arc.name, 0, 0, 0, 0, 0, 0.0});
      continue;
    }
    const SectionSpline& s = *arc.spline;
    faces.push_back({arc.name, 0, s.basis.degree(), s.basis.poles(), walls.helix.basis.degree(),
                     walls.helix.basis.poles(),
                     s.deviation_mm + walls.outer_radius * walls.helix.deviation});
  }
  return faces;
}

}  // namespace

Result<StepSolid> make_solid(const ToothedBody& body) {
  auto made = make_walls(body);
  if (!made) return made.error();
  const BodyWalls& walls = *made;
  const bool ring = body.outline.teeth < 0;
  const auto inside = [](bool metal_inside) {
    return metal_inside ? TopAbs_FORWARD : TopAbs_REVERSED;
  };

  ShellBuilder shell;
  const double b = body.face_width;
  const Rims teeth = shell.add_walls(walls.teeth, walls.helix, b, inside(!ring));
  std::optional<Rims> bore;
  if (walls.bore) {
    bore = shell.add_walls(*walls.bore, fit_helix(0.0, walls.outer_radius), b, inside(ring));
  }
  GW_ENSURES(!ring || bore.has_value());
  const Rims& outer = ring ? *bore : teeth;
  const Rims* inner = ring ? &teeth : (bore ? &*bore : nullptr);
  shell.add_cap(-b / 2.0, outer.bottom, inner ? &inner->bottom : nullptr, TopAbs_REVERSED);
  shell.add_cap(b / 2.0, outer.top, inner ? &inner->top : nullptr, TopAbs_FORWARD);
  return StepSolid{shell.finish(), half_tooth(walls), shell.face_count(), shell.edge_count()};
}

}  // namespace gearwright
