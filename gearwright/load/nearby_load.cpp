#include "gearwright/load/nearby_load.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numbers>

#include "gearwright/base/parallel.hpp"
#include "gearwright/load/loaded_position.hpp"

namespace gearwright {

namespace {

// The number of positions that are computed with the same search of the places.
constexpr std::size_t kPositionsTogether = 8;

}  // namespace

NearbyLoad::NearbyLoad(const ContactPair& pair, const Gear& gear_1, const Gear& gear_2,
                       const PairCompliance& compliance, const LoadRequest& request,
                       std::span<const Influence> influences) {
  GW_EXPECTS(request.regime == LoadRegime::line);
  const double ratio = std::abs(double(gear_2.spec.teeth) / gear_1.spec.teeth);
  for (const double torque : request.torques) moments_.push_back(torque * ratio);
  const std::vector<Angle> rotations = rotations_of(pair, request);
  positions_.resize(rotations.size());
  std::atomic<bool> complete{true};
  const std::size_t blocks = (rotations.size() + kPositionsTogether - 1) / kPositionsTogether;
  parallel_for(blocks, [&](std::size_t block) {
    detail::PositionSolver solver(pair, gear_1, gear_2, compliance, request);
    const std::size_t end = std::min(rotations.size(), (block + 1) * kPositionsTogether);
    for (std::size_t i = block * kPositionsTogether; i < end && complete; ++i) {
      detail::Position found =
          solver.prepare(pair.to_world(rotations[i].rad()), detail::PositionSolver::Slices::all);
      if (found.rows.empty()) {
        complete = false;
        return;
      }
      Position& at = positions_[i];
      at.te = found.te;
      at.problem = std::move(found.problem);
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
    }
  });
  complete_ = complete;
}

ContactProblem NearbyLoad::problem(std::size_t position, std::size_t torque,
                                   std::span<const double> change) const {
  const Position& at = positions_[position];
  ContactProblem q = at.problem;
  q.moment = moments_[torque];
  const Eigen::Map<const Eigen::VectorXd> e(change.data(),
                                            static_cast<Eigen::Index>(change.size()));
  q.gap.array() -= (at.turn * e).array() * q.arm.array();
  return q;
}

std::optional<NearbyLoad::Loaded> NearbyLoad::loaded(std::size_t position, std::size_t torque,
                                                     std::span<const double> change,
                                                     bool slopes) const {
  const Position& at = positions_[position];
  const ContactProblem q = problem(position, torque, change);
  const ContactSolution x = solve_contact(q, at.start[torque]);
  if (!x.found()) return std::nullopt;
  // The square of the greatest Hertz pressure, by [T12.12] and [T12.13].
  const double square =
      (x.line_load.array() / q.radius.array()).maxCoeff() * q.reduced_modulus / std::numbers::pi;
  Loaded found{at.te - x.approach, std::sqrt(square), {}};
  if (slopes) found.slope = at.turn.transpose() * x.approach_per_gap.cwiseProduct(q.arm);
  return found;
}

std::optional<LoadTangents> NearbyLoad::tangents(std::span<const double> change) const {
  if (!complete_) return std::nullopt;
  const std::size_t count = positions_.size();
  LoadTangents found;
  found.at_.assign(moments_.size(), std::vector<LoadTangents::Position>(count));
  std::atomic<bool> solved{true};
  parallel_for(count * moments_.size(), [&](std::size_t i) {
    const std::size_t torque = i / count, position = i % count;
    const Position& at = positions_[position];
    const ContactProblem q = problem(position, torque, change);
    const ContactSolution x = solve_contact(q, at.start[torque]);
    if (!x.found()) {
      solved = false;
      return;
    }
    // The square of the Hertz pressure per line load, by [T12.12] and [T12.13], and [T12.20a].
    const Eigen::ArrayXd square = q.reduced_modulus / std::numbers::pi * q.radius.array().inverse();
    const Eigen::MatrixXd gap_slope = q.arm.asDiagonal() * -at.turn;
    found.at_[torque][position] = {at.te - x.approach, -gap_slope.transpose() * x.approach_per_gap,
                                   square * x.line_load.array(),
                                   square.matrix().asDiagonal() * load_slopes(q, x, gap_slope)};
  });
  if (!solved) return std::nullopt;
  return found;
}

Tangent LoadTangents::span(const Eigen::VectorXd& step) const {
  Tangent worst{-1.0};
  for (const auto& positions : at_) {
    const Position *least = nullptr, *greatest = nullptr;
    double lo = kInfinity, hi = -kInfinity;
    for (const Position& p : positions) {
      const double te = p.te + p.te_slope.dot(step);
      if (te > hi) {
        hi = te;
        greatest = &p;
      }
      if (te < lo) {
        lo = te;
        least = &p;
      }
    }
    if (hi - lo > worst.value) worst = {hi - lo, greatest->te_slope - least->te_slope};
  }
  return worst;
}

Tangent LoadTangents::pressure_squared(const Eigen::VectorXd& step) const {
  Tangent worst{-1.0};
  for (const auto& positions : at_) {
    for (const Position& p : positions) {
      Eigen::Index place = 0;
      const double square = (p.square + p.square_slope * step).maxCoeff(&place);
      if (square > worst.value) worst = {square, p.square_slope.row(place).transpose()};
    }
  }
  return worst;
}

NearbyLoad::Span NearbyLoad::span(std::span<const NearbyLoad> halves,
                                  std::span<const double> change, bool slopes) {
  GW_EXPECTS(!halves.empty());
  const NearbyLoad& one = halves.front();
  const std::vector<double> none(slopes ? change.size() : 0, 0.0);
  for (const NearbyLoad& half : halves)
    if (!half.complete_) return {std::nullopt, none};
  const std::size_t count = one.positions_.size();
  std::vector<std::optional<Loaded>> found(count * one.moments_.size());
  parallel_for(found.size(), [&](std::size_t n) {
    const std::size_t k = n / count, i = n % count;
    std::optional<Loaded> here = one.loaded(i, k, change, slopes);
    for (const NearbyLoad& other : halves.subspan(1)) {
      const std::optional<Loaded> second = other.loaded(i, k, change, slopes);
      if (!here || !second) return;
      here->te = (here->te + second->te) / 2;
      here->pressure = std::max(here->pressure, second->pressure);
      if (slopes) here->slope = (here->slope + second->slope) / 2;
    }
    found[n] = std::move(here);
  });
  Span worst{-1.0, none};
  for (std::size_t k = 0; k < one.moments_.size(); ++k) {
    const Loaded *least = nullptr, *greatest = nullptr;
    for (std::size_t i = 0; i < count; ++i) {
      const std::optional<Loaded>& here = found[k * count + i];
      if (!here) return {std::nullopt, none};
      worst.max_pressure = std::max(worst.max_pressure, here->pressure);
      if (!greatest || here->te > greatest->te) greatest = &*here;
      if (!least || here->te < least->te) least = &*here;
    }
    const double value = greatest->te - least->te;
    if (!(value > *worst.value)) continue;
    worst.value = value;
    if (!slopes) continue;
    const Eigen::VectorXd slope = greatest->slope - least->slope;
    worst.slope.assign(slope.begin(), slope.end());
  }
  return worst;
}

}  // namespace gearwright
