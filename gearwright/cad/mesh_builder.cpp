#include "gearwright/cad/mesh_builder.hpp"

#include <cmath>

#include "gearwright/base/contract.hpp"

namespace gearwright {

namespace {

// If the direction of the normal changes by more than this value, rad, there is a crease. At a
// joint of arcs with a common tangent, the change is only a rounding error.
constexpr double kCrease = 1e-3;

bool is_crease(const Column& column) { return (column.before - column.after).norm() > kCrease; }

// Decides between the two diagonals of the quad between two columns. Returns true if the rising
// diagonal is at least as near to the surface as the falling one. The rising diagonal leads from
// the bottom of `one` to the top of `two`. In the middle, the section deviates from its chord by
// chord·(n_2 − n_1)/8 along its normal. n_1 and n_2 are the normals at the two columns.
bool rising_diagonal(const Column& one, const Column& two, const Levels& levels) {
  const double turn = levels.band.twist * levels.band.width / levels.steps;
  const double bulge = (two.before - one.after).dot(two.point - one.point) / 8.0;
  const SinCos full = sincos_of(turn);
  const SinCos half = sincos_of(0.5 * turn);
  const Vec2 middle = turned(0.5 * (one.point + two.point), half);
  const Vec2 normal = turned((one.after + two.before).normalized(), half);
  const Vec2 rising = 0.5 * (one.point + turned(two.point, full)) - middle;
  const Vec2 falling = 0.5 * (two.point + turned(one.point, full)) - middle;
  return std::abs(rising.dot(normal) - bulge) <= std::abs(falling.dot(normal) - bulge);
}

// The diagonals are chosen once per part. All levels and all teeth use the same choice, because a
// screw motion does not change the distances from the surface.
std::vector<char> rising_diagonals(const std::vector<Column>& part, int copies,
                                   const Levels& levels) {
  Column beyond = part.front();
  const SinCos pitch = sincos_turn(1, copies);
  beyond.point = turned(beyond.point, pitch);
  beyond.before = turned(beyond.before, pitch);
  std::vector<char> rising(part.size());
  for (std::size_t i = 0; i < part.size(); ++i) {
    const Column& next = i + 1 < part.size() ? part[i + 1] : beyond;
    rising[i] = rising_diagonal(part[i], next, levels) ? 1 : 0;
  }
  return rising;
}

Ring screw_ring(const std::vector<Column>& part, const std::vector<char>& crease, const Band& band,
                double z) {
  const SinCos screw = sincos_of(band.angle(z));
  const auto screwed = [&](const Vec2& p, const Vec2& n) {
    return turned_about_axis(screw_normal(p, n, band.twist), screw);
  };
  Ring ring{z, {}};
  ring.points.reserve(part.size());
  for (std::size_t i = 0; i < part.size(); ++i) {
    const Column& column = part[i];
    const Vec2 smooth = (column.before + column.after).normalized();
    ring.points.push_back({turned(column.point, screw),
                           screwed(column.point, crease[i] != 0 ? column.before : smooth),
                           screwed(column.point, crease[i] != 0 ? column.after : smooth)});
  }
  return ring;
}

}  // namespace

WallEdges edges_of(const std::vector<Column>& part, int copies, const Levels& levels) {
  WallEdges edges;
  for (const Column& column : part) edges.crease.push_back(is_crease(column) ? 1 : 0);
  edges.rising = rising_diagonals(part, copies, levels);
  return edges;
}

MeshBuilder::Shades MeshBuilder::shades(const std::vector<char>& crease) {
  Shades result;
  for (const char sharp : crease) {
    result.before.push_back(result.count);
    if (sharp != 0) ++result.count;
    result.after.push_back(result.count++);
  }
  return result;
}

void MeshBuilder::add_shaded(std::uint32_t vertex, const Vec3& normal) {
  mesh_.shaded_vertices.push_back(vertex);
  mesh_.normals.push_back(normal);
}

// Adds a level of copy 0, and then the turned copies of this level.
void MeshBuilder::add_ring(const Ring& ring, const std::vector<char>& crease, int copies,
                           const WallEnds* below) {
  for (int k = 0; k < copies; ++k) {
    const SinCos tooth = sincos_turn(k, copies);
    for (std::size_t i = 0; i < ring.points.size(); ++i) {
      const RingPoint& placed = ring.points[i];
      const std::size_t place = static_cast<std::size_t>(k) * ring.points.size() + i;
      const std::uint32_t vertex =
          below ? below->top + static_cast<std::uint32_t>(place) : next_vertex();
      const Vec2 p = turned(placed.point, tooth);
      if (!below) mesh_.vertices.emplace_back(p.x(), p.y(), ring.z);
      add_shaded(vertex, turned_about_axis(placed.before, tooth));
      if (crease[i] != 0) add_shaded(vertex, turned_about_axis(placed.after, tooth));
    }
  }
}

WallEnds MeshBuilder::add_wall(const std::vector<Column>& part, int copies, const Levels& levels,
                               bool inward, const WallEnds* below) {
  GW_EXPECTS(!part.empty() && copies >= 1 && levels.steps >= 1);
  const WallEdges edges = edges_of(part, copies, levels);
  std::vector<Ring> rings;
  for (int level = 0; level <= levels.steps; ++level)
    rings.push_back(screw_ring(part, edges.crease, levels.band, levels.z(level)));
  return add_wall(rings, edges, copies, inward, below);
}

WallEnds MeshBuilder::add_wall(const std::vector<Ring>& rings, const WallEdges& edges, int copies,
                               bool inward, const WallEnds* below) {
  GW_EXPECTS(rings.size() >= 2 && copies >= 1);
  const std::size_t first = mesh_.vertices.size();
  const std::size_t first_shaded = mesh_.shaded_vertices.size();
  for (const Ring& ring : rings) {
    GW_EXPECTS(ring.points.size() == edges.crease.size());
    add_ring(ring, edges.crease, copies, &ring == &rings.front() ? below : nullptr);
  }
  const std::size_t ring = below ? 0 : edges.crease.size() * static_cast<std::size_t>(copies);
  return add_quads(below ? below->top : first, first + ring, first_shaded,
                   static_cast<int>(rings.size()) - 1, edges, copies, inward);
}

// Adds the quads between all rings. `bottom` is the first vertex of the lowest ring. `second` is
// the first vertex of the second ring, and the vertices of all higher rings follow.
WallEnds MeshBuilder::add_quads(std::size_t bottom, std::size_t second, std::size_t first_shaded,
                                int steps, const WallEdges& edges, int copies, bool inward) {
  const std::size_t columns = edges.crease.size();
  const std::size_t ring = columns * static_cast<std::size_t>(copies);
  const Shades shade_of = shades(edges.crease);
  const std::size_t ring_shaded = shade_of.count * static_cast<std::size_t>(copies);
  const auto index = [](std::size_t i) { return static_cast<std::uint32_t>(i); };
  const auto ring_at = [&](int level) {
    return level == 0 ? bottom : second + ring * static_cast<std::size_t>(level - 1);
  };
  for (int step = 0; step < steps; ++step) {
    const std::size_t low = ring_at(step), high = ring_at(step + 1);
    const std::size_t low_shaded = first_shaded + ring_shaded * static_cast<std::size_t>(step);
    for (std::size_t k = 0; k < static_cast<std::size_t>(copies); ++k) {
      for (std::size_t i = 0; i < columns; ++i) {
        const std::size_t next_i = (i + 1) % columns;
        const std::size_t next_k = (k + (i + 1) / columns) % static_cast<std::size_t>(copies);
        const std::size_t here = k * columns + i;
        const std::size_t next = next_k * columns + next_i;
        const std::size_t shade = low_shaded + k * shade_of.count + shade_of.after[i];
        const std::size_t shade_next =
            low_shaded + next_k * shade_of.count + shade_of.before[next_i];
        add_quad({index(low + here), index(low + next), index(high + next), index(high + here)},
                 {index(shade), index(shade_next), index(shade_next + ring_shaded),
                  index(shade + ring_shaded)},
                 edges.rising[i] != 0, inward);
      }
    }
  }
  return {index(bottom), index(ring_at(steps))};
}

void MeshBuilder::add_quad(const std::array<std::uint32_t, 4>& corners,
                           const std::array<std::uint32_t, 4>& shaded, bool rising, bool inward) {
  // Seen from outside, towards the axis, the corners run counter-clockwise from the lower left one.
  // If `inward` is true, their order is reversed.
  const std::array<std::size_t, 6> order = rising ? std::array<std::size_t, 6>{0, 1, 2, 0, 2, 3}
                                                  : std::array<std::size_t, 6>{0, 1, 3, 1, 2, 3};
  for (std::size_t t = 0; t < order.size(); t += 3) {
    const std::size_t a = order[t];
    const std::size_t b = order[t + (inward ? 2 : 1)];
    const std::size_t c = order[t + (inward ? 1 : 2)];
    mesh_.triangles.push_back({corners[a], corners[b], corners[c]});
    mesh_.shaded_triangles.push_back({shaded[a], shaded[b], shaded[c]});
  }
}

std::uint32_t MeshBuilder::add_points(const std::vector<Vec2>& part, int copies, double z) {
  const std::uint32_t first = next_vertex();
  for (int k = 0; k < copies; ++k) {
    const SinCos tooth = sincos_turn(k, copies);
    for (const Vec2& point : part) {
      const Vec2 p = turned(point, tooth);
      mesh_.vertices.emplace_back(p.x(), p.y(), z);
    }
  }
  return first;
}

void MeshBuilder::begin_cap(bool up) {
  up_ = up;
  ranges_.clear();
}

void MeshBuilder::use_in_cap(std::uint32_t first, std::size_t count) {
  ranges_.push_back({first, count, static_cast<std::uint32_t>(mesh_.shaded_vertices.size())});
  for (std::size_t i = 0; i < count; ++i) {
    add_shaded(static_cast<std::uint32_t>(first + i), Vec3(0.0, 0.0, up_ ? 1.0 : -1.0));
  }
}

std::uint32_t MeshBuilder::cap_shade(std::uint32_t vertex) const {
  for (const Range& range : ranges_) {
    if (vertex >= range.first && vertex - range.first < range.count) {
      return range.shaded + (vertex - range.first);
    }
  }
  contract_failed("precondition", "cap corner in a range", __FILE__, __LINE__);
}

void MeshBuilder::add_cap_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  if (!up_) std::swap(b, c);
  mesh_.triangles.push_back({a, b, c});
  mesh_.shaded_triangles.push_back({cap_shade(a), cap_shade(b), cap_shade(c)});
}

}  // namespace gearwright
