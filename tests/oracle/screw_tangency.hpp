// Finds the points at which two flanks of turned gears are tangent. This is the second method of
// touching_screws.hpp, where the notation is explained. It uses neither the ends of the flanks nor
// the order of contacts.
#pragma once

#include <Eigen/Core>

#include "tests/oracle/touching_screws.hpp"

namespace gearwright::oracle {

/// k  rad/mm, counter-clockwise for growing z.
double turn_per_length(const Screw& gear);

/// Angle of the string at a radius; 0 below the base circle.
double roll_at(const Screw& gear, double radius);

/// Polar angle from the start of the involute to its point u.
double fallen_back(double u);

bool parallel(const ScrewPair& pair);

/// About z, counter-clockwise.
Eigen::Matrix3d about_z(double angle);

/// Axes of the frame of gear 2 in the housing before it turns. z has the direction (0, sin Σ, cos
/// Σ).
Eigen::Matrix3d tilt_2(const ScrewPair& pair);

/// Azimuth of tooth n of gear 1 in the housing, in the section z = 0 of the gear.
double azimuth_1(const ScrewPair& pair, double rotation_1, int tooth);

/// Azimuth about axis 2, from its own tilted x axis, of the tooth whose flank σ bounds space n.
double azimuth_2(const ScrewPair& pair, double rotation_2, int sigma, int tooth);

/// A point of either flank with the coordinates (u, z) in its gear. `point` and `normal` are those
/// of gear 1 in the housing.
struct Tangency {
  double u_1 = 0, z_1 = 0, u_2 = 0, z_2 = 0, rotation_2 = 0, residual = 0;
  Eigen::Vector3d point = Eigen::Vector3d::Zero(), normal = Eigen::Vector3d::Zero();
};

/// Solves for a common point and parallel normals, r_1 − r_2 = 0 and r_b1 n_1 × n_2 = 0, starting
/// at `start`. These are six equations of rank five for u_1, z_1, u_2, z_2, φ_2. On parallel axes,
/// flanks touch along a line, so z_1 is held constant. The result is the best of 40 steps, and
/// `residual` is its error.
Tangency tangency(const ScrewPair& pair, double rotation_1, int sigma, int tooth, Tangency start);

}  // namespace gearwright::oracle
