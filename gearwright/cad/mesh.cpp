#include "gearwright/cad/mesh.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <string>
#include <utility>

#include "gearwright/base/angle.hpp"
#include "gearwright/base/contract.hpp"
#include "gearwright/base/numbers.hpp"
#include "gearwright/cad/bore_loop.hpp"
#include "gearwright/cad/flat_cap.hpp"
#include "gearwright/cad/mesh_builder.hpp"
#include "gearwright/cad/modified_mesh.hpp"
#include "gearwright/cad/rack_mesh.hpp"
#include "gearwright/cad/section_points.hpp"

namespace gearwright {

namespace {

// The level height satisfies ρΔ² = 2ε on the largest radius. On the tip land, where κ = 1/ρ, the
// three terms of (M1) are then 2ε, 4ε and 2ε of 8ε at a = ρΔ, which gives the fewest triangles.
constexpr double kLevelShare = 2.0;

// Least material between the root and the bore or the rim, mm.
constexpr double kWallMin_mm = 1e-3;

// The chords of the two sides of a thin wall must not meet. Therefore the tolerance is at most this
// part of the wall's thickness.
constexpr double kWallShare = 0.25;

// Limits beyond which a mesh is rejected: a file of 200 MB, which printers cannot read, and a few
// seconds for the caps of a tooth (quadratic in the number of its points).
constexpr double kVerticesMax = 2e6;
constexpr std::size_t kHalfPointsMax = 20000;

// The columns of one pitch, counter-clockwise from the middle of a space to just before the next.
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

// The hub circle (or an internal gear's rim) as columns of one pitch: 2q points, the first on the
// ray −π/|z|.
std::vector<Column> circle_columns(double radius, int q, int copies) {
  std::vector<Column> columns;
  for (int i = -q; i < q; ++i) {
    const auto [s, c] = sincos_turn(i, 2LL * q * copies);
    const Vec2 radial(c, s);
    columns.push_back({radius * radial, radial, radial});
  }
  return columns;
}

// Triangles of one half pitch of a cap, by local corner: 0 … n the half section from root to tip,
// n + 1 … n + 1 + q the circle from the tooth's centre line to the middle of the space.
std::optional<std::vector<Triangle>> half_pitch_cap(std::vector<Vec2> corners,
                                                    const std::vector<Column>& circle, bool ring) {
  for (std::size_t j = circle.size() / 2 + 1; j-- > 0;) {
    corners.push_back(mirrored(circle[j].point));
  }
  // Clockwise around an external tooth's material, counter-clockwise around an internal gear's.
  const std::size_t count = corners.size();
  if (!ring) std::reverse(corners.begin(), corners.end());
  auto triangles = clip_ears(corners);
  if (triangles && !ring) {
    for (Triangle& t : *triangles) {
      for (std::uint32_t& corner : t) corner = static_cast<std::uint32_t>(count - 1 - corner);
    }
  }
  return triangles;
}

std::vector<Vec2> points_of(const std::vector<SectionPoint>& half) {
  std::vector<Vec2> points;
  for (const SectionPoint& p : half) points.push_back(p.point);
  return points;
}

// Triangles of a half pitch of a cap: of the lower halves of the teeth, of the upper ones.
using HalfCaps = std::array<std::vector<Triangle>, 2>;

// The part of a cap between the teeth's outline and the circle.
void add_tooth_caps(MeshBuilder& builder, const HalfCaps& half_caps, int copies, std::size_t n,
                    std::size_t q, std::uint32_t outline, std::uint32_t circle) {
  const std::size_t z = static_cast<std::size_t>(copies);
  for (std::size_t k = 0; k < z; ++k) {
    const auto left = [&](std::uint32_t corner) {
      const std::size_t i = corner <= n ? (k * 2 * n + 2 * n - corner) % (2 * n * z)
                                        : (k * 2 * q + q + (corner - n - 1)) % (2 * q * z);
      return static_cast<std::uint32_t>((corner <= n ? outline : circle) + i);
    };
    const auto right = [&](std::uint32_t corner) {
      const std::size_t i = corner <= n ? k * 2 * n + corner : k * 2 * q + q - (corner - n - 1);
      return static_cast<std::uint32_t>((corner <= n ? outline : circle) + i);
    };
    const auto& [lower, upper] = half_caps;
    for (std::size_t i = 0; i < upper.size(); ++i) {
      const Triangle &t = upper[i], &u = lower[i];
      builder.add_cap_triangle(left(t[0]), left(t[1]), left(t[2]));
      builder.add_cap_triangle(right(u[0]), right(u[2]), right(u[1]));
    }
  }
}

// Distance of the section's polygon from the axis.
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

// The circle between the caps of the teeth and those of the hub, or the rim of an internal gear.
struct Circle {
  double radius;  // mm
  int q;          // points per half pitch
};

// The circle lies halfway between bore and root. Its step δ satisfies R cos δ ≥ r, which zip_ring
// requires.
Circle hub_circle(double bore_reach, double root_reach, int copies) {
  const double radius = 0.5 * (bore_reach + root_reach);
  const double step = std::min(std::acos(bore_reach / radius), kPi / 4.0);
  return {radius, std::max(1, static_cast<int>(std::ceil(kPi / (copies * step))))};
}

// The step follows from (M1) with d = a²/(8ρ), as for the tip land of an external gear.
Circle rim_circle(double radius, int copies, const SectionTolerance& tolerance) {
  const double turn = tolerance.level_turn;
  const double slack = 8.0 * tolerance.chord - radius * turn * turn;
  const double a = slack / (turn + std::sqrt(turn * turn + slack / radius));
  const double step = std::min(a / radius, tolerance.facet_turn);
  return {radius, std::max(1, static_cast<int>(std::ceil(kPi / (copies * step))))};
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

  const auto error = ring        ? rim_error(body, root.norm() + kWallMin_mm)
                     : body.bore ? bore_error(*body.bore, root.norm() - kWallMin_mm)
                                 : std::nullopt;
  if (error) return *error;
  const double reach = body.bore ? bore_reach(*body.bore) : 0.0;
  const double given =
      std::min(options.chord_tolerance_mm, kWallShare * std::abs(root.norm() - reach));
  const ModifiedTeeth* modified = body.modified.get();
  const Outline& cut = modified ? modified->outline() : body.outline;
  const double chord = modified ? kCutShare * given : given;

  // Levels along the face.
  const double radius_max =
      ring ? body.bore->diameter / 2.0 : body.outline.arcs.back().end_point.norm();
  const double turn_max = std::min(std::sqrt(kLevelShare * chord / radius_max), facet_turn);
  const double steps = std::max(1.0, std::ceil(std::abs(body.twist) * body.face_width / turn_max));
  const auto too_fine = [&] {
    return Error{"chord_tolerance_mm", fmt::format("{}", options.chord_tolerance_mm),
                 fmt::format("the mesh would have more than {:.0e} vertices, or more than {} on "
                             "half a tooth; increase the tolerance",
                             kVerticesMax, kHalfPointsMax)};
  };
  if (steps > kVerticesMax) return too_fine();
  const Levels levels{static_cast<int>(steps), body.twist, body.face_width};
  const SectionTolerance tolerance{chord, facet_turn,
                                   std::abs(body.twist) * body.face_width / steps, radius_max};

  // The section.
  std::vector<SectionPoint> half = section_points(cut, tolerance, kHalfPointsMax + 1);
  if (half.size() > kHalfPointsMax + 1) return too_fine();
  std::optional<ModifiedGrid> grid;
  if (modified) {
    grid =
        modified_grid(*modified, std::move(half), body.face_width, body.face_width / steps, given);
    half = grid->half;
  }
  const std::size_t n = half.size() - 1;
  const double rings = grid ? static_cast<double>(grid->levels.size()) : steps + 1.0;
  if (n > kHalfPointsMax) return too_fine();
  if (2.0 * static_cast<double>(n) * copies * rings > kVerticesMax) return too_fine();
  for (std::size_t i = 1; i < n; ++i) {
    if (!(half[i].point.y() > 0.0)) return not_a_body(teeth, "the flanks of a tooth cross");
  }
  const double room = polygon_reach_min(half);
  const Circle circle =
      ring ? rim_circle(radius_max, copies, tolerance) : hub_circle(reach, room, copies);
  const std::size_t q = static_cast<std::size_t>(circle.q);
  const std::vector<Column> circle_part = circle_columns(circle.radius, circle.q, copies);
  std::array<HalfCaps, 2> half_caps;  // of the lower and the upper end
  for (std::size_t end = 0; end < 2; ++end) {
    for (std::size_t side = 0; side < 2; ++side) {
      if (!modified && end + side > 0) {
        half_caps[end][side] = half_caps[0][0];
        continue;
      }
      auto cap = half_pitch_cap(modified ? modified_half(modified->side(side == 1), *grid,
                                                         levels.z(end == 1 ? levels.steps : 0))
                                         : points_of(half),
                                circle_part, ring);
      if (!cap) return not_a_body(teeth, "the flanks of a space cross");
      half_caps[end][side] = *std::move(cap);
    }
  }

  // Walls.
  MeshBuilder builder;
  WallEnds outline{};
  if (modified) {
    WallEdges edges = edges_of(pitch_columns(half, copies), copies, levels);
    crease_at_reliefs(*modified, *grid, edges);
    outline = builder.add_wall(modified_rings(*modified, *grid, copies), edges, copies, ring);
  } else {
    outline = builder.add_wall(pitch_columns(half, copies), copies, levels, ring);
  }
  WallEnds rim{};
  WallEnds bore{};
  std::vector<Column> bore_part;
  if (ring) rim = builder.add_wall(circle_part, copies, levels, false);
  if (body.bore && !ring) {
    bore_part = bore_columns(*body.bore, chord, facet_turn);
    bore = builder.add_wall(bore_part, 1, {1, 0.0, body.face_width}, true);
  }

  // Caps.
  const std::size_t outline_count = 2 * n * static_cast<std::size_t>(copies);
  const std::size_t circle_count = 2 * q * static_cast<std::size_t>(copies);
  for (const bool up : {false, true}) {
    const std::uint32_t outline_first = up ? outline.top : outline.bottom;
    std::uint32_t circle_first = up ? rim.top : rim.bottom;
    const double z = levels.z(up ? levels.steps : 0);
    builder.begin_cap(up);
    if (!ring) {
      const SinCos screw = sincos_of(body.twist * z);
      std::vector<Vec2> points;
      for (const Column& column : circle_part) points.push_back(turned(column.point, screw));
      circle_first = builder.add_points(points, copies, z);
    }
    builder.use_in_cap(outline_first, outline_count);
    builder.use_in_cap(circle_first, circle_count);
    add_tooth_caps(builder, half_caps[up ? 1 : 0], copies, n, q, outline_first, circle_first);
    if (ring) continue;
    if (body.bore) {
      const std::uint32_t bore_first = up ? bore.top : bore.bottom;
      std::vector<Vec2> inner, outer;
      for (const Column& column : bore_part) inner.push_back(column.point);
      for (std::size_t i = 0; i < circle_count; ++i) {
        outer.emplace_back(builder.mesh().vertices[circle_first + i].head<2>());
      }
      builder.use_in_cap(bore_first, inner.size());
      const auto vertex = [&](std::uint32_t corner) {
        const auto count = static_cast<std::uint32_t>(inner.size());
        return corner < count ? bore_first + corner : circle_first + (corner - count);
      };
      for (const Triangle& t : zip_ring(inner, outer)) {
        builder.add_cap_triangle(vertex(t[0]), vertex(t[1]), vertex(t[2]));
      }
    } else {
      const std::uint32_t centre = builder.add_points({Vec2::Zero()}, 1, z);
      builder.use_in_cap(centre, 1);
      for (std::size_t i = 0; i < circle_count; ++i) {
        builder.add_cap_triangle(centre, static_cast<std::uint32_t>(circle_first + i),
                                 static_cast<std::uint32_t>(circle_first + (i + 1) % circle_count));
      }
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
