// Computes the deflection of a stepped shaft on two bearings in one plane under the load of a gear.
//
//   z          mm along the axis, from the middle of the face        w    mm, deflection
//   q, m       uniform force and moment per length of the face       ψ    slope of the sections
//   E, G, ν    moduli, MPa, and Poisson's ratio
//   I, A       second moment and area of a section of diameter d
//   κ          shear coefficient of a solid circle, 6(1 + ν)/(7 + 6ν) (Cowper 1966)
//
// The shaft is statically determinate. Between the points at which section or load change,
// deflection and twist are polynomials, which are evaluated in closed form.
//                                                          theory: docs/theory/11-rating.md
#pragma once

#include <array>
#include <optional>
#include <vector>

namespace gearwright {

/// The side of the face on which the torque enters or leaves: −z (left) or +z (right).
enum class ShaftSide { left, right };

struct Shaft {
  std::array<double, 2> bearings{};  ///< z of the bearings, mm, ascending
  std::vector<double> diameters;     ///< d of each section, mm, in the order of ascending z
  std::vector<double> steps;         ///< z at which the diameter changes, mm, ascending
  double youngs_modulus = 206000.0;  ///< E   MPa
  double poisson_ratio = 0.3;        ///< ν
  bool shear = true;                 ///< true for a Timoshenko beam, false for an Euler beam
  std::optional<std::array<double, 2>> bearing_stiffness;  ///< N/mm, radial; absent if rigid
  ShaftSide torque_from = ShaftSide::left;
  /// True if `bearings` and `steps` are in ascending order, if the number of diameters exceeds the
  /// number of steps by one, and if all sizes are positive.
  bool possible() const;
};

/// The load of a gear, uniformly distributed over its face from `lo` to `hi`.
struct ShaftLoad {
  double force = 0.0;         ///< F  N, in the direction of w
  double moment = 0.0;        ///< M  N mm, > 0 if it increases the slope dw/dz
  double lo = 0.0, hi = 0.0;  ///< z of the ends of the face, mm
};

/// Returns the reaction forces of the bearings on the shaft, N, in the direction of w.
///
/// Domain    shaft.possible() (contract)
std::array<double, 2> bearing_reactions(const Shaft& shaft, const ShaftLoad& load);

struct ShaftDeflection {
  std::vector<double> w;      ///< mm
  std::vector<double> slope;  ///< ψ  rad; with shear, it differs from dw/dz
};
/// Returns the deflection and the slope of the shaft at each of the values `z`, mm.
///
/// Formula   [T11.49], [T11.50]
/// Domain    shaft.possible(), lo < hi (contract)
/// Laws      (1) w is linear in the load
///           (2) with rigid bearings and without a moment, multiplying all lengths by k divides w
///               by k
ShaftDeflection shaft_deflection(const Shaft& shaft, const ShaftLoad& load,
                                 const std::vector<double>& z);

/// Returns the twist per torque and length, 1/(G I_p)  rad/(N mm²), of a solid cylinder with the
/// diameter `body`.
///
/// Formula   [T11.51]
double shaft_twist_per_length(const Shaft& shaft, double body);

/// Returns the twist of a gear at each z of its face, rad, relative to the end of the face at which
/// the torque acts. The twist is positive if it has the sense of rotation in which the mesh force
/// turns the gear. The gear is treated as a solid cylinder with the diameter `body`, mm.
///
/// Formula   [T11.51]
/// Domain    shaft.possible(), lo < hi, every z within [lo, hi] (contract)
std::vector<double> shaft_twist(const Shaft& shaft, double torque, double body, double lo,
                                double hi, const std::vector<double>& z);

}  // namespace gearwright
