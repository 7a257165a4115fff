// Deflection of a stepped shaft on two bearings under the load of one gear, in one plane.
//
//   z          mm along the axis, from the middle of the face        w    mm, deflection
//   q, m       force and moment per length over the face, uniform    ψ    slope of the sections
//   E, G, ν    moduli, MPa, and Poisson's ratio      I, A    of a section of diameter d
//   κ          shear coefficient of a solid circle, 6(1 + ν)/(7 + 6ν) (Cowper 1966)
//
// Sections and loads are constant between the points where one of them changes, so deflection and
// twist are polynomials there and are evaluated in closed form. Two bearings make the shaft
// statically determinate.                                  theory: docs/theory/11-rating.md
#pragma once

#include <array>
#include <optional>
#include <vector>

namespace gearwright {

/// The side from which the torque enters or leaves: towards −z or towards +z.
enum class ShaftSide { left, right };

struct Shaft {
  std::array<double, 2> bearings{};  ///< mm, growing
  std::vector<double> diameters;     ///< d   mm, from −z on
  std::vector<double> steps;         ///< mm, growing: places at which the diameter changes
  double youngs_modulus = 206000.0;  ///< E   MPa
  double poisson_ratio = 0.3;        ///< ν
  bool shear = true;                 ///< true: Timoshenko; false: Euler and Bernoulli
  std::optional<std::array<double, 2>> bearing_stiffness;  ///< N/mm, radial; none: rigid
  ShaftSide torque_from = ShaftSide::left;

  /// True if `bearings` and `steps` grow, there is one diameter more than steps, and every size is
  /// positive.
  bool possible() const;
};

/// The load of a gear whose face is [lo, hi], spread evenly over it.
struct ShaftLoad {
  double force = 0.0;         ///< F  N, in the direction of w
  double moment = 0.0;        ///< M  N mm, > 0 if it increases the slope dw/dz
  double lo = 0.0, hi = 0.0;  ///< mm
};

/// Reactions of the bearings on the shaft, N, in the direction of w.
///
/// Domain    shaft.possible() (contract)
std::array<double, 2> bearing_reactions(const Shaft& shaft, const ShaftLoad& load);

/// w at each z, mm.
///
/// Formula   [T11.49], [T11.50]
/// Domain    shaft.possible(), lo < hi (contract)
/// Laws      (1) w is linear in the load    (2) lengths times k, the same force: w/k
std::vector<double> shaft_deflection(const Shaft& shaft, const ShaftLoad& load,
                                     const std::vector<double>& z);

/// Twist of a gear at each z of its face, rad, relative to its end on the side of the torque; the
/// mesh turns the gear in this direction. The torque passes through a solid body of the given
/// diameter, mm.
///
/// Formula   [T11.51]
/// Domain    as above; every z within [lo, hi] (contract)
std::vector<double> shaft_twist(const Shaft& shaft, double torque, double body, double lo,
                                double hi, const std::vector<double>& z);

}  // namespace gearwright
