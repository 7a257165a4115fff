#include "tests/oracle/screw_tangency.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace gearwright::oracle {

using Eigen::Matrix3d;
using Eigen::Vector3d;

double turn_per_length(const Screw& g) { return std::tan(g.base_helix) / g.base_radius; }

double roll_at(const Screw& g, double radius) {
  return std::sqrt(std::max(0.0, (radius - g.base_radius) * (radius + g.base_radius))) /
         g.base_radius;
}

double fallen_back(double u) { return u - std::atan(u); }

bool parallel(const ScrewPair& p) { return p.shaft_angle == 0.0; }

Matrix3d about_z(double angle) {
  return Eigen::AngleAxisd(angle, Vector3d::UnitZ()).toRotationMatrix();
}

Matrix3d tilt_2(const ScrewPair& p) {
  return Eigen::AngleAxisd(-p.shaft_angle, Vector3d::UnitX()).toRotationMatrix();
}

double azimuth_1(const ScrewPair& p, double rotation_1, int tooth) {
  return 2 * std::numbers::pi * tooth / p.first.teeth - rotation_1;
}

double azimuth_2(const ScrewPair& p, double rotation_2, int sigma, int tooth) {
  return std::numbers::pi + rotation_2 - std::numbers::pi * (2 * tooth + sigma) / p.second.teeth;
}

Vector3d flank_point(const Screw& gear, int sigma, double u, double z) {
  const double angle =
      sigma * (gear.base_thickness / (2 * gear.base_radius) - u) + turn_per_length(gear) * z;
  const Vector3d foot(std::cos(angle), std::sin(angle), 0);
  const Vector3d along = sigma * Vector3d::UnitZ().cross(foot);
  return gear.base_radius * (foot + u * along) + z * Vector3d::UnitZ();
}

Vector3d flank_normal(const Screw& gear, int sigma, double u, double z) {
  const double angle =
      sigma * (gear.base_thickness / (2 * gear.base_radius) - u) + turn_per_length(gear) * z;
  const Vector3d foot(std::cos(angle), std::sin(angle), 0);
  // Perpendicular to ∂r/∂u ∥ foot and to ∂r/∂z, whose part along the string is tan β_b.
  const Vector3d string = Vector3d::UnitZ().cross(foot);
  return sigma *
         (std::cos(gear.base_helix) * string - std::sin(gear.base_helix) * Vector3d::UnitZ());
}

// The Gauss-Newton method. Each step is the smallest least-squares solution of the linear
// equations.
Tangency tangency(const ScrewPair& p, double rotation_1, int sigma, int tooth, Tangency s) {
  const Matrix3d tilt = tilt_2(p), turn_1 = about_z(azimuth_1(p, rotation_1, tooth));
  const Vector3d axis = tilt.col(2), center(p.center_distance, 0, 0);
  const double length = p.first.base_radius;
  const double k_1 = turn_per_length(p.first), k_2 = turn_per_length(p.second);
  // ∂r/∂u = r_b u e, where e is the direction of the string's foot; ∂r/∂z = ẑ + k ẑ × r. The normal
  // only turns, by −σ with u and by k with z.
  const auto foot = [sigma](const Screw& g, double u, double z) {
    const double angle =
        sigma * (g.base_thickness / (2 * g.base_radius) - u) + turn_per_length(g) * z;
    return Vector3d(std::cos(angle), std::sin(angle), 0);
  };
  const double least = 4e-16 * (p.center_distance + std::abs(s.z_1));
  Tangency best = s;
  best.residual = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 40; ++i) {
    const Matrix3d turn_2 = tilt * about_z(azimuth_2(p, s.rotation_2, sigma, tooth));
    const Vector3d r_1 = turn_1 * flank_point(p.first, sigma, s.u_1, s.z_1);
    const Vector3d n_1 = turn_1 * flank_normal(p.first, sigma, s.u_1, s.z_1);
    const Vector3d r_2 = center + turn_2 * flank_point(p.second, sigma, s.u_2, s.z_2);
    const Vector3d n_2 = turn_2 * flank_normal(p.second, sigma, s.u_2, s.z_2);
    Eigen::Matrix<double, 6, 1> f;
    f << r_1 - r_2, length * n_1.cross(n_2);
    s.residual = f.norm(), s.point = r_1, s.normal = n_1;
    if (s.residual < best.residual) best = s;
    if (i > 3 && s.residual > best.residual) break;  // the limit due to rounding is reached
    if (s.residual < least) break;

    const Vector3d e_z = Vector3d::UnitZ(), turned_1 = e_z.cross(n_1), turned_2 = axis.cross(n_2);
    Eigen::Matrix<double, 6, 5> j;
    j.col(0) << turn_1 * foot(p.first, s.u_1, s.z_1) * (p.first.base_radius * s.u_1),
        length * (-sigma * turned_1).cross(n_2);
    j.col(1) << e_z + k_1 * e_z.cross(r_1), length * (k_1 * turned_1).cross(n_2);
    j.col(2) << turn_2 * foot(p.second, s.u_2, s.z_2) * (-p.second.base_radius * s.u_2),
        length * n_1.cross(-sigma * turned_2);
    j.col(3) << -axis - k_2 * axis.cross(r_2 - center), length * n_1.cross(k_2 * turned_2);
    j.col(4) << -axis.cross(r_2 - center), length * n_1.cross(turned_2);
    if (parallel(p)) j.col(1).setZero();
    // Columns are in mm, so that the smallest step and the rank are meaningful.
    const double r_2b = p.second.base_radius;
    const Eigen::Matrix<double, 5, 1> unit{1 / length, 1, 1 / r_2b, 1, 1 / r_2b};
    const Eigen::Matrix<double, 6, 5> scaled = j * unit.asDiagonal();
    const Eigen::Matrix<double, 5, 1> step =
        -unit.cwiseProduct(scaled.completeOrthogonalDecomposition().solve(f));
    s.u_1 += step[0], s.z_1 += step[1], s.u_2 += step[2], s.z_2 += step[3], s.rotation_2 += step[4];
  }
  return best;
}

}  // namespace gearwright::oracle
