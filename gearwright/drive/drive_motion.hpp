// Computes the speeds of all bodies of a drive exactly, from a linear system with integer
// coefficients.
//
//   W      meshes × bodies: z_a on body a, z_b on body b, −(z_a + z_b) on the frame, W ω = 0
//          [T13.1]
//   f      degrees of freedom = number of bodies − rank of W with one more row for each fixed body
//          [T13.2]
//   i      = n_in/n_out, signed [T13.3]
//                                              theory: docs/theory/13-drives.md
//
// In the frame of a mesh, the working pitch circles roll on each other. This is true for any shifts
// and any centre distance, so W depends only on the numbers of teeth.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "gearwright/drive/drive_graph.hpp"
#include "gearwright/drive/rational.hpp"

namespace gearwright {

struct DriveMotion {
  int freedom = 0;  ///< f
  /// ω of each body per unit speed of each input, [body][input].
  std::vector<std::vector<Rational>> speeds;
  std::optional<Rational> ratio;   ///< i; none with several inputs
  std::optional<Rational> period;  ///< turns of the input after which the positions of all bodies
                                   ///< without a rack repeat; none with several inputs
  /// Meshes of closed loops that can move. If any single mesh of such a loop is removed, the speeds
  /// do not change. The torques of these meshes depend on the compliance of the loop.
  std::vector<std::size_t> redundant;

  /// Returns ω of a body for given speeds of the inputs, in the unit of these speeds.
  double speed(std::size_t body, const std::vector<double>& inputs) const;
};

/// Returns the row of a mesh in W.   Domain  a checked graph
std::vector<Rational> mesh_row(const DriveGraph& graph, const DriveMesh& mesh);

/// Returns an error with `drive.fixed`, `drive.input` or `drive.output` if a list contains a body
/// twice, if an input is fixed or is the output, or if the output is fixed.
std::optional<Error> ends_error(const DriveGraph& graph);

/// Computes the speeds of all bodies, the ratio and the degrees of freedom.
///
/// Formula   W ω = 0 with ω = 0 for the fixed bodies, solved once for each input, with the speed 1
///           of this input and the speed 0 of all other inputs; [T13.1]…[T13.5]
/// Domain    a checked graph with at least one input (contract)
/// Errors    `drive.fixed` if the drive is locked, with the fixed bodies or the meshes that lock
///           it, or if its speeds are undetermined; `drive.input`, `drive.output` if the body is
///           fixed or does not rotate, or if the speeds of the inputs contradict each other;
///           `drive.gear` if a ratio needs more than 127 bits
Result<DriveMotion> drive_motion(const DriveGraph& graph);

}  // namespace gearwright
