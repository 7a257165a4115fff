#include "gearwright/drive/planet_equilibrium.hpp"

#include <algorithm>
#include <cmath>

#include "gearwright/base/contract.hpp"
#include "gearwright/base/lists.hpp"
#include "gearwright/drive/drive_places.hpp"

namespace gearwright::detail {

namespace {

using Eigen::Index;
using Eigen::VectorXd;

std::size_t count_of(const PlanetSet& set) { return static_cast<std::size_t>(set.group.count); }

Vec2 unit_at(double turns) { return {std::cos(kTurn * turns), std::sin(kTurn * turns)}; }

}  // namespace

PlanetEquilibrium::PlanetEquilibrium(const Drive& drive, const PlanetSet& set,
                                     const std::vector<MeshPhase>& phases,
                                     const std::vector<double>& nominal, const PlanetErrors& errors)
    : drive_(drive), set_(set) {
  GW_EXPECTS(drive.flow && !drive.flow->self_locking());
  for (const std::size_t m : set.group.meshes) {
    if (drive.flow->driver[m] < 0) continue;
    meshes_.push_back(m);
    nominal_.push_back(nominal[m]);
  }
  find_weights(phases);
  find_unknowns();
  if (errors.floating) {
    displaced_ = unknowns_;
    unknowns_ += 2;
  }
  find_rows(phases, errors);
}

// Finds the weights with which the forces of all meshes are in balance. In every mesh, the torque
// on the driven gear is the lossless torque times the efficiency [T13.6]. Each weight is therefore
// a product of efficiencies along the chain of meshes.
void PlanetEquilibrium::find_weights(const std::vector<MeshPhase>& phases) {
  const DriveGraph& graph = drive_.graph;
  const auto share = [&](std::size_t m, int side) {
    const MeshEfficiency& eta = *drive_.efficiencies[m];
    return side == 0 ? 1.0 : phases[m].first_drives ? eta.first_drives : 1.0 / eta.second_drives;
  };
  std::vector<double> of_body(graph.bodies.size(), 0.0);
  weights_.assign(meshes_.size(), 0.0);
  if (meshes_.empty()) return;
  of_body[graph.gear(graph.meshes[meshes_.front()], 0).body] = 1.0;
  for (std::size_t round = 0; round < meshes_.size(); ++round) {
    for (std::size_t k = 0; k < meshes_.size(); ++k) {
      const DriveMesh& mesh = graph.meshes[meshes_[k]];
      for (const int side : {0, 1}) {
        const double known = of_body[graph.gear(mesh, side).body];
        if (weights_[k] == 0.0 && known > 0.0) weights_[k] = known * share(meshes_[k], side);
      }
      if (weights_[k] == 0.0) continue;
      for (const int side : {0, 1}) {
        double& body = of_body[graph.gear(mesh, side).body];
        if (body == 0.0) body = weights_[k] / share(meshes_[k], side);
      }
    }
  }
}

// Assigns a column to each unknown. A common rotation of all bodies changes no approach, so one
// central body is held. This is the output if the output is a central body. Otherwise, it is a
// fixed central body. If there is no such body, it is any central body that is not an input, or
// else an input.
void PlanetEquilibrium::find_unknowns() {
  const DriveGraph& graph = drive_.graph;
  columns_.assign(graph.bodies.size(), std::nullopt);
  std::vector<std::size_t> central, riders;
  for (const std::size_t m : meshes_)
    for (const int side : {0, 1}) {
      const DriveGear& gear = graph.gear(graph.meshes[m], side);
      auto& list = graph.body(gear).carrier ? riders : central;
      add_once(list, gear.body);
    }
  if (central.empty()) return;
  const auto rank = [&](std::size_t b) {
    return b == graph.output ? 0 : graph.is_fixed(b) ? 1 : graph.is_input(b) ? 3 : 2;
  };
  const std::size_t held =
      *std::min_element(central.begin(), central.end(),
                        [&](std::size_t a, std::size_t b) { return rank(a) < rank(b); });
  for (const std::size_t b : central)
    if (b != held) columns_[b] = unknowns_++;
  for (const std::size_t b : riders) {
    columns_[b] = unknowns_;
    unknowns_ += static_cast<Index>(count_of(set_));
  }
}

std::optional<Index> PlanetEquilibrium::column(std::size_t body, std::size_t planet) const {
  const auto first = columns_[body];
  if (!first) return std::nullopt;
  return drive_.graph.bodies[body].carrier ? *first + static_cast<Index>(planet) : *first;
}

// Returns n, the unit vector of the force of the first gear on the second one. The force presses
// the gears apart. If the first gear drives, the tangential part of the force has the direction in
// which the first gear turns.
Vec2 PlanetEquilibrium::push(std::size_t m, std::size_t planet, const MeshPhase& phase) const {
  const DriveMesh& mesh = drive_.graph.meshes[m];
  const Pair& pair = *drive_.geometry.pairs[m];
  const auto outward = direction(drive_, m, mesh.gears[0]);
  GW_EXPECTS(outward.has_value());
  const double r_1 = pair.gear(1).base_radius(), r_2 = pair.gear(2).base_radius();
  const double cos_w = (r_2 + pair.gear(2).side() * r_1) / *drive_.geometry.distance[m];
  const double turns = turning(drive_, drive_.graph.gear(mesh, 0).body, m) < 0.0 ? -1.0 : 1.0;
  const double along = phase.first_drives ? turns * cos_w : -turns * cos_w;
  const Vec2 u = unit_at(*outward + set_.assembly.turns[planet].value());
  return std::sqrt(std::max(0.0, 1 - cos_w * cos_w)) * u + along * Vec2(-u.y(), u.x());
}

// Returns ε t, the displacement of a gear's axis due to the error of its pin.
Vec2 PlanetEquilibrium::pin(const DriveGear& gear, std::size_t planet,
                            const std::vector<double>& errors) const {
  if (errors.empty() || !drive_.graph.body(gear).carrier) return Vec2::Zero();
  const auto& riders = set_.group.riders;
  const auto rider = std::find(riders.begin(), riders.end(), gear.body) - riders.begin();
  const auto place = place_of(drive_, set_, gear.body);
  GW_EXPECTS(place.has_value());
  const double turns = std::arg(*place) / kTurn + set_.assembly.turns[planet].value();
  return errors[static_cast<std::size_t>(rider) * count_of(set_) + planet] * unit_at(turns + 0.25);
}

void PlanetEquilibrium::find_rows(const std::vector<MeshPhase>& phases,
                                  const PlanetErrors& errors) {
  const DriveGraph& graph = drive_.graph;
  // x_b is θ_b times the base radius of the first gear on the body.
  std::vector<double> radius(graph.bodies.size(), 0.0);
  problem_.load = VectorXd::Zero(unknowns_);
  output_ = VectorXd::Zero(unknowns_);
  for (std::size_t k = 0; k < meshes_.size(); ++k) {
    const std::size_t m = meshes_[k];
    const DriveMesh& mesh = graph.meshes[m];
    const MeshPhase& phase = phases[m];
    const double per_tooth =
        drive_.geometry.pairs[m]->gear(1).reference().base_pitch_transverse / kTurn;
    const DriveGear& driver = graph.gear(mesh, phase.first_drives ? 0 : 1);
    const double sigma = driver.teeth * turning(drive_, driver.body, m) < 0.0 ? -1.0 : 1.0;
    for (std::size_t i = 0; i < count_of(set_); ++i) {
      SharingProblem::Spring spring;
      spring.row = VectorXd::Zero(unknowns_);
      spring.weight = weights_[k];
      spring.nominal = nominal_[k];
      const Vec2 n = push(m, i, phase);
      for (const int side : {0, 1}) {
        const DriveGear& gear = graph.gear(mesh, side);
        const double sign = side == 0 ? 1.0 : -1.0;
        spring.offset += sign * n.dot(pin(gear, i, errors.pins));
        const bool floats = errors.floating == gear.body ||
                            (graph.body(gear).carrier && errors.floating == graph.frame(mesh));
        if (floats) spring.row.segment<2>(*displaced_) += sign * n;
        double& r = radius[gear.body];
        if (r == 0.0) r = std::abs(gear.teeth) * per_tooth;
        const auto c = column(gear.body, i);
        if (!c) continue;
        spring.row[*c] += sigma * per_tooth * gear.teeth / r;
        // The rotation of the output is a sum over the meshes of a single copy. In this sum, the
        // terms of the rotations of the planets cancel.
        if (i == 0) output_[*c] -= phase.weight * spring.row[*c];
      }
      problem_.load += weights_[k] * nominal_[k] * spring.row;
      problem_.springs.push_back(std::move(spring));
    }
  }
  if (displaced_) problem_.load.segment<2>(*displaced_).setZero();
}

PlanetState PlanetEquilibrium::solve(const std::vector<std::vector<MeshState>>& states) const {
  SharingProblem problem = problem_;
  for (std::size_t k = 0, s = 0; k < meshes_.size(); ++k)
    for (std::size_t i = 0; i < count_of(set_); ++i, ++s) {
      problem.springs[s].spring = states[k][i].spring;
      problem.springs[s].offset += states[k][i].lead;
    }
  const SharingSolution solved = share_load(problem);
  PlanetState state;
  state.found = solved.found();
  for (std::size_t k = 0, s = 0; k < meshes_.size(); ++k) {
    state.forces.emplace_back();
    for (std::size_t i = 0; i < count_of(set_); ++i, ++s)
      state.forces.back().push_back(solved.forces[s]);
  }
  state.output = output_.dot(solved.x);
  if (displaced_) state.displacement = solved.x.segment<2>(*displaced_);
  return state;
}

}  // namespace gearwright::detail
