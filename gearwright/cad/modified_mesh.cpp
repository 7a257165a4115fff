#include "gearwright/cad/modified_mesh.hpp"

#include <algorithm>
#include <cmath>

#include "gearwright/base/angle.hpp"
#include "gearwright/base/contract.hpp"

namespace gearwright {

namespace {

// Permitted error of the removed material c within a facet, relative to the greatest c. A crowning
// then has at least three steps.
constexpr double kVisibleShare = 0.1;
// Steps of the finite differences that give the normals. The first is a step in u. The second is a
// step in z, relative to the face width.
constexpr double kStepU = 1e-4, kStepZ = 1e-4;
// Greatest number of halvings of a segment. The number of steps between two starts of reliefs is
// also doubled at most this often.
constexpr int kHalvings = 12;
constexpr int kProbes = 9;  // number of heights, and of points on an arc, at which c is examined

struct Segment {
  std::size_t arc;
  double u_0, u_1;
};

Segment segment(const SectionPoint& a, const SectionPoint& b) {
  return {b.arc, a.arc == b.arc ? a.u : 0.0, b.u};
}

class GridMaker {
 public:
  GridMaker(const ModifiedTeeth& teeth, double width, double tolerance)
      : teeth_(teeth), width_(width) {
    double greatest = 0.0;
    for (std::size_t arc = 0; arc < teeth.outline().arcs.size(); ++arc) {
      if (!flank(arc)) continue;
      for (int i = 0; i < kProbes; ++i)
        for (int j = 0; j < kProbes; ++j)
          for (const bool left : {false, true})
            greatest = std::max(greatest, std::abs(removed(left, arc, i / (kProbes - 1.0),
                                                           width * (j / (kProbes - 1.0) - 0.5))));
    }
    tolerance_ = std::min((1 - kCutShare) * tolerance, kVisibleShare * greatest);
    for (int j = 0; j < kProbes; ++j)
      for (const bool left : {false, true})
        rows_.push_back({left, teeth.side(left).plane(width * (j / (kProbes - 1.0) - 0.5))});
  }

  std::vector<SectionPoint> section(const std::vector<SectionPoint>& half) const {
    std::vector<SectionPoint> all{half.front()};
    for (std::size_t i = 1; i < half.size(); ++i) {
      const Segment s = segment(half[i - 1], half[i]);
      if (teeth_.side(false).role(s.arc) != ModifiedSide::Role::land) divide(s, kHalvings, all);
      all.push_back(half[i]);
    }
    return all;
  }

  std::vector<double> levels(const std::vector<SectionPoint>& half, double step) const {
    std::vector<double> starts = teeth_.kinks_z();
    starts.insert(starts.begin(), -width_ / 2);
    starts.push_back(width_ / 2);
    std::vector<double> all{starts.front()};
    for (std::size_t i = 0; i + 1 < starts.size(); ++i) {
      const double lo = starts[i], hi = starts[i + 1];
      int n = std::max(1, static_cast<int>(std::ceil((hi - lo) / step)));
      for (int k = 0; k < kHalvings && !fine(half, lo, hi, n); ++k) n *= 2;
      for (int k = 1; k < n; ++k) all.push_back(lo + (hi - lo) * k / n);
      all.push_back(hi);
    }
    return all;
  }

 private:
  bool flank(std::size_t arc) const {
    return teeth_.side(false).role(arc) == ModifiedSide::Role::flank;
  }

  double removed(bool left, std::size_t arc, double u, double z) const {
    const double rho = teeth_.outline().arcs[arc].point(u).norm();
    return teeth_.side(left).field().at(std::log(rho), z).c;
  }

  // Returns the greatest error in the middle of a segment, over all examined rows, if c is
  // interpolated linearly. On a fillet, the displacement of the point is interpolated instead of c.
  // The error due to the chords of the outline as cut is not included.
  double missed(const Segment& s) const {
    const double middle = 0.5 * (s.u_0 + s.u_1);
    double worst = 0.0;
    for (const ProbedRow& row : rows_) {
      if (flank(s.arc)) {
        const double mean = 0.5 * (removed(row.left, s.arc, s.u_0, row.row.z) +
                                   removed(row.left, s.arc, s.u_1, row.row.z));
        worst = std::max(worst, std::abs(removed(row.left, s.arc, middle, row.row.z) - mean));
      } else {
        const auto shift = [&](double u) {
          const ModifiedSide& side = teeth_.side(row.left);
          const Vec2 moved =
              turned(side.point(s.arc, u, row.row).head<2>(), -side.twist() * row.row.z);
          return Vec2(moved - teeth_.outline().arcs[s.arc].point(u));
        };
        worst = std::max(worst, (shift(middle) - 0.5 * (shift(s.u_0) + shift(s.u_1))).norm());
      }
    }
    return worst;
  }

  void divide(const Segment& s, int depth, std::vector<SectionPoint>& all) const {
    const double middle = 0.5 * (s.u_0 + s.u_1);
    if (depth == 0 || missed(s) <= 0.5 * tolerance_) return;
    divide({s.arc, s.u_0, middle}, depth - 1, all);
    const Arc& arc = teeth_.outline().arcs[s.arc];
    const Vec2 normal = section_normal(teeth_.outline().side(), arc.at(middle).tangent_angle);
    all.push_back({arc.point(middle), normal, normal, s.arc, middle});
    divide({s.arc, middle, s.u_1}, depth - 1, all);
  }

  // True if n steps between lo and hi represent c accurately enough on every segment.
  bool fine(const std::vector<SectionPoint>& half, double lo, double hi, int n) const {
    for (int k = 0; k < n; ++k) {
      const double z_0 = lo + (hi - lo) * k / n, z_1 = lo + (hi - lo) * (k + 1) / n;
      for (std::size_t i = 1; i < half.size(); ++i) {
        const Segment s = segment(half[i - 1], half[i]);
        if (!flank(s.arc)) continue;
        for (const bool left : {false, true}) {
          const auto c = [&](double u, double z) { return removed(left, s.arc, u, z); };
          const double centre = c(0.5 * (s.u_0 + s.u_1), 0.5 * (z_0 + z_1));
          const double rising = 0.5 * (c(s.u_0, z_0) + c(s.u_1, z_1));
          const double falling = 0.5 * (c(s.u_0, z_1) + c(s.u_1, z_0));
          if (std::abs(centre - rising) > tolerance_ || std::abs(centre - falling) > tolerance_)
            return false;
        }
      }
    }
    return true;
  }

  const ModifiedTeeth& teeth_;
  double width_, tolerance_;
  struct ProbedRow {
    bool left;
    ModifiedSide::Row row;
  };
  std::vector<ProbedRow> rows_;  // rows in which segments are examined
};

// The row at a level, and the rows just below and above it. Normals are computed from these rows.
struct Rows {
  ModifiedSide::Row here, below, above;
};

// Returns the outward normal at u on an arc, by finite differences towards the inside of the arc.
Vec3 normal_at(const ModifiedSide& side, std::size_t arc, double u, const Rows& rows,
               const Vec2& cut_normal) {
  const double h = u > 0.5 ? -kStepU : kStepU;
  const auto at = [&](double v) { return side.point(arc, v, rows.here); };
  const Vec3 along = (4 * at(u + h) - at(u + 2 * h) - 3 * at(u)) / (2 * h);
  const Vec3 up = side.point(arc, u, rows.above) - side.point(arc, u, rows.below);
  const Vec3 n = along.cross(up).normalized();
  const Vec2 cut = turned(cut_normal, side.twist() * rows.here.z);
  return n.head<2>().dot(cut) < 0.0 ? Vec3(-n) : n;
}

struct HalfPoint {
  Vec2 point;
  Vec3 root, tip;  // unit normals towards the root and towards the tip; they differ at a crease
};

// Returns the half section of a side at a level, in the frame of the side.
std::vector<HalfPoint> half_ring(const ModifiedSide& side, const ModifiedGrid& grid, double z) {
  const double h = kStepZ * (grid.levels.back() - grid.levels.front());
  const Rows rows{side.plane(z), side.plane(z - h), side.plane(z + h)};
  std::vector<HalfPoint> all;
  for (const SectionPoint& p : grid.half) {
    const bool ends = p.u == 1.0 && p.arc + 1 < side.outline().arcs.size();
    const Vec3 root = normal_at(side, p.arc, p.u, rows, p.root_normal);
    const Vec3 tip = ends ? normal_at(side, p.arc + 1, 0.0, rows, p.tip_normal) : root;
    all.push_back({side.point(p.arc, p.u, rows.here).head<2>(), root, tip});
  }
  return all;
}

Vec3 mirror(const Vec3& v) { return {v.x(), -v.y(), v.z()}; }

}  // namespace

ModifiedGrid modified_grid(const ModifiedTeeth& teeth, std::vector<SectionPoint> half, double width,
                           double step, double tolerance) {
  GW_EXPECTS(width > 0.0 && step > 0.0 && tolerance > 0.0);
  const GridMaker maker(teeth, width, tolerance);
  ModifiedGrid grid{maker.section(half), {}};
  grid.levels = maker.levels(grid.half, step);
  return grid;
}

std::vector<Vec2> modified_half(const ModifiedSide& side, const ModifiedGrid& grid, double z) {
  const ModifiedSide::Row row = side.plane(z);
  const SinCos back = sincos_of(-side.twist() * z);
  std::vector<Vec2> all;
  for (const SectionPoint& p : grid.half)
    all.push_back(turned(side.point(p.arc, p.u, row).head<2>(), back));
  return all;
}

std::vector<Ring> modified_rings(const ModifiedTeeth& teeth, const ModifiedGrid& grid, int copies) {
  const std::size_t n = grid.half.size() - 1;
  const SinCos back = sincos_turn(-1, copies);
  const SectionPoint &root = grid.half.front(), &tip = grid.half.back();
  std::vector<Ring> rings;
  for (const double z : grid.levels) {
    const std::vector<HalfPoint> right = half_ring(teeth.side(false), grid, z);
    const std::vector<HalfPoint> left = half_ring(teeth.side(true), grid, z);
    // The modifications do not move the points on the centre lines of space and tooth, because
    // these points lie on lands or at the ends of fades.
    const SinCos screw = sincos_of(teeth.side(true).twist() * z);
    Ring ring{z, {}};
    ring.points.push_back({turned(mirrored(root.point), screw),
                           turned_about_axis(left[0].tip, back), mirror(right[0].tip)});
    for (std::size_t i = 1; i < n; ++i)
      ring.points.push_back(
          {mirrored(right[i].point), mirror(right[i].root), mirror(right[i].tip)});
    ring.points.push_back({turned(tip.point, screw), mirror(right[n].root), left[n].root});
    for (std::size_t i = n - 1; i > 0; --i)
      ring.points.push_back({left[i].point, left[i].tip, left[i].root});
    rings.push_back(std::move(ring));
  }
  return rings;
}

void crease_at_reliefs(const ModifiedTeeth& teeth, const ModifiedGrid& grid, WallEdges& edges) {
  const ModifiedSide& side = teeth.side(true);
  const std::size_t n = grid.half.size() - 1;
  for (std::size_t i = 1; i < n; ++i) {
    const SectionPoint& p = grid.half[i];
    const bool start = p.u == 1.0 && p.arc >= side.first_flank() && p.arc < side.last_flank();
    if (start) edges.crease[i] = edges.crease[2 * n - i] = 1;
  }
}

}  // namespace gearwright
