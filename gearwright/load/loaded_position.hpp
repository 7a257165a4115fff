// Computes the loads of a pair at one rotation. The three steps find the possible contact
// positions, the compliance between these positions, and the loads under a torque.
//
// Internal to load/.        theory: docs/theory/12-loaded-contact.md, [T12.1] to [T12.15]
#pragma once

#include <array>
#include <vector>

#include "gearwright/contact/transmission.hpp"
#include "gearwright/load/complementarity.hpp"
#include "gearwright/load/gap_places.hpp"
#include "gearwright/load/loaded_contact.hpp"
#include "gearwright/load/root_forces.hpp"
#include "gearwright/load/shaft_yield.hpp"

namespace gearwright::detail {

inline constexpr double kFarGap = 0.03;  // modules: teeth with a wider gap do not touch under load
inline constexpr double kFlattest = 1e-6;  // 1/mm: smaller curvatures are replaced by this value

// (1 − ν²)/E  mm²/N
inline double plane_softness(const ElasticBody& b) {
  return (1 - b.poisson_ratio * b.poisson_ratio) / b.youngs_modulus;
}

// A possible contact position, which is a row of the contact problem.
struct Row {
  int pair;  // index in Position::pairs
  int slice;
};

struct Position {
  std::vector<PairPlaces> pairs;  // the pairs that may touch, from the start to the end of contact
  std::vector<Row> rows;
  ContactProblem problem;
  Eigen::MatrixXd shafts;  // S Δ of [T12.35], mm per N/mm, between the rows; empty without shafts
  double te = 0.0;         // TE at which the teeth first touch, including the additional deflection
  std::array<std::vector<LinePlaces>, 2> lines;  // [gear][pair]
};
// Stresses of each gear at the root points and slices, in frame N.
using RootStress = std::array<RootSwing, 2>;

class PositionSolver {
 public:
  PositionSolver(const ContactPair& pair, const Gear& one, const Gear& two, const PairCompliance& c,
                 const LoadRequest& request);

  /// Computes gaps and compliance at a rotation in the frame N. Slices::all includes all slices of
  /// the tooth pairs that may touch. It is necessary if the flanks change afterwards, because a
  /// change can close any gap.
  enum class Slices { that_may_touch, all };
  Position prepare(double rotation, Slices slices = Slices::that_may_touch);
  /// Returns ∂te/∂e at the place of a slice, rad per unit of the influence.
  double slope(const PairPlaces& pair, int slice, const Influence& influence) {
    return search_.slope(pair, static_cast<std::size_t>(slice), influence);
  }
  /// Solves the contact problem and adds the root stresses to `swing`. If the slices are too fine,
  /// sets `too_fine`. The transmission error of the result contains the whole displacement of the
  /// axes by the shafts.
  LoadedPosition solve(Position& at, double torque, Angle rotation1, bool& too_fine,
                       RootStress& swing) const;
  /// Returns the greatest share of a single tooth pair, 0 if no teeth touch, or NaN if the forces
  /// do not converge.
  double greatest_share(Position& at, double torque) const;

 private:
  // Returns the approach due to the additional deflection at the height z in the frame N, mm.
  double deflection(double z) const {
    const FaceSlices& s = compliance_.slices[0];
    const double x = pair_.turned() * (z - s.middle()) / (s.hi - s.lo);
    return request_.deflection_offset + request_.deflection_slope * x +
           request_.deflection_bow * (1 - 4 * x * x);
  }
  Eigen::MatrixXd yields(const Position& at) const;
  void root_stress(const Position& at, const std::vector<Eigen::VectorXd>& load,
                   LoadedPosition& out, RootStress& swing) const;

  const ContactPair& pair_;
  const PairCompliance& compliance_;
  const LoadRequest& request_;
  ShaftYield shafts_;
  GapSearch search_;
  Transmission transmission_;
  std::array<double, 2> module_;  // mm
  double base_radius_, sin_b_, ratio_;
};

}  // namespace gearwright::detail
