#include "gearwright/load/nearby_load.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "gearwright/load/loaded_position.hpp"

namespace gearwright {

namespace {

// Pressures below this fraction of the greatest one are omitted from LinearSpreads.
constexpr double kSlightPressure = 0.5;

// p_Hertz² at each place by [T12.12] and [T12.13]
Eigen::ArrayXd squared_pressure(const ContactProblem& q, const ContactSolution& x) {
  return (x.line_load.array() / q.radius.array()) * q.reduced_modulus / std::numbers::pi;
}

}  // namespace

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
    Position at{found.te, std::move(found.problem), {}, {}, {}};
    at.turn.resize(static_cast<Eigen::Index>(found.rows.size()),
                   static_cast<Eigen::Index>(influences.size()));
    for (Eigen::Index row = 0; row < at.turn.rows(); ++row) {
      const detail::Row& place = found.rows[static_cast<std::size_t>(row)];
      for (Eigen::Index k = 0; k < at.turn.cols(); ++k)
        at.turn(row, k) = solver.slope(found.pairs[static_cast<std::size_t>(place.pair)],
                                       place.slice, influences[static_cast<std::size_t>(k)]);
    }
    at.gap_slope = -(at.turn.array().colwise() * at.problem.arm.array()).matrix();
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

std::optional<ContactSolution> NearbyLoad::solved(const Position& at, std::size_t torque,
                                                  std::span<const double> change,
                                                  bool load_slopes) const {
  ContactProblem q = at.problem;
  q.moment = moments_[torque];
  const Eigen::Map<const Eigen::VectorXd> e(change.data(),
                                            static_cast<Eigen::Index>(change.size()));
  q.gap.array() -= (at.turn * e).array() * q.arm.array();
  if (load_slopes) q.gap_slope = at.gap_slope;
  ContactSolution x = solve_contact(q, at.start[torque]);
  if (!x.found()) return std::nullopt;
  return x;
}

std::optional<NearbyLoad::Loaded> NearbyLoad::loaded(std::size_t position, std::size_t torque,
                                                     std::span<const double> change,
                                                     bool slopes) const {
  const Position& at = positions_[position];
  const auto x = solved(at, torque, change, false);
  if (!x) return std::nullopt;
  const double square = squared_pressure(at.problem, *x).maxCoeff();
  Loaded found{at.te - x->approach, std::sqrt(square), {}};
  if (slopes) found.slope = at.turn.transpose() * x->approach_per_gap.cwiseProduct(at.problem.arm);
  return found;
}

std::optional<LinearSpreads> NearbyLoad::linear(std::span<const double> change,
                                                Quantity quantity) const {
  if (!complete_) return std::nullopt;
  const bool pressure = quantity == Quantity::pressure;
  LinearSpreads all;
  for (std::size_t k = 0; k < moments_.size(); ++k) {
    std::vector<ContactSolution> found;
    double greatest = 0.0;
    for (const Position& at : positions_) {
      auto x = solved(at, k, change, pressure);
      if (!x) return std::nullopt;
      greatest = std::max(greatest, squared_pressure(at.problem, *x).maxCoeff());
      found.push_back(*std::move(x));
    }
    all.begin_group();
    if (pressure) all.add(0.0, std::vector<double>(change.size(), 0.0));
    for (std::size_t i = 0; i < found.size(); ++i) {
      const Position& at = positions_[i];
      const ContactSolution& x = found[i];
      if (!pressure) {
        all.add(at.te - x.approach,
                Eigen::VectorXd(-at.gap_slope.transpose() * x.approach_per_gap));
        continue;
      }
      const Eigen::ArrayXd square = squared_pressure(at.problem, x);
      for (Eigen::Index row = 0; row < square.size(); ++row) {
        if (square[row] < kSlightPressure * kSlightPressure * greatest) continue;
        const double p = std::sqrt(square[row]);
        all.add(p, Eigen::VectorXd(p / (2 * x.line_load[row]) * x.load_slope.row(row).transpose()));
      }
    }
  }
  return all;
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
