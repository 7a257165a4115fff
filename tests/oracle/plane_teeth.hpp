// Teeth in plane strain by triangles with six nodes: an independent method for deflection and
// strain of a gear's section, which shares only the given outline with the engine.
//
//   Each tooth is covered by rungs from flank to flank, parabolas that bend down to the centre line;
//   squares between them and the body's rays are cut into two triangles. The rungs crowd at a load.
//   Some teeth to either side of tooth 0 are real, the rest of the rim is smooth. E = 1; lengths in
//   any unit, a yield is E·u/F′.
#pragma once

#include <Eigen/Core>
#include <array>
#include <complex>
#include <vector>

namespace gearwright::oracle {

struct PlaneGear {
  int teeth = 0;      ///< |z|
  bool ring = false;  ///< teeth point inwards
  double held = 0.0;  ///< radius of the bore, of a ring of its outside
  double poisson = 0.3;
  int real_teeth = 1;  ///< to either side of tooth 0
  /// Points from the middle of the space to the end of the side at the tip, y > 0, the tooth's
  /// centre line on the x axis; and how many of them are no flank yet.
  std::vector<std::complex<double>> outline;
  std::size_t root_points = 0;
};

/// The Hertz pressure of a unit line force on the side y > 0 of a tooth, `tooth` pitches
/// counter-clockwise of tooth 0, along the normal at its middle. A tooth carries at most one of
/// them.
struct PlaneLoad {
  int tooth = 0;
  double radius = 0.0, half_width = 0.0;
};

struct PlaneAnswer {
  /// (i, j): displacement along the normal in the middle of load i under load j.
  Eigen::MatrixXd yield;
  /// [load i]: along the root of its tooth on the loaded side, three rows xx, yy, xy per node, a
  /// column for each load.
  std::vector<Eigen::MatrixXd> root;
  int unknowns = 0;

  /// The greatest principal stress along the root of the tooth of load i under all loads.
  double root_stress(std::size_t i, const Eigen::VectorXd& forces) const;
};

/// `fineness`: elements per length. 1 gives an error of less than 0.3 % of a deflection.
PlaneAnswer plane_teeth(const PlaneGear& gear, const std::vector<PlaneLoad>& loads,
                        double fineness = 1.0);

}  // namespace gearwright::oracle
