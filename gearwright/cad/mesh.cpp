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

// The turn Δ between two levels satisfies ρΔ² = 2ε, where ε is the chord tolerance and ρ the
// largest radius. The section of the tip land deviates from its chord a by d = a²/(8ρ). If a = ρΔ,
// the three terms of (M1) in mesh.hpp, multiplied by 8, are 2ε, 4ε and 2ε. This choice of Δ gives
// the fewest triangles.
constexpr double kLevelShare = 2.0;

// In a thin wall, the chords of the two sides must not meet. The tolerance is therefore at most
// this fraction of the wall thickness.
constexpr double kWallShare = 0.25;

// A mesh that exceeds one of these limits is rejected. A file with kVerticesMax vertices has 200
// MB, which printers cannot read. With kHalfPointsMax points on half a tooth, the triangulation of
// a cap takes a few seconds, because its time grows with the square of the number of points.
constexpr double kVerticesMax = 2e6;
constexpr std::size_t kHalfPointsMax = 20000;

// Returns the columns of one pitch, counter-clockwise from the middle of a tooth space. The column
// in the middle of the next tooth space is not included.
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

// Returns the smallest distance from the axis to the polygon of the section.
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

// Returns the columns of a plain cylinder, with normals away from the axis.
std::vector<Column> neck_columns(double radius, double chord, double facet_turn) {
  std::vector<Column> columns = bore_columns({2.0 * radius}, chord, facet_turn);
  for (Column& column : columns) column.before = column.after = -column.after;
  return columns;
}

class GearMesh {
 public:
  /// `below` and `above` are the radii of the inner walls that end on the lower and on the upper
  /// end face. Each radius is the greatest radius of the bore with its keyway, the radius of a
  /// neck, or 0.
  ///
  /// Errors    those of tessellate()
  static Result<GearMesh> divide(const SolidGear& gear, const MeshOptions& options, double below,
                                 double above) {
    GearMesh made(gear, options);
    if (auto error = made.find_levels(below, above)) return *std::move(error);
    if (auto error = made.find_section()) return *std::move(error);
    if (auto error = made.find_caps(below, above)) return *std::move(error);
    return made;
  }

  double chord() const { return tolerance_.chord; }

  void add_walls(MeshBuilder& builder) {
    const std::vector<Column> columns = pitch_columns(half_, copies_);
    const std::vector<Ring> rings =
        body().modified ? modified_rings(*body().modified, *grid_, copies_) : std::vector<Ring>();
    const auto add = [&](const Levels& levels, bool mirrored, const WallEnds* below) {
      if (!body().modified) return builder.add_wall(columns, copies_, levels, ring_, below);
      WallEdges edges = edges_of(columns, copies_, levels);
      crease_at_reliefs(*body().modified, *grid_, edges);
      return builder.add_wall(in_band(rings, levels.band, mirrored), edges, copies_, ring_, below);
    };
    const bool two = bands_.size() == 2;
    lower_ = upper_ = add(lower_levels(), two, nullptr);
    if (two) upper_ = add(upper_levels(), false, body().grooved() ? nullptr : &lower_);
  }

  void close_ring(MeshBuilder& builder) const {
    const WallEnds rim = builder.add_wall(top_->circle_columns(false), copies_,
                                          {steps_, around(body().face_width)}, false);
    bottom_->add(builder, bottom_place(), rim.bottom);
    top_->add(builder, top_place(), rim.top);
  }

  /// Adds the lower or the upper end face of an external gear. `columns` are the columns of the
  /// inner wall that ends there. `hole` is the first vertex of the end ring of this wall.
  void add_bottom(MeshBuilder& builder, const std::vector<Column>& columns,
                  std::uint32_t hole) const {
    bottom_->add(builder, bottom_place(), columns, hole);
  }
  void add_top(MeshBuilder& builder, const std::vector<Column>& columns, std::uint32_t hole) const {
    top_->add(builder, top_place(), columns, hole);
  }

  /// Adds the groove of a double-helical gear and the two faces next to it.
  std::optional<Error> add_groove(MeshBuilder& builder) const {
    const auto& [gap, radius, stagger] = *body().two_helices;
    const auto cap = cap_at(radius, -bands_.front().width / 2);
    if (!cap)
      return not_a_body(body().outline.teeth, "the flanks of a tooth space cross each other");
    const double low = gear_.height - gap / 2.0, high = gear_.height + gap / 2.0;
    const CapPlace under{true, low, bands_.front().angle(low), lower_.top};
    const CapPlace over{false, high, bands_.back().angle(high), upper_.bottom};
    if (ring_) {
      const WallEnds groove =
          builder.add_wall(cap->circle_columns(true), copies_, {steps_, around(gap)}, true);
      cap->add(builder, under, groove.bottom);
      cap->add(builder, over, groove.top);
    } else {
      const std::vector<Column> columns = neck_columns(radius, chord(), facet_turn_);
      const WallEnds groove =
          builder.add_wall(columns, 1, {1, {0.0, gap, gear_.height, 0.0}}, false);
      cap->add(builder, under, columns, groove.bottom);
      cap->add(builder, over, columns, groove.top);
    }
    return std::nullopt;
  }

 private:
  GearMesh(const SolidGear& gear, const MeshOptions& options)
      : gear_(gear),
        options_(options),
        facet_turn_(options.facet_turn_max.rad()),
        copies_(std::abs(gear.body->outline.teeth)),
        ring_(gear.body->ring()),
        bands_(gear.bands()) {}

  const ToothedBody& body() const { return *gear_.body; }
  Levels lower_levels() const { return {steps_, bands_.front()}; }
  Levels upper_levels() const { return {steps_, bands_.back()}; }
  CapPlace bottom_place() const {
    const double z = lower_levels().z(0);
    return {false, z, bands_.front().angle(z), lower_.bottom};
  }
  CapPlace top_place() const {
    const double z = upper_levels().z(steps_);
    return {true, z, bands_.back().angle(z), upper_.top};
  }

  // Returns the rings of the modified teeth, or of their mirror image, in a band of the solid.
  static std::vector<Ring> in_band(std::vector<Ring> rings, const Band& band, bool mirrored) {
    if (mirrored) std::reverse(rings.begin(), rings.end());
    const double sign = mirrored ? -1.0 : 1.0;
    const SinCos turn = sincos_of(band.angle(band.middle));
    const auto normal = [&](const Vec3& n) {
      return turned_about_axis(Vec3(n.x(), n.y(), sign * n.z()), turn);
    };
    for (Ring& ring : rings) {
      ring.z = band.middle + sign * ring.z;
      for (RingPoint& p : ring.points)
        p = {turned(p.point, turn), normal(p.before), normal(p.after)};
    }
    return rings;
  }

  Error too_fine() const {
    return {"chord_tolerance_mm", fmt::format("{}", options_.chord_tolerance_mm),
            fmt::format("the mesh would have more than {:.0e} vertices, or more than {} on half a "
                        "tooth; increase the tolerance",
                        kVerticesMax, kHalfPointsMax)};
  }

  std::optional<Error> find_levels(double below, double above) {
    GW_EXPECTS(body().face_width > 0.0 && body().outline.teeth != 0);
    const int teeth = body().outline.teeth;
    if (body().outline.arcs.empty())
      return not_a_body(teeth, "the teeth are severed or the root lies beyond the axis");
    const Vec2 root = body().outline.arcs.front().begin_point;
    const auto [ray_s, ray_c] = sincos_turn(1, 2LL * copies_);
    if (!(root.dot(Vec2(ray_c, ray_s)) > 0.0))
      return not_a_body(teeth, "the root lies beyond the axis");
    if (auto error = hole_error(body().bore, body().hole_limits(root.norm()))) return error;
    const double r = root.norm();
    double wall = std::min(std::abs(r - below), std::abs(r - above));
    // A neck begins at an end face, so only the bore or the rim can lie beside the groove.
    if (body().grooved()) {
      const double limit = body().limit_within(r);
      const double hole = ring_         ? body().bore->diameter / 2.0
                          : body().bore ? bore_reach(*body().bore)
                                        : 0.0;
      wall = std::min({wall, std::abs(r - limit), std::abs(limit - hole)});
    }
    given_ = std::min(options_.chord_tolerance_mm, kWallShare * wall);
    const double chord = body().modified ? kCutShare * given_ : given_;
    const double radius_max =
        ring_ ? body().bore->diameter / 2.0 : body().outline.arcs.back().end_point.norm();
    const double turn_max = std::min(std::sqrt(kLevelShare * chord / radius_max), facet_turn_);
    const double turn = std::abs(body().twist) * bands_.front().width;
    const double steps = std::max(1.0, std::ceil(turn / turn_max));
    if (steps > kVerticesMax) return too_fine();
    steps_ = static_cast<int>(steps);
    tolerance_ = {chord, facet_turn_, turn / steps, radius_max};
    return std::nullopt;
  }

  std::optional<Error> find_section() {
    const ModifiedTeeth* modified = body().modified.get();
    half_ = section_points(modified ? modified->outline() : body().outline, tolerance_,
                           kHalfPointsMax + 1);
    if (half_.size() > kHalfPointsMax + 1) return too_fine();
    if (modified) {
      const double width = bands_.front().width;
      grid_ = modified_grid(*modified, std::move(half_), width, width / steps_, given_);
      half_ = grid_->half;
    }
    const std::size_t n = half_.size() - 1;
    const double rings = (grid_ ? static_cast<double>(grid_->levels.size()) : steps_ + 1.0) *
                         static_cast<double>(bands_.size());
    if (n > kHalfPointsMax) return too_fine();
    if (2.0 * static_cast<double>(n) * copies_ * rings > kVerticesMax) return too_fine();
    for (std::size_t i = 1; i < n; ++i)
      if (!(half_[i].point.y() > 0.0))
        return not_a_body(body().outline.teeth, "the flanks of a tooth cross each other");
    return std::nullopt;
  }

  // Returns the cap at the height z of the teeth. z has an effect only if the flanks are modified.
  // `radius` is the radius of the hole or, for an internal gear, the radius of the rim or groove.
  std::optional<Cap> cap_at(double radius, double z) const {
    const int teeth = body().outline.teeth;
    const Circle circle = ring_ ? rim_circle(radius, copies_, tolerance_)
                                : hub_circle(radius, polygon_reach_min(half_), copies_);
    const ModifiedTeeth* modified = body().modified.get();
    if (!modified) return Cap::divide(points_of(half_), points_of(half_), circle, teeth);
    return Cap::divide(modified_half(modified->side(false), *grid_, z),
                       modified_half(modified->side(true), *grid_, z), circle, teeth);
  }

  std::optional<Error> find_caps(double below, double above) {
    const double end = bands_.front().width / 2;
    top_ = cap_at(above, end);
    // The half at z < 0 is the mirror image of the other half. Its lower end is therefore the upper
    // end of the modified teeth.
    bottom_ =
        body().modified || below != above ? cap_at(below, body().two_helices ? end : -end) : top_;
    if (!top_ || !bottom_)
      return not_a_body(body().outline.teeth, "the flanks of a tooth space cross each other");
    return std::nullopt;
  }

  // Returns the band of a circular wall of an internal gear, which is the rim or the groove. At
  // both ends of this wall, the columns must be turned by the same angle as the teeth. The wall
  // therefore has the screw motion of the teeth. The halves of a double-helical gear have different
  // screw motions. In this case, the wall turns evenly from the angle at one end to the angle at
  // the other end.
  Band around(double width) const {
    if (!body().two_helices) return bands_.front();
    const double stagger = body().two_helices->stagger;
    return {-stagger / width, width, 0.0, body().twist * width / 2.0 + stagger / 2.0};
  }

  SolidGear gear_;
  MeshOptions options_;
  double facet_turn_;
  int copies_;
  bool ring_;
  std::vector<Band> bands_;
  int steps_ = 1;
  double given_ = 0.0;  // chord tolerance of the whole mesh, mm, including the modifications
  SectionTolerance tolerance_{};
  std::vector<SectionPoint> half_;
  std::optional<ModifiedGrid> grid_;
  std::optional<Cap> bottom_, top_;
  WallEnds lower_{}, upper_{};
};

}  // namespace

Result<TriangleMesh> tessellate(const ToothedBody& body, const MeshOptions& options) {
  GW_EXPECTS(options.chord_tolerance_mm > 0.0);
  const double facet_turn = options.facet_turn_max.rad();
  GW_EXPECTS(facet_turn > 0.0 && facet_turn <= kPi / 4.0);
  if (body.rack) return tessellate_rack(body, options);
  const std::vector<SolidGear> gears = body.gears();
  const double reach = body.bore ? bore_reach(*body.bore) : 0.0;
  std::vector<GearMesh> parts;
  double chord = options.chord_tolerance_mm;
  for (std::size_t i = 0; i < gears.size(); ++i) {
    const double below = i == 0 ? reach : gears[i].body->neck;
    const double above = i + 1 == gears.size() ? reach : gears[i + 1].body->neck;
    auto part = GearMesh::divide(gears[i], options, below, above);
    if (!part) return part.error();
    parts.push_back(std::move(part).take());
    chord = std::min(chord, parts.back().chord());
  }
  MeshBuilder builder;
  for (GearMesh& part : parts) part.add_walls(builder);
  if (body.ring()) {
    parts.front().close_ring(builder);
  } else {
    WallEnds bore{};
    std::vector<Column> columns;
    if (body.bore) {
      const double low = gears.front().bottom(), high = gears.back().top();
      columns = bore_columns(*body.bore, chord, facet_turn);
      bore = builder.add_wall(columns, 1, {1, {0.0, high - low, (low + high) / 2.0, 0.0}}, true);
    }
    parts.front().add_bottom(builder, columns, bore.bottom);
    parts.back().add_top(builder, columns, bore.top);
  }
  for (std::size_t i = 0; i < gears.size(); ++i) {
    if (gears[i].body->grooved())
      if (auto error = parts[i].add_groove(builder)) return *std::move(error);
    if (i == 0) continue;
    const double low = gears[i - 1].top(), high = gears[i].bottom();
    const std::vector<Column> columns = neck_columns(gears[i].body->neck, chord, facet_turn);
    const WallEnds neck =
        builder.add_wall(columns, 1, {1, {0.0, high - low, (low + high) / 2.0, 0.0}}, false);
    parts[i - 1].add_top(builder, columns, neck.bottom);
    parts[i].add_bottom(builder, columns, neck.top);
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
