#include "gearwright/inspection/nominal_points.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace gearwright {

namespace {

double height_of(const EvaluationRanges& ranges, const PointGrid& grid, int row) {
  const double t = static_cast<double>(row) / (grid.helix - 1);
  return ranges.helix[0] + t * (ranges.helix[1] - ranges.helix[0]);
}

}  // namespace

NominalPoint nominal_point(const Gear& gear, const RemovalField& removal, FlankSide side,
                           double roll, double height) {
  const ReferenceGeometry<double>& g = gear.reference();
  const double r_b = g.base_diameter / 2;
  const double hand = side == FlankSide::left ? 1.0 : -1.0;
  const double sigma = gear.side();
  const double cos_b = std::cos(g.base_helix_angle), sin_b = std::sin(g.base_helix_angle);
  const double psi_b = g.base_tooth_thickness / g.base_diameter;
  const double phi = hand * (psi_b - sigma * roll) + gear.twist() * height;
  const Vec3 u(std::cos(phi), std::sin(phi), 0.0), e(-std::sin(phi), std::cos(phi), 0.0);
  const Vec3 k(0.0, 0.0, 1.0);
  // The point and the normal of the unmodified flank. [T10.26]
  const Vec3 plain = r_b * (u + hand * sigma * roll * e) + height * k;
  const Vec3 n = hand * (cos_b * e - sin_b * k);
  const double rho = r_b * std::sqrt(1 + roll * roll);
  NominalPoint p{plain, n, 2 * rho, height};
  if (removal.none()) return p;
  // The point is displaced by −c n, and the normal of the displaced surface follows from two
  // tangents. [T10.27]
  const Removal c = removal.at(std::log(rho), height);
  const double c_roll = c.c_u * roll / (1 + roll * roll);
  const Vec3 along_roll = r_b * roll * u - c_roll * n - c.c * sigma * cos_b * u;
  const Vec3 along_z =
      gear.twist() * k.cross(plain) + k - c.c_z * n + c.c * hand * cos_b * gear.twist() * u;
  const Vec3 normal = along_roll.cross(along_z).normalized();
  p.point = plain - c.c * n;
  p.normal = normal.dot(n) < 0.0 ? Vec3(-normal) : normal;
  return p;
}

std::vector<NominalPoint> nominal_points(const Gear& gear, const RemovalField& removal,
                                         FlankSide side, const EvaluationRanges& ranges,
                                         const PointGrid& grid) {
  GW_EXPECTS(grid.profile >= 2 && grid.helix >= 2);
  const double r_b = gear.base_radius();
  std::vector<NominalPoint> points;
  for (int j = 0; j < grid.helix; ++j) {
    const double z = height_of(ranges, grid, j);
    for (int i = 0; i < grid.profile; ++i) {
      const double s = static_cast<double>(i) / (grid.profile - 1);
      const double length = ranges.profile[0] + s * (ranges.profile[1] - ranges.profile[0]);
      points.push_back(nominal_point(gear, removal, side, length / r_b, z));
    }
  }
  return points;
}

namespace {

// A point of the fillet in the section z = 0, with its outward normal.
struct FilletPlace {
  Vec2 point, normal;
};

// Returns n places at equal distances along the root fillet. The length of the fillet is computed
// from the chords of a fine subdivision.
std::vector<FilletPlace> along_fillet(const Outline& outline, int n) {
  constexpr int kFine = 400;
  struct Station {
    const Arc* arc;
    double u, length;
  };
  std::vector<Station> stations;
  double length = 0.0;
  for (const Arc& arc : outline.arcs) {
    if (arc.name != ArcName::root_fillet) continue;
    Vec2 last = arc.begin_point;
    for (int i = 0; i <= kFine; ++i) {
      const double u = static_cast<double>(i) / kFine;
      const Vec2 here = arc.point(u);
      length += (here - last).norm();
      stations.push_back({&arc, u, length});
      last = here;
    }
  }
  std::vector<FilletPlace> places;
  if (length == 0.0) return places;
  // From root to tip on the side y > 0, the material of an external tooth lies to the right.
  const double out = outline.side();
  std::size_t at = 0;
  for (int i = 0; i < n; ++i) {
    const double wanted = length * i / (n - 1);
    while (at + 2 < stations.size() && stations[at + 1].length < wanted) ++at;
    const Station &a = stations[at], &b = stations[at + 1];
    const double step = b.length - a.length;
    const double t = step > 0.0 ? std::clamp((wanted - a.length) / step, 0.0, 1.0) : 1.0;
    const double u = i + 1 == n ? 1.0 : b.arc == a.arc ? a.u + t * (b.u - a.u) : b.u;
    const double tangent = b.arc->at(u).tangent_angle;
    places.push_back({b.arc->point(u), out * Vec2(-std::sin(tangent), std::cos(tangent))});
  }
  return places;
}

}  // namespace

std::vector<NominalPoint> fillet_points(const Gear& gear, FlankSide side,
                                        const EvaluationRanges& ranges, const PointGrid& grid) {
  GW_EXPECTS(grid.profile >= 2 && grid.helix >= 2);
  std::vector<NominalPoint> points;
  if (!gear.tooth) return points;
  const double hand = side == FlankSide::left ? 1.0 : -1.0, twist = gear.twist();
  const std::vector<FilletPlace> places = along_fillet(gear.tooth->outline, grid.profile);
  for (int j = 0; j < grid.helix; ++j) {
    const double z = height_of(ranges, grid, j);
    const Eigen::AngleAxisd turn(twist * z, Vec3::UnitZ());
    for (const FilletPlace& place : places) {
      const Vec3 p(place.point.x(), hand * place.point.y(), 0.0);
      const Vec3 e(place.normal.x(), hand * place.normal.y(), 0.0);
      const double around = e.dot(Vec3::UnitZ().cross(p));
      const Vec3 normal = (e - twist * around * Vec3::UnitZ()).normalized();
      points.push_back({turn * p + z * Vec3::UnitZ(), turn * normal, 2 * p.norm(), z});
    }
  }
  return points;
}

}  // namespace gearwright
