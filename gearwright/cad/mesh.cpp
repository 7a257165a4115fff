#include "gearwright/cad/mesh.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

#include "gearwright/base/contract.hpp"
#include "gearwright/base/numbers.hpp"
#include "gearwright/cad/bore_loop.hpp"
#include "gearwright/cad/mesh_builder.hpp"
#include "gearwright/cad/mesh_caps.hpp"
#include "gearwright/cad/modified_mesh.hpp"
#include "gearwright/cad/section_points.hpp"

namespace gearwright {

namespace {

// The turn Δ of a level satisfies ρΔ² = 2ε, with the chord tolerance ε and the largest radius ρ. On
// the tip land, d = a²/(8ρ). A chord a = ρΔ then makes the three terms of (M1), multiplied by 8,
// equal to 2ε, 4ε and 2ε, which gives the fewest triangles.
constexpr double kLevelShare = 2.0;

// Smallest thickness between the root and the bore or rim, mm.
constexpr double kWallMin_mm = 1e-3;

// In a thin wall, the chords of the two sides must not meet. The tolerance is therefore at most
// this fraction of the wall thickness.
constexpr double kWallShare = 0.25;

// A mesh beyond these limits is rejected. The limit of vertices corresponds to a file of 200 MB,
// which printers cannot read. With the limit of points, it takes a few seconds to triangulate the
// cap of a tooth, because the cost is quadratic in the number of points.
constexpr double kVerticesMax = 2e6;
constexpr std::size_t kHalfPointsMax = 20000;

// The columns of one pitch, counter-clockwise from the middle of a tooth space to the last column
// before the next one.
std::vector<Column> pitch_columns(const std::vector<SectionPoint>& half, int copies) {
  const std::size_t n = half.size() - 1;
  const SinCos back = sincos_turn(-1, copies);
  std::vector<Column> columns;
  columns.reserve(2 * n);
  columns.push_back(
      {mirrored(half[0].point), turned(half[0].tip_normal, back), mirrored(half[0].tip_normal)});
  for (std::size_t i = 1; i < n; ++i) {
    columns.push_back(
        {mirrored(half[i].point), mirrored(half[i].root_normal), mirrored(half[i].tip_normal)});
  }
  columns.push_back({half[n].point, mirrored(half[n].root_normal), half[n].root_normal});
  for (std::size_t i = n - 1; i > 0; --i) {
    columns.push_back({half[i].point, half[i].tip_normal, half[i].root_normal});
  }
  return columns;
}

std::vector<Vec2> points_of(const std::vector<SectionPoint>& half) {
  std::vector<Vec2> points;
  for (const SectionPoint& p : half) points.push_back(p.point);
  return points;
}

// Smallest distance from the axis to the polygon of the section.
double polygon_reach_min(const std::vector<SectionPoint>& half) {
  double reach = half.front().point.norm();
  for (std::size_t i = 0; i + 1 < half.size(); ++i) {
    const Vec2 a = half[i].point;
    const Vec2 chord = half[i + 1].point - a;
    const double t = std::clamp(-a.dot(chord) / chord.squaredNorm(), 0.0, 1.0);
    reach = std::min(reach, (a + t * chord).norm());
  }
  return reach;
}

// The band of a circular wall of an internal gear: the rim or the groove. At both ends, the columns
// of this wall must have the rotation of the teeth. The wall therefore has the screw motion of the
// teeth. For a double-helical gear, it turns evenly from one end rotation to the other.
Band around(const ToothedBody& body, double width) {
  if (!body.two_helices) return body.bands().front();
  const double stagger = body.two_helices->stagger;
  return {-stagger / width, width, 0.0, body.twist * width / 2.0 + stagger / 2.0};
}

}  // namespace

Result<TriangleMesh> tessellate(const ToothedBody& body, const MeshOptions& options) {
  if (body.rack) return tessellate_rack(body, options);
  GW_EXPECTS(options.chord_tolerance_mm > 0.0);
  const double facet_turn = options.facet_turn_max.rad();
  GW_EXPECTS(facet_turn > 0.0 && facet_turn <= kPi / 4.0);
  GW_EXPECTS(body.face_width > 0.0 && body.outline.teeth != 0);
  const int teeth = body.outline.teeth;
  const int copies = std::abs(teeth);
  const bool ring = teeth < 0;

  if (body.outline.arcs.empty()) {
    return not_a_body(teeth, "its teeth are severed or its root lies beyond the axis");
  }
  const Vec2 root = body.outline.arcs.front().begin_point;
  const auto [ray_s, ray_c] = sincos_turn(1, 2LL * copies);
  if (!(root.dot(Vec2(ray_c, ray_s)) > 0.0)) {
    return not_a_body(teeth, "its root lies beyond the axis");
  }

  const double limit = body.limit_within(root.norm());
  if (auto error = hole_error(body.bore, body.hole_limits(root.norm()), kWallMin_mm))
    return *std::move(error);
  const double reach = body.bore ? bore_reach(*body.bore) : 0.0;
  double given = std::min(options.chord_tolerance_mm, kWallShare * std::abs(limit - reach));
  if (body.grooved()) given = std::min(given, kWallShare * std::abs(root.norm() - limit));
  const ModifiedTeeth* modified = body.modified.get();
  const Outline& cut = modified ? modified->outline() : body.outline;
  const double chord = modified ? kCutShare * given : given;

  // The levels along the face.
  const double radius_max =
      ring ? body.bore->diameter / 2.0 : body.outline.arcs.back().end_point.norm();
  const double turn_max = std::min(std::sqrt(kLevelShare * chord / radius_max), facet_turn);
  const std::vector<Band> bands = body.bands();
  const double turn = std::abs(body.twist) * bands.front().width;
  const double steps = std::max(1.0, std::ceil(turn / turn_max));
  const auto too_fine = [&] {
    return Error{"chord_tolerance_mm", fmt::format("{}", options.chord_tolerance_mm),
                 fmt::format("the mesh would have more than {:.0e} vertices, or more than {} on "
                             "half a tooth; increase the tolerance",
                             kVerticesMax, kHalfPointsMax)};
  };
  if (steps > kVerticesMax) return too_fine();
  const Levels levels{static_cast<int>(steps), bands.front()};
  const SectionTolerance tolerance{chord, facet_turn, turn / steps, radius_max};

  // The section points.
  std::vector<SectionPoint> half = section_points(cut, tolerance, kHalfPointsMax + 1);
  if (half.size() > kHalfPointsMax + 1) return too_fine();
  std::optional<ModifiedGrid> grid;
  if (modified) {
    grid =
        modified_grid(*modified, std::move(half), body.face_width, body.face_width / steps, given);
    half = grid->half;
  }
  const std::size_t n = half.size() - 1;
  const double rings = grid ? static_cast<double>(grid->levels.size())
                            : (steps + 1.0) * static_cast<double>(bands.size());
  if (n > kHalfPointsMax) return too_fine();
  if (2.0 * static_cast<double>(n) * copies * rings > kVerticesMax) return too_fine();
  for (std::size_t i = 1; i < n; ++i) {
    if (!(half[i].point.y() > 0.0)) return not_a_body(teeth, "the flanks of a tooth cross");
  }
  const double room = polygon_reach_min(half);
  const auto cap_at = [&](double radius, double z) {
    const Circle circle =
        ring ? rim_circle(radius, copies, tolerance) : hub_circle(radius, room, copies);
    if (!modified) return Cap::divide(points_of(half), points_of(half), circle, teeth);
    return Cap::divide(modified_half(modified->side(false), *grid, z),
                       modified_half(modified->side(true), *grid, z), circle, teeth);
  };
  const Levels above{levels.steps, bands.back()};
  const double end = above.z(above.steps);
  const double rim_or_reach = ring ? radius_max : reach;
  const auto top_cap = cap_at(rim_or_reach, end);
  const auto bottom_cap = modified ? cap_at(rim_or_reach, -end) : top_cap;
  if (!top_cap || !bottom_cap) return not_a_body(teeth, "the flanks of a tooth space cross");

  // The walls.
  MeshBuilder builder;
  WallEnds outline{};
  if (modified) {
    WallEdges edges = edges_of(pitch_columns(half, copies), copies, levels);
    crease_at_reliefs(*modified, *grid, edges);
    outline = builder.add_wall(modified_rings(*modified, *grid, copies), edges, copies, ring);
  } else {
    outline = builder.add_wall(pitch_columns(half, copies), copies, levels, ring);
  }
  WallEnds lower = outline, upper = outline;
  if (bands.size() == 2) {
    upper = builder.add_wall(pitch_columns(half, copies), copies, above, ring,
                             body.grooved() ? nullptr : &lower);
  }

  // The bore or the rim, and the end faces.
  const CapPlace bottom{false, -end, bands.front().angle(-end), lower.bottom};
  const CapPlace top{true, end, bands.back().angle(end), upper.top};
  if (ring) {
    const WallEnds rim = builder.add_wall(top_cap->circle_columns(false), copies,
                                          {levels.steps, around(body, body.face_width)}, false);
    bottom_cap->add(builder, bottom, rim.bottom);
    top_cap->add(builder, top, rim.top);
  } else {
    WallEnds bore{};
    std::vector<Column> columns;
    if (body.bore) {
      columns = bore_columns(*body.bore, chord, facet_turn);
      bore = builder.add_wall(columns, 1, {1, {0.0, body.face_width, 0.0, 0.0}}, true);
    }
    bottom_cap->add(builder, bottom, columns, bore.bottom);
    top_cap->add(builder, top, columns, bore.top);
  }
  if (body.grooved()) {
    const auto& [gap, radius, stagger] = *body.two_helices;
    const auto cap = cap_at(radius, 0.0);
    if (!cap) return not_a_body(teeth, "the flanks of a tooth space cross");
    const CapPlace under{true, -gap / 2.0, bands.front().angle(-gap / 2.0), lower.top};
    const CapPlace over{false, gap / 2.0, bands.back().angle(gap / 2.0), upper.bottom};
    if (ring) {
      const WallEnds groove = builder.add_wall(cap->circle_columns(true), copies,
                                               {levels.steps, around(body, gap)}, true);
      cap->add(builder, under, groove.bottom);
      cap->add(builder, over, groove.top);
    } else {
      std::vector<Column> columns = bore_columns({2.0 * radius}, chord, facet_turn);
      for (Column& column : columns) column.before = column.after = -column.after;
      const WallEnds groove = builder.add_wall(columns, 1, {1, {0.0, gap, 0.0, 0.0}}, false);
      cap->add(builder, under, columns, groove.bottom);
      cap->add(builder, over, columns, groove.top);
    }
  }
  return std::move(builder).take();
}

double mesh_volume(const TriangleMesh& mesh) {
  double six = 0.0;
  for (const Triangle& t : mesh.triangles) {
    six += mesh.vertices[t[0]].dot(mesh.vertices[t[1]].cross(mesh.vertices[t[2]]));
  }
  return six / 6.0;
}

}  // namespace gearwright
