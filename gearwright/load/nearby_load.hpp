// Computes the loaded transmission error of a pair after its flanks have changed by microns,
// without a new search for the places of least gap.
//
//   T_i, arm_i   gap angle and arm of place i [T12.1]      e   amounts of influences
//   g_i(e) = (TE − T_i − Σ ∂T_i/∂e δe) arm_i        theory: docs/theory/14-scatter.md, [T14.25]
//
// The search for the places and the computation of their compliance take most of the time. If the
// flanks change, the gap is corrected to first order in e, but compliance and curvature keep their
// values for e = 0. The change of TE therefore has an error of a few percent.
//
// TE of a double-helical pair is the mean of both halves [T12.26].
#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <vector>

#include "gearwright/contact/sensitivity.hpp"
#include "gearwright/load/complementarity.hpp"
#include "gearwright/load/loaded_contact.hpp"
#include "gearwright/math/minimax.hpp"

namespace gearwright {

/// The loaded contact near a change of the influences, to first order in a further step. Places
/// without load stay without load.
class LoadTangents {
 public:
  /// Returns the peak to peak of the loaded TE after `step`, rad, under the torque for which it is
  /// greatest.
  Tangent span(const Eigen::VectorXd& step) const;
  /// Returns the square of the greatest pressure after `step`, MPa². The load of a place, and
  /// therefore the square of its pressure, is linear in the step.
  Tangent pressure_squared(const Eigen::VectorXd& step) const;

 private:
  friend class NearbyLoad;
  struct Position {
    double te;
    Eigen::VectorXd te_slope;
    Eigen::VectorXd square;  // MPa², for each place
    Eigen::MatrixXd square_slope;
  };
  std::vector<std::vector<Position>> at_;  // [torque][position]
};

class NearbyLoad {
 public:
  /// Computes the positions of the request for e = 0, as loaded_contact() does. The pair may be a
  /// half of a double-helical pair.
  ///
  /// Domain    LoadRegime::line; a gear whose modification is an influence must have a removal
  ///           field (contract)
  NearbyLoad(const ContactPair& pair, const Gear& gear_1, const Gear& gear_2,
             const PairCompliance& compliance, const LoadRequest& request,
             std::span<const Influence> influences);

  struct Span {
    std::optional<double> value;  ///< rad; none if a position has no solution
    std::vector<double> slope;    ///< rad per unit of each influence; empty unless requested
    double max_pressure = 0.0;    ///< MPa, over the positions and the torques
  };
  /// Returns the greatest peak to peak of the loaded TE over the torques of the request, after each
  /// influence has changed by its value in `change`.
  ///
  /// Domain    one change for each influence (contract)
  /// Accuracy  without a change, the accuracy of loaded_contact(); otherwise, a few percent of the
  ///           effect of the change
  /// Laws      (1) without a change, `value` and `max_pressure` equal the results of
  ///               loaded_contact()
  ///           (2) `slope` is the derivative of `value`
  Span span(std::span<const double> change, bool slopes) const {
    return span({this, 1}, change, slopes);
  }
  /// Returns the tangents of the results after `change`, or none if a position has no solution.
  ///
  /// Laws      (1) without a step, `span` and `pressure_squared` have the values of span()
  ///           (2) their slopes are the derivatives of these values
  std::optional<LoadTangents> tangents(std::span<const double> change) const;
  /// Returns the same values as span() of one half, for the mean TE of both halves of a
  /// double-helical pair.
  ///
  /// Domain    one half or two, with the same numbers of positions and torques (contract)
  static Span span(std::span<const NearbyLoad> halves, std::span<const double> change, bool slopes);

 private:
  struct Position {
    double te = 0.0;                     // rad, TE without load at e = 0
    ContactProblem problem;              // at e = 0; its moment is set for each torque
    Eigen::MatrixXd turn;                // ∂T_i/∂e, a row per place, a column per influence
    std::vector<Eigen::VectorXd> start;  // loads at e = 0, one vector for each torque
  };
  struct Loaded {
    double te;        // rad, TE under load
    double pressure;  // MPa
    Eigen::VectorXd slope;
  };
  // Returns the problem at one position under one torque.
  ContactProblem problem(std::size_t position, std::size_t torque,
                         std::span<const double> change) const;
  // Returns the result at one position under one torque, or none if the forces have no solution.
  std::optional<Loaded> loaded(std::size_t position, std::size_t torque,
                               std::span<const double> change, bool slopes) const;

  std::vector<double> moments_;  // N mm, torques on gear 2
  std::vector<Position> positions_;
  bool complete_ = true;  // false if no teeth touch at some position
};

}  // namespace gearwright
