#include "gearwright/inspection/nominal_points.hpp"

#include <Eigen/Geometry>
#include <cmath>

namespace gearwright {

NominalPoint nominal_point(const Gear& gear, const RemovalField& removal, FlankSide side,
                           double roll, double height) {
  const ReferenceGeometry<double>& g = gear.reference();
  const double r_b = g.base_diameter / 2;
  const double hand = side == FlankSide::left ? 1.0 : -1.0;
  const double sigma = gear.internal() ? -1.0 : 1.0;
  const double cos_b = std::cos(g.base_helix_angle), sin_b = std::sin(g.base_helix_angle);
  const double psi_b = g.base_tooth_thickness / g.base_diameter;
  const double phi = hand * (psi_b - sigma * roll) + gear.twist() * height;
  const Vec3 u(std::cos(phi), std::sin(phi), 0.0), e(-std::sin(phi), std::cos(phi), 0.0);
  const Vec3 k(0.0, 0.0, 1.0);
  // [T10.26]
  const Vec3 plain = r_b * (u + hand * sigma * roll * e) + height * k;
  const Vec3 n = hand * (cos_b * e - sin_b * k);
  const double rho = r_b * std::sqrt(1 + roll * roll);
  NominalPoint p{plain, n, 2 * rho, height};
  if (removal.none()) return p;
  // The same moved by −c n, and the normal of what results, from its two tangents. [T10.27]
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
    const double t = static_cast<double>(j) / (grid.helix - 1);
    const double z = ranges.helix[0] + t * (ranges.helix[1] - ranges.helix[0]);
    for (int i = 0; i < grid.profile; ++i) {
      const double s = static_cast<double>(i) / (grid.profile - 1);
      const double length = ranges.profile[0] + s * (ranges.profile[1] - ranges.profile[0]);
      points.push_back(nominal_point(gear, removal, side, length / r_b, z));
    }
  }
  return points;
}

}  // namespace gearwright
