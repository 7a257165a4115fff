#include "gearwright/cad/mesh_caps.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

#include "gearwright/base/numbers.hpp"
#include "gearwright/cad/flat_cap.hpp"

namespace gearwright {

namespace {

// Returns the 2q columns of the circle over one pitch. The first column lies on the ray −π/|z|.
std::vector<Column> columns_of(const Circle& circle, int copies) {
  std::vector<Column> columns;
  for (int i = -circle.q; i < circle.q; ++i) {
    const auto [s, c] = sincos_turn(i, 2LL * circle.q * copies);
    const Vec2 radial(c, s);
    columns.push_back({circle.radius * radial, radial, radial});
  }
  return columns;
}

// Returns triangles of one half pitch of a cap, with local indices of their corners. The indices 0
// … n are the points of the half section from root to tip. The indices n + 1 … n + 1 + q are the
// points of the circle from the centre line of the tooth to the middle of the space.
std::optional<std::vector<Triangle>> half_pitch_cap(std::vector<Vec2> corners,
                                                    const std::vector<Column>& circle, bool ring) {
  for (std::size_t j = circle.size() / 2 + 1; j-- > 0;) {
    corners.push_back(mirrored(circle[j].point));
  }
  // The corners run clockwise around the material of an external tooth. For an internal gear, they
  // run counter-clockwise.
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

}  // namespace

Circle hub_circle(double hole_reach, double root_reach, int copies) {
  const double radius = 0.5 * (hole_reach + root_reach);
  const double step = std::min(std::acos(hole_reach / radius), kPi / 4.0);
  return {radius, std::max(1, static_cast<int>(std::ceil(kPi / (copies * step))))};
}

Circle rim_circle(double radius, int copies, const SectionTolerance& tolerance) {
  const double turn = tolerance.level_turn;
  const double slack = 8.0 * tolerance.chord - radius * turn * turn;
  const double a = slack / (turn + std::sqrt(turn * turn + slack / radius));
  const double step = std::min(a / radius, tolerance.facet_turn);
  return {radius, std::max(1, static_cast<int>(std::ceil(kPi / (copies * step))))};
}

std::optional<Cap> Cap::divide(const std::vector<Vec2>& lower, const std::vector<Vec2>& upper,
                               const Circle& circle, int teeth) {
  Cap cap;
  cap.copies_ = std::abs(teeth);
  cap.n_ = lower.size() - 1;
  cap.circle_ = circle;
  cap.pitch_ = columns_of(circle, cap.copies_);
  const bool ring = teeth < 0;
  auto of_lower = half_pitch_cap(lower, cap.pitch_, ring);
  auto of_upper = lower == upper ? of_lower : half_pitch_cap(upper, cap.pitch_, ring);
  if (!of_lower || !of_upper) return std::nullopt;
  cap.half_ = {*std::move(of_lower), *std::move(of_upper)};
  return cap;
}

std::vector<Column> Cap::circle_columns(bool inward) const {
  std::vector<Column> columns = pitch_;
  if (inward)
    for (Column& column : columns) column.before = column.after = -column.after;
  return columns;
}

void Cap::add_teeth(MeshBuilder& builder, const CapPlace& place, std::uint32_t circle) const {
  const std::size_t z = static_cast<std::size_t>(copies_), n = n_;
  const std::size_t q = static_cast<std::size_t>(circle_.q);
  builder.use_in_cap(place.outline, 2 * n * z);
  builder.use_in_cap(circle, 2 * q * z);
  for (std::size_t k = 0; k < z; ++k) {
    const auto left = [&](std::uint32_t corner) {
      const std::size_t i = corner <= n ? (k * 2 * n + 2 * n - corner) % (2 * n * z)
                                        : (k * 2 * q + q + (corner - n - 1)) % (2 * q * z);
      return static_cast<std::uint32_t>((corner <= n ? place.outline : circle) + i);
    };
    const auto right = [&](std::uint32_t corner) {
      const std::size_t i = corner <= n ? k * 2 * n + corner : k * 2 * q + q - (corner - n - 1);
      return static_cast<std::uint32_t>((corner <= n ? place.outline : circle) + i);
    };
    const auto& [lower, upper] = half_;
    for (std::size_t i = 0; i < upper.size(); ++i) {
      const Triangle &t = upper[i], &u = lower[i];
      builder.add_cap_triangle(left(t[0]), left(t[1]), left(t[2]));
      builder.add_cap_triangle(right(u[0]), right(u[2]), right(u[1]));
    }
  }
}

void Cap::add(MeshBuilder& builder, const CapPlace& place, std::uint32_t circle) const {
  builder.begin_cap(place.up);
  add_teeth(builder, place, circle);
}

void Cap::add(MeshBuilder& builder, const CapPlace& place, const std::vector<Column>& columns,
              std::uint32_t hole) const {
  const SinCos screw = sincos_of(place.angle);
  std::vector<Vec2> points;
  for (const Column& column : pitch_) points.push_back(turned(column.point, screw));
  builder.begin_cap(place.up);
  const std::uint32_t circle = builder.add_points(points, copies_, place.z);
  const std::size_t count = pitch_.size() * static_cast<std::size_t>(copies_);
  add_teeth(builder, place, circle);
  if (columns.empty()) {
    const std::uint32_t centre = builder.add_points({Vec2::Zero()}, 1, place.z);
    builder.use_in_cap(centre, 1);
    for (std::size_t i = 0; i < count; ++i) {
      builder.add_cap_triangle(centre, static_cast<std::uint32_t>(circle + i),
                               static_cast<std::uint32_t>(circle + (i + 1) % count));
    }
    return;
  }
  std::vector<Vec2> inner, outer;
  for (const Column& column : columns) inner.push_back(column.point);
  for (std::size_t i = 0; i < count; ++i)
    outer.emplace_back(builder.mesh().vertices[circle + i].head<2>());
  builder.use_in_cap(hole, inner.size());
  const auto vertex = [&](std::uint32_t corner) {
    const auto inside = static_cast<std::uint32_t>(inner.size());
    return corner < inside ? hole + corner : circle + (corner - inside);
  };
  for (const Triangle& t : zip_ring(inner, outer))
    builder.add_cap_triangle(vertex(t[0]), vertex(t[1]), vertex(t[2]));
}

}  // namespace gearwright
