#include "gearwright/load/nearby_load.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "gearwright/load/loaded_position.hpp"

namespace gearwright {

NearbyLoad::NearbyLoad(const ContactPair& pair, const Gear& gear_1, const Gear& gear_2,
                       const PairCompliance& compliance, const LoadRequest& request,
                       std::span<const Influence> influences) {
  GW_EXPECTS(request.regime == LoadRegime::line);
  const double ratio = std::abs(double(gear_2.spec.teeth) / gear_1.spec.teeth);
  for (const double torque : request.torques) moments_.push_back(torque * ratio);
  detail::PositionSolver solver(pair, gear_1, gear_2, compliance, request);
  for (const Angle rotation : rotations_of(pair, request)) {
    detail::Position found =
        solver.prepare(pair.to_world(rotation.rad()), detail::PositionSolver::Slices::all);
    if (found.rows.empty()) {
      complete_ = false;
      return;
    }
    Position at{found.te, std::move(found.problem), {}, {}};
    at.turn.resize(static_cast<Eigen::Index>(found.rows.size()),
                   static_cast<Eigen::Index>(influences.size()));
    for (Eigen::Index row = 0; row < at.turn.rows(); ++row) {
      const detail::Row& place = found.rows[static_cast<std::size_t>(row)];
      for (Eigen::Index k = 0; k < at.turn.cols(); ++k)
        at.turn(row, k) = solver.slope(found.pairs[static_cast<std::size_t>(place.pair)],
                                       place.slice, influences[static_cast<std::size_t>(k)]);
    }
    // The iteration starts without load at places with a wide gap, as in loaded_contact().
    // These places carry no load in the solution either. If all places were loaded at the
    // start, the matrix of a helical pair could be indefinite.
    const Eigen::ArrayXd arms =
        (at.problem.gap.array() <= detail::kFarGap * gear_1.spec.normal_module)
            .select(at.problem.arm, 0.0);
    for (const double moment : moments_) {
      at.problem.moment = moment;
      const double mean = moment / (at.problem.length * arms.sum());
      const Eigen::VectorXd start =
          (arms > 0.0).select(Eigen::ArrayXd::Constant(arms.size(), mean), 0.0);
      at.start.push_back(solve_contact(at.problem, start).line_load);
    }
    positions_.push_back(std::move(at));
  }
}

std::optional<NearbyLoad::Loaded> NearbyLoad::loaded(std::size_t position, std::size_t torque,
                                                     std::span<const double> change,
                                                     bool slopes) const {
  const Position& at = positions_[position];
  ContactProblem q = at.problem;
  q.moment = moments_[torque];
  const Eigen::Map<const Eigen::VectorXd> e(change.data(),
                                            static_cast<Eigen::Index>(change.size()));
  q.gap.array() -= (at.turn * e).array() * q.arm.array();
  const ContactSolution x = solve_contact(q, at.start[torque]);
  if (!x.found()) return std::nullopt;
  // The square of the greatest Hertz pressure, by [T12.12] and [T12.13].
  const double square =
      (x.line_load.array() / q.radius.array()).maxCoeff() * q.reduced_modulus / std::numbers::pi;
  Loaded found{at.te - x.approach, std::sqrt(square), {}};
  if (slopes) found.slope = at.turn.transpose() * x.approach_per_gap.cwiseProduct(q.arm);
  return found;
}

NearbyLoad::Span NearbyLoad::span(std::span<const NearbyLoad> halves,
                                  std::span<const double> change, bool slopes) {
  GW_EXPECTS(!halves.empty());
  const NearbyLoad& one = halves.front();
  const std::vector<double> none(slopes ? change.size() : 0, 0.0);
  for (const NearbyLoad& half : halves)
    if (!half.complete_) return {std::nullopt, none};
  Span worst{-1.0, none};
  for (std::size_t k = 0; k < one.moments_.size(); ++k) {
    Loaded least{}, greatest{};
    for (std::size_t i = 0; i < one.positions_.size(); ++i) {
      std::optional<Loaded> here = one.loaded(i, k, change, slopes);
      if (!here) return {std::nullopt, none};
      for (const NearbyLoad& other : halves.subspan(1)) {
        const std::optional<Loaded> second = other.loaded(i, k, change, slopes);
        if (!second) return {std::nullopt, none};
        here->te = (here->te + second->te) / 2;
        here->pressure = std::max(here->pressure, second->pressure);
        if (slopes) here->slope = (here->slope + second->slope) / 2;
      }
      worst.max_pressure = std::max(worst.max_pressure, here->pressure);
      if (i == 0 || here->te > greatest.te) greatest = *here;
      if (i == 0 || here->te < least.te) least = *std::move(here);
    }
    const double value = greatest.te - least.te;
    if (!(value > *worst.value)) continue;
    worst.value = value;
    if (!slopes) continue;
    const Eigen::VectorXd slope = greatest.slope - least.slope;
    worst.slope.assign(slope.begin(), slope.end());
  }
  return worst;
}

}  // namespace gearwright
