// The loaded transmission error of a pair whose flanks change by microns, without another search of
// the nearest places.
//
//   T_i, arm_i   gap angle and arm of place i [T12.1]      e   amounts of influences
//   g_i(e) = (TE − T_i − Σ ∂T_i/∂e δe) arm_i               theory: docs/theory/14-scatter.md, [T14.25]
//
// The search of the places and the compliance between them take nearly all of the time of a
// position. The gap at a place that moves is right to first order; compliance and curvature remain
// those of the places at e = 0, whose motion changes the result by a few percent of the effect.
#pragma once

#include <span>
#include <vector>

#include "gearwright/contact/sensitivity.hpp"
#include "gearwright/load/complementarity.hpp"
#include "gearwright/load/loaded_contact.hpp"

namespace gearwright {

class NearbyLoad {
 public:
  /// Computes the positions of the request as loaded_contact() does, for e = 0.
  ///
  /// Domain    LoadRegime::line; removed material on a gear whose modification is an influence
  ///           (contract)
  NearbyLoad(const ContactPair& pair, const Gear& gear_1, const Gear& gear_2,
             const PairCompliance& compliance, const LoadRequest& request,
             std::span<const Influence> influences);

  struct Span {
    double value;               ///< rad; NaN if a position has no solution
    std::vector<double> slope;  ///< rad per unit of each influence; empty unless requested
  };
  /// The greatest peak to peak over the torques of the request, with these changes of the influences.
  ///
  /// Domain    as many changes as influences (contract)
  /// Accuracy  without a change, that of loaded_contact(); otherwise a few percent of the change
  /// Laws      (1) without a change it is loaded_contact()'s number   (2) the slope is its derivative
  Span span(std::span<const double> change, bool slopes) const;

 private:
  struct Position {
    double te;                           // rad
    ContactProblem problem;              // without its moment
    Eigen::MatrixXd turn;                // ∂T_i/∂e, by place and influence
    std::vector<Eigen::VectorXd> start;  // by torque, the loads at e = 0
  };
  struct Loaded {
    double te;  // rad; NaN without a solution
    Eigen::VectorXd slope;
  };
  Loaded loaded(const Position& at, std::size_t torque, std::span<const double> change,
                bool slopes) const;

  std::vector<double> moments_;  // N mm, on gear 2
  std::vector<Position> positions_;
  bool complete_ = true;  // false if no teeth touch at some position
};

}  // namespace gearwright
