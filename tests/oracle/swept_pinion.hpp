// The swept pinion computes the result of cutting a blank by a pinion cutter, as the least distance
// over all positions of the cutter. It uses no envelope formula, no contact point and no code of
// the engine.
//
//   z_0, z_2   tooth numbers of cutter and gear, z_2 < 0 for a ring      Z = |z_2|, u = Z/z_0
//   a          generating centre distance, mm       s   +1 external, −1 ring
//   φ          roll: the cutter turns by φ, the gear by φ z_0/Z, against it (external) or with it
//   p          a point of the gear, transverse section; tooth 0 is centred on the x axis
//   ρ, θ       polar coordinates of p, turned and mirrored into the half pitch 0 … π/Z of the gear
//   f, ψ       p in the machine, and its polar angle there, with the gear centre at 0 and the
//              cutter centre at A = (a, 0)
//   q          p in the frame of the cutter, whose tooth 0 is centred on the x axis
//
// At φ = 0, tooth 0 of the cutter points along the line of centres into space 0 of the gear, which
// is between teeth 0 and 1. This space is at −x in an external gear and at +x in an internal one.
//
// Gear and cutter are symmetric about the middle of each tooth and space. It is therefore
// sufficient to consider θ in the half pitch and positions with ψ in −π … π.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "tests/oracle/toothed_outline.hpp"

namespace gearwright::oracle {

struct PinionSweepNumbers {
  int cutter_teeth = 0;          ///< z_0 ≥ 1
  int gear_teeth = 0;            ///< z_2 ≥ 1, or < −z_0 for a ring
  double center_distance = 0.0;  ///< a  mm, > 0 for a ring too
};

class SweptPinion {
 public:
  /// The least distance, and the roll at which it was found. The roll refers to p after it is
  /// turned into the half pitch.
  struct Nearest {
    double clearance = 0.0;  ///< mm
    double roll = 0.0;       ///< φ  rad
  };

  /// `half_tooth`: the cutter's outline in its transverse section, from the middle of its space 0
  /// (u = 0 of the first curve, polar angle π/z_0) to the middle of its tooth 0 (u = 1 of the
  /// last, y = 0), side y ≥ 0.
  ///
  /// Domain    the chain as in ToothedOutline
  /// Throws    std::invalid_argument with the reason if the data describe no cutter or no gear
  SweptPinion(const PinionSweepNumbers& numbers,
              const std::vector<ToothedOutline::Curve>& half_tooth);

  const PinionSweepNumbers& numbers() const { return numbers_; }
  const ToothedOutline& cutter() const { return cutter_; }

  /// The signed distance between p and the cutter at one roll angle, with p in the frame of the
  /// cutter. A plain scan needs only this function.
  Eigen::Vector2d seen_by_cutter(const Eigen::Vector2d& p, double roll) const;
  double gap_at(const Eigen::Vector2d& p, double roll) const;

  /// Minimum over all roll angles of the distance from p to the cutter. The blank has no effect.
  ///   > 0 material left, by so much     = 0 on the finished surface     < 0 cut away
  /// Results > 0 are the distance from the finished surface in the transverse plane. Results < 0
  /// are the depth of p in the cutter at the position in which it is deepest; this is at most the
  /// distance from the surface.
  ///
  /// Units     p in mm, gear frame; result mm
  /// Accuracy  1e-12 mm for ρ, a and cutter up to 100 mm; the source file explains the reasons
  /// Cost      0.1 to 0.3 ms near the surface, 1 ms deep inside cutter or material
  double clearance(const Eigen::Vector2d& p) const { return nearest(p).clearance; }
  Nearest nearest(const Eigen::Vector2d& p) const;

  /// The clearances of many points, in the given order.
  std::vector<double> clearances(const std::vector<Eigen::Vector2d>& points) const;

 private:
  struct Search;

  PinionSweepNumbers numbers_;
  ToothedOutline cutter_;
  double teeth_;  // Z
  double sign_;   // s
  double ratio_;  // u
};

}  // namespace gearwright::oracle
