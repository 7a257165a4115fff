#include "gearwright/cad/brep_shell.hpp"

#include <fmt/format.h>

#include <optional>
#include <utility>

#include "gearwright/base/contract.hpp"
#include "gearwright/cad/bore_loop.hpp"

namespace gearwright::brep {

namespace {

const char* word(Side side) { return side == Side::along ? ".T." : ".F."; }

Vec3 along(const Wall& wall, Complex turn) {
  const Complex way = (wall.end - wall.begin) * turn;
  return Vec3(way.real(), way.imag(), 0.0).normalized();
}

}  // namespace

std::string spline_curve(const Ids& poles, const WallKnots& knots) {
  std::string text = fmt::format("B_SPLINE_CURVE_WITH_KNOTS('',{},", knots.degree);
  append_ids(text, poles);
  text += ",.UNSPECIFIED.,.F.,.F.,";
  append_integers(text, knots.multiplicity);
  text += ',';
  append_reals(text, knots.distinct);
  return text + ",.UNSPECIFIED.)";
}

std::string spline_surface(const std::vector<Ids>& rows, const WallKnots& u, const WallKnots& v) {
  std::string text = fmt::format("B_SPLINE_SURFACE_WITH_KNOTS('',{},{},", u.degree, v.degree);
  char separator = '(';
  for (const Ids& row : rows) {
    text += separator;
    append_ids(text, row);
    separator = ',';
  }
  text += "),.UNSPECIFIED.,.F.,.F.,.F.,";
  append_integers(text, u.multiplicity);
  text += ',';
  append_integers(text, v.multiplicity);
  text += ',';
  append_reals(text, u.distinct);
  text += ',';
  append_reals(text, v.distinct);
  return text + ",.UNSPECIFIED.)";
}

Rims ShellWriter::add_walls(const WallLoop& loop, const HelixSpline& helix, const Band& band,
                            Side side, const Rim* base) {
  const std::vector<WallLevel> levels = levels_of(band, loop.slices);
  Corners below = base ? base->corners : corners(loop, levels.front());
  Edges floor = base ? base->edges : level_edges(loop, levels.front(), below);
  Rims rims{{below, floor}, {}};
  for (std::size_t s = 0; s + 1 < levels.size(); ++s) {
    const WallSlice slice = slice_between(levels[s], levels[s + 1], helix);
    Corners above = corners(loop, slice.high);
    Edges ceiling = level_edges(loop, slice.high, above);
    const Edges uprights = upright_edges(loop, slice, below, above);
    const std::size_t n = loop.walls.size();
    for (std::size_t i = 0; i < n; ++i) {
      const Sides sides{floor[i], uprights[(i + 1) % n], ceiling[i], uprights[i]};
      const Id bound =
          face_bound({&sides.bottom, 1}, {&sides.right, 1}, {&sides.top, 1}, {&sides.left, 1});
      add_face({bound}, wall_surface(loop.walls[i], slice, sides, below[i]), side);
    }
    below = std::move(above);
    floor = std::move(ceiling);
  }
  rims.top = {std::move(below), std::move(floor)};
  return rims;
}

void ShellWriter::add_neck(double radius, const NeckEnd& below, const NeckEnd& above, Side side) {
  const bool ring = side == Side::against;
  const Band band{0.0, above.z - below.z, (below.z + above.z) / 2.0, 0.0};
  const Rims neck = add_walls(circle_loop(radius), fit_helix(0.0, radius), band, side);
  const auto plane = [&](const NeckEnd& end, const Rim& round, Side to) {
    const Edges& teeth = end.teeth.edges;
    add_cap(end.z, ring ? round.edges : teeth, ring ? &teeth : &round.edges, to);
  };
  plane(below, neck.bottom, Side::along);
  plane(above, neck.top, Side::against);
}

Brep ShellWriter::close(const ToothedBody& body, const BodyWalls& walls, const Rims& teeth) {
  const bool ring = body.ring();
  const double low = body.gears().front().bottom(), high = body.gears().back().top();
  std::optional<Rims> bore;
  if (walls.bore)
    bore =
        add_walls(*walls.bore, fit_helix(0.0, walls.outer_radius),
                  {0.0, high - low, (low + high) / 2.0, 0.0}, ring ? Side::along : Side::against);
  GW_EXPECTS(!ring || bore.has_value());
  const Rims& outer = ring ? *bore : teeth;
  const Rims* inner = ring ? &teeth : (bore ? &*bore : nullptr);
  add_cap(low, outer.bottom.edges, inner ? &inner->bottom.edges : nullptr, Side::against);
  add_cap(high, outer.top.edges, inner ? &inner->top.edges : nullptr, Side::along);
  return finish(body.name);
}

// Adds a plane face at the height z. Its boundary is `outer`, and its hole is `inner` if this is
// not null.
void ShellWriter::add_cap(double z, const Edges& outer, const Edges* inner, Side side) {
  Ids loops{loop(outer)};
  if (inner != nullptr) loops.push_back(loop(*inner));
  add_face(loops, out_.add(fmt::format("PLANE('',#{})", frame(z, Vec3::UnitX()))), side);
}

Brep ShellWriter::finish(const std::string& name) {
  std::string shell = "CLOSED_SHELL('',";
  append_ids(shell, faces_);
  const Id closed = out_.add(shell + ")");
  const Id solid =
      out_.add(fmt::format("MANIFOLD_SOLID_BREP({},#{})", part21_string(name), closed));
  return {solid, faces_.size(), edge_count_};
}

Id ShellWriter::centre(double z) {
  Id& id = centres_[z];
  if (id == 0) id = out_.point({0.0, 0.0, z});
  return id;
}

Id ShellWriter::direction(const Vec3& d) {
  Id& id = directions_[{d.x(), d.y(), d.z()}];
  if (id == 0) id = out_.direction(d);
  return id;
}

Id ShellWriter::vector(const Vec3& d) {
  Id& id = vectors_[{d.x(), d.y(), d.z()}];
  if (id == 0) id = out_.add(fmt::format("VECTOR('',#{},1.)", direction(d)));
  return id;
}

// Returns a coordinate system on the axis of the gear. In each call of this function, at most one
// argument writes instances of the file. C++ does not define the order in which arguments are
// evaluated, so with two such arguments the numbers of the instances would depend on the compiler.
Id ShellWriter::frame(double z, const Vec3& x) {
  const Id origin = centre(z);
  const Id up = direction(Vec3::UnitZ());
  return out_.placement(origin, up, direction(x));
}

// Returns the coordinate system of a circle or cylinder. The x direction is opposite to the middle
// of the wall. A wall that spans less than a full turn therefore never crosses the seam of the
// surface, which is at u = 0.
Id ShellWriter::round_frame(const Wall& wall, double turn, double z) {
  const Complex middle = std::polar(1.0, 0.5 * (wall.begin_angle + wall.end_angle) + turn);
  return frame(z, {-middle.real(), -middle.imag(), 0.0});
}

Id ShellWriter::circle(const Wall& wall, double turn, double z) {
  std::string circle = fmt::format("CIRCLE('',#{},", round_frame(wall, turn, z));
  append_real(circle, wall.radius);
  return out_.add(circle + ")");
}

Id ShellWriter::cylinder(const Wall& wall, double turn) {
  std::string cylinder = fmt::format("CYLINDRICAL_SURFACE('',#{},", round_frame(wall, turn, 0.0));
  append_real(cylinder, wall.radius);
  return out_.add(cylinder + ")");
}

Corner ShellWriter::corner(const Vec3& at) {
  const Id point = out_.point(at);
  return {point, out_.add(fmt::format("VERTEX_POINT('',#{})", point))};
}

Corners ShellWriter::corners(const WallLoop& loop, const WallLevel& level) {
  Corners result;
  for (const Wall& wall : loop.walls) result.push_back(corner(point_at(wall.begin, level)));
  return result;
}

Edge ShellWriter::edge(const Corner& from, const Corner& to, Id curve, Ids poles) {
  ++edge_count_;
  return {out_.add(fmt::format("EDGE_CURVE('',#{},#{},#{},.T.)", from.vertex, to.vertex, curve)),
          std::move(poles)};
}

Edge ShellWriter::spline_edge(const Corner& from, const Corner& to, std::size_t n,
                              const WallKnots& knots,
                              const std::function<Vec3(std::size_t)>& pole) {
  Ids poles{from.point};
  for (std::size_t k = 1; k + 1 < n; ++k) poles.push_back(out_.point(pole(k)));
  poles.push_back(to.point);
  const Id curve = out_.add(spline_curve(poles, knots));
  return edge(from, to, curve, std::move(poles));
}

Id ShellWriter::spline_between(const Sides& sides, const WallKnots& u, const WallKnots& v,
                               const std::function<Vec3(std::size_t, std::size_t)>& pole) {
  std::vector<Ids> rows{sides.left.poles};
  for (std::size_t a = 1; a + 1 < sides.bottom.poles.size(); ++a) {
    Ids row{sides.bottom.poles[a]};
    for (std::size_t b = 1; b + 1 < sides.left.poles.size(); ++b)
      row.push_back(out_.point(pole(a, b)));
    row.push_back(sides.top.poles[a]);
    rows.push_back(std::move(row));
  }
  rows.push_back(sides.right.poles);
  return out_.add(spline_surface(rows, u, v));
}

Edges ShellWriter::level_edges(const WallLoop& loop, const WallLevel& level, const Corners& at) {
  const std::size_t n = loop.walls.size();
  Edges result;
  for (std::size_t i = 0; i < n; ++i) {
    const Wall& wall = loop.walls[i];
    const Corner& from = at[i];
    const Corner& to = at[(i + 1) % n];
    switch (wall.shape) {
      case WallShape::spline:
        result.push_back(spline_edge(from, to, wall.poles.size(), *wall.knots, [&](std::size_t k) {
          return point_at(wall.poles[k], level);
        }));
        break;
      case WallShape::circle:
        result.push_back(edge(from, to, circle(wall, level.angle, level.z), {}));
        break;
      case WallShape::line:
        result.push_back(edge(from, to, line(from.point, along(wall, level.turn)), {}));
        break;
    }
  }
  return result;
}

Id ShellWriter::line(Id from, const Vec3& way) {
  return out_.add(fmt::format("LINE('',#{},#{})", from, vector(way)));
}

Edges ShellWriter::upright_edges(const WallLoop& loop, const WallSlice& slice, const Corners& below,
                                 const Corners& above) {
  Edges result;
  for (std::size_t i = 0; i < loop.walls.size(); ++i) {
    if (slice.straight()) {
      const Id curve = line(below[i].point, Vec3::UnitZ());
      result.push_back(edge(below[i], above[i], curve, {below[i].point, above[i].point}));
      continue;
    }
    result.push_back(
        spline_edge(below[i], above[i], slice.helix.size(), slice.knots,
                    [&](std::size_t j) { return climbing_pole(loop.walls[i].begin, slice, j); }));
  }
  return result;
}

Id ShellWriter::wall_surface(const Wall& wall, const WallSlice& slice, const Sides& sides,
                             const Corner& begin) {
  switch (wall.shape) {
    case WallShape::spline:
      return spline_between(sides, *wall.knots, slice.knots, [&](std::size_t a, std::size_t b) {
        return climbing_pole(wall.poles[a], slice, b);
      });
    case WallShape::circle: return cylinder(wall, slice.middle_angle);
    case WallShape::line: {
      GW_EXPECTS(slice.straight());
      const Vec3 way = along(wall, slice.low.turn);
      // The normal, `way` × z, points out of the loop. u runs along the loop, and v runs upwards.
      const Id normal = direction({way.y(), -way.x(), 0.0});
      const Id axes = out_.placement(begin.point, normal, direction(way));
      return out_.add(fmt::format("PLANE('',#{})", axes));
    }
  }
  contract_failed("postcondition", "known wall shape", __FILE__, __LINE__);
}

Id ShellWriter::oriented(Id edge, const char* sense) {
  return out_.add(fmt::format("ORIENTED_EDGE('',*,*,#{},{})", edge, sense));
}

Id ShellWriter::edge_loop(const Ids& uses) {
  std::string text = "EDGE_LOOP('',";
  append_ids(text, uses);
  return out_.add(text + ")");
}

Id ShellWriter::face_bound(std::span<const Edge> bottom, std::span<const Edge> right,
                           std::span<const Edge> top, std::span<const Edge> left) {
  Ids uses;
  for (const Edge& e : bottom) uses.push_back(oriented(e.edge, ".T."));
  for (const Edge& e : right) uses.push_back(oriented(e.edge, ".T."));
  for (const Edge& e : top) uses.push_back(oriented(e.edge, ".F."));
  for (auto e = left.rbegin(); e != left.rend(); ++e) uses.push_back(oriented(e->edge, ".F."));
  return edge_loop(uses);
}

Id ShellWriter::loop(const Edges& edges) {
  Ids uses;
  for (const Edge& e : edges) uses.push_back(oriented(e.edge, ".T."));
  return edge_loop(uses);
}

// All loops run counter-clockwise, seen from the side to which the surface normal points. In STEP,
// an outer bound runs counter-clockwise about the face normal, while the bound of a hole runs
// clockwise.
void ShellWriter::add_face(const Ids& loops, Id surface, Side side) {
  std::string text = "ADVANCED_FACE('',";
  Ids bounds;
  for (std::size_t i = 0; i < loops.size(); ++i) {
    const bool turned = (i > 0) != (side == Side::against);
    bounds.push_back(
        out_.add(fmt::format("{}('',#{},{})", i == 0 ? "FACE_OUTER_BOUND" : "FACE_BOUND", loops[i],
                             turned ? ".F." : ".T.")));
  }
  append_ids(text, bounds);
  faces_.push_back(out_.add(text + fmt::format(",#{},{})", surface, word(side))));
}

}  // namespace gearwright::brep
