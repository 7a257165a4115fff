#include "gearwright/load/loaded_contact.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "gearwright/base/parallel.hpp"
#include "gearwright/compliance/probe.hpp"
#include "gearwright/load/load_summary.hpp"
#include "gearwright/load/loaded_position.hpp"
#include "gearwright/load/point_position.hpp"

namespace gearwright {

namespace {

using detail::PointSolver;
using detail::PositionSolver;
using detail::RootStress;
using Eigen::MatrixXd;

// Returns the greatest value, or NaN if any value is NaN.
double greatest_of(const std::vector<double>& list) {
  for (const double v : list)
    if (std::isnan(v)) return v;
  return *std::max_element(list.begin(), list.end());
}

void add_swing(LoadedTorque& to, std::size_t g, const detail::RootSwing& more) {
  if (more.most.size() == 0) return;
  MatrixXd& most = to.root_stress[g];
  MatrixXd& least = to.least_root_stress[g];
  most = most.size() == 0 ? more.most : MatrixXd(most.cwiseMax(more.most));
  least = least.size() == 0 ? more.least : MatrixXd(least.cwiseMin(more.least));
}

// Removes from the transmission error the mean rotation of gear 2 that is due to the displacement
// of the axes. At each position, this rotation is the difference between Θ and the approach of the
// mesh. `sign` is the value of ContactPair::turned(), +1 or −1. [T12.36a]
void leave_out_displacement(LoadedTorque& t, double sign, double base_radius) {
  double sum = 0.0;
  int solved = 0;
  for (const LoadedPosition& p : t.positions) {
    if (!p.solved()) continue;
    sum += sign * (p.unloaded_te.rad() - p.te.rad()) - p.approach / base_radius;
    ++solved;
  }
  for (LoadedPosition& p : t.positions)
    if (p.solved()) p.te = Angle::radians(p.te.rad() + sign * sum / solved);
}

}  // namespace

std::vector<Angle> rotations_of(const ContactPair& pair, const LoadRequest& request) {
  std::vector<Angle> rotations = request.rotations;
  if (rotations.empty())
    for (int i = 0; i < request.positions; ++i)
      rotations.push_back(
          Angle::radians(pair.pitch() * (static_cast<double>(i) / request.positions - 0.5)));
  return rotations;
}

LoadedTurn::LoadedTurn(const ContactPair& pair, const Gear& gear_1, const Gear& gear_2,
                       const PairCompliance& compliance, const LoadRequest& request,
                       const ContactPair* perfect)
    : pair_(pair),
      one_(gear_1),
      two_(gear_2),
      compliance_(compliance),
      request_(request),
      perfect_(perfect),
      undeflected_(request.undeflected()),
      rotations_(rotations_of(pair, request)) {
  for (std::size_t g = 0; g < 2; ++g)
    found_.slices[g] =
        pair.turned() < 0.0 ? compliance.slices[g].reflected() : compliance.slices[g];
  found_.regime = request.regime;
  const std::array<const Gear*, 2> gears{&gear_1, &gear_2};
  for (int g = 0; g < 2; ++g) {
    const double m = gears[g]->spec.normal_module;
    for (const auto& place : compliance.table[g]->root().place)
      found_.root_points[g].push_back(place * m);
    if (request.regime == LoadRegime::point) continue;
    const auto& mesh = compliance.table[g]->section().mesh;
    const ElasticBody& body = compliance.bodies[g];
    found_.body_twist[g] = body_twist(gears[g]->base_radius() / m, mesh.bore_radius,
                                      mesh.root_radius, body.poisson_ratio) /
                           body.youngs_modulus;
  }
  for (const double torque : request.torques) {
    found_.torques.emplace_back();
    found_.torques.back().torque = torque;
    found_.torques.back().positions.resize(rotations_.size());
    perfect_share_.emplace_back(perfect ? rotations_.size() : 0);
  }
}

void LoadedTurn::solve(std::size_t from, std::size_t to) {
  request_.regime == LoadRegime::point ? solve_with<PointSolver>(from, to)
                                       : solve_with<PositionSolver>(from, to);
}

// Every position is computed independently, so the result does not depend on the number of threads.
template <class Solver>
void LoadedTurn::solve_with(std::size_t from, std::size_t to) {
  Solver solver(pair_, one_, two_, compliance_, request_);
  std::optional<Solver> perfect;
  if (perfect_) perfect.emplace(*perfect_, one_, two_, compliance_, undeflected_);
  std::vector<RootStress> swing(found_.torques.size());
  for (std::size_t i = from; i < to; ++i) {
    auto at = solver.prepare(pair_.to_world(rotations_[i].rad()));
    for (std::size_t k = 0; k < swing.size(); ++k) {
      LoadedTorque& t = found_.torques[k];
      bool fine = false;
      t.positions[i] = solver.solve(at, t.torque, rotations_[i], fine, swing[k]);
      if (fine) too_fine_ = true;
    }
    if (perfect_) {
      auto free = perfect->prepare(perfect_->to_world(rotations_[i].rad()));
      for (std::size_t k = 0; k < swing.size(); ++k)
        perfect_share_[k][i] = perfect->greatest_share(free, found_.torques[k].torque);
    }
    count_step(request_.progress);
  }
  const std::lock_guard lock(root_);
  for (std::size_t k = 0; k < swing.size(); ++k)
    for (std::size_t g = 0; g < 2; ++g) add_swing(found_.torques[k], g, swing[k][g]);
}

LoadedContact LoadedTurn::result() const {
  LoadedContact result = found_;
  result.slices_too_fine = too_fine_;
  const SummaryBasis basis{result.slices[0].hi - result.slices[0].lo,
                           result.regime == LoadRegime::line ? one_.base_radius() : 0.0,
                           result.body_twist[0] + result.body_twist[1], request_.rotations.empty(),
                           result.regime};
  std::optional<ShaftYield> shafts;
  if (request_.shafts[0] || request_.shafts[1])
    shafts.emplace(pair_, one_, two_, compliance_, request_);
  for (std::size_t k = 0; k < result.torques.size(); ++k) {
    LoadedTorque& t = result.torques[k];
    for (std::size_t g = 0; g < 2; ++g) {
      if (t.root_stress[g].size() == 0) continue;
      if (pair_.turned() < 0.0) {
        t.root_stress[g].rowwise().reverseInPlace();
        t.least_root_stress[g].rowwise().reverseInPlace();
      }
      Eigen::Index point = 0;
      Eigen::Index slice = 0;
      t.root_stress[g].maxCoeff(&point, &slice);
      t.least_at_max[g] = t.least_root_stress[g](point, slice);
    }
    result.unfinished += std::count_if(t.positions.begin(), t.positions.end(),
                                       [](const LoadedPosition& p) { return p.unfinished; });
    if (shafts) leave_out_displacement(t, pair_.turned(), two_.base_radius());
    summarise(t, basis);
    if (shafts && t.face_load.size() > 0) t.shafts = shafts->under(t.face_load);
    if (perfect_share_[k].empty()) continue;
    const double perfect = greatest_of(perfect_share_[k]);
    t.transverse_load_factor = perfect > 0.0 ? t.max_share / perfect : kNoNumber;
  }
  return result;
}

LoadedContact loaded_contact(const ContactPair& pair, const Gear& gear_1, const Gear& gear_2,
                             const PairCompliance& compliance, const LoadRequest& request,
                             const ContactPair* perfect) {
  LoadedTurn turn(pair, gear_1, gear_2, compliance, request, perfect);
  begin_stage(request.progress, "computing the positions under load",
              static_cast<std::int64_t>(turn.positions()));
  parallel_for(turn.positions(), [&](std::size_t i) { turn.solve(i, i + 1); });
  return turn.result();
}

}  // namespace gearwright
