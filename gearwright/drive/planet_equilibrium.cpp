#include "gearwright/drive/planet_equilibrium.hpp"

#include <algorithm>
#include <cmath>

#include "gearwright/base/contract.hpp"
#include "gearwright/drive/drive_places.hpp"

namespace gearwright::detail {

namespace {

using Eigen::Index;
using Eigen::VectorXd;

std::size_t count_of(const PlanetSet& set) { return static_cast<std::size_t>(set.group.count); }

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

// The torque of a follower is that of its driver times the efficiency [T13.6]. Weights that make the
// forces of all meshes balance are products of efficiencies along the chain of the meshes.
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

// A common rotation of all bodies changes no approach, so one central body is held: the output or a
// held body, if it is one of them.
void PlanetEquilibrium::find_unknowns() {
  const DriveGraph& graph = drive_.graph;
  columns_.assign(graph.bodies.size(), std::nullopt);
  std::vector<std::size_t> central, riders;
  for (const std::size_t m : meshes_)
    for (const int side : {0, 1}) {
      const DriveGear& gear = graph.gear(graph.meshes[m], side);
      auto& list = graph.body(gear).carrier ? riders : central;
      if (std::find(list.begin(), list.end(), gear.body) == list.end()) list.push_back(gear.body);
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

// ∂y/∂D of a mesh: the component of a displacement along the line of action.
Vec2 PlanetEquilibrium::pushed(std::size_t m, std::size_t planet, const MeshPhase& phase,
                               std::size_t floating) const {
  const DriveGraph& graph = drive_.graph;
  const DriveMesh& mesh = graph.meshes[m];
  const int side = graph.body(graph.gear(mesh, 0)).carrier ? 1 : 0;
  const DriveGear& central = graph.gear(mesh, side);
  if (graph.body(central).carrier) return Vec2::Zero();  // both ride, and move together
  const bool carrier = graph.frame(mesh) == floating;
  if (central.body != floating && !carrier) return Vec2::Zero();
  // The planet's direction, and the force of a driving gear on the flank of the other.
  std::optional<GeometryFault> fault;
  const auto places = rider_places(graph, set_.group, drive_.geometry.distance, fault);
  GW_EXPECTS(places.has_value());
  const std::size_t rider = graph.gear(mesh, 1 - side).body;
  const auto& riders = set_.group.riders;
  const auto at = std::find(riders.begin(), riders.end(), rider) - riders.begin();
  const double psi =
      (*places)[static_cast<std::size_t>(at)].angle + kTurn * set_.assembly.turns[planet].value();
  const Pair& pair = *drive_.geometry.pairs[m];
  const bool ring = central.teeth < 0;
  const double r_c = pair.gear(side + 1).base_radius(), r_p = pair.gear(2 - side).base_radius();
  const double cos_w = std::abs(r_c + (ring ? -r_p : r_p)) / *drive_.geometry.distance[m];
  const double sin_w = std::sqrt(std::max(0.0, 1 - cos_w * cos_w));
  const bool drives = phase.first_drives == (side == 0);
  const double sense = turning(drive_, central.body, m) < 0.0 ? -1.0 : 1.0;
  // The tangential component of n has the sense of the central gear if a sun drives or a ring is
  // driven, otherwise the opposite sense. The radial component is outward.
  const double along = sense * (ring == drives ? -1.0 : 1.0) * cos_w;
  const Vec2 n(-along * std::sin(psi) + sin_w * std::cos(psi),
               along * std::cos(psi) + sin_w * std::sin(psi));
  return (ring ? -1.0 : 1.0) * (carrier ? -1.0 : 1.0) * n;
}

void PlanetEquilibrium::find_rows(const std::vector<MeshPhase>& phases,
                                  const PlanetErrors& errors) {
  const DriveGraph& graph = drive_.graph;
  // x_b = θ_b times the base radius of the first gear on the body.
  std::vector<double> radius(graph.bodies.size(), 0.0);
  problem_.load = VectorXd::Zero(unknowns_);
  output_ = VectorXd::Zero(unknowns_);
  std::optional<GeometryFault> fault;
  const auto places = rider_places(graph, set_.group, drive_.geometry.distance, fault);
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
      double teeth = 0.0;
      for (const int side : {0, 1}) {
        const DriveGear& gear = graph.gear(mesh, side);
        teeth += gear.teeth;
        double& r = radius[gear.body];
        if (r == 0.0) r = std::abs(gear.teeth) * per_tooth;
        const auto c = column(gear.body, i);
        if (!c) continue;
        spring.row[*c] += sigma * per_tooth * gear.teeth / r;
        // One copy gives the rotation of the output. Riders cancel.
        if (i == 0) output_[*c] -= phase.weight * spring.row[*c];
      }
      if (!errors.pins.empty()) {
        GW_EXPECTS(places.has_value());
        spring.offset = -sigma * per_tooth * teeth * errors.pins[i] / places->front().distance;
      }
      problem_.load += weights_[k] * nominal_[k] * spring.row;
      if (displaced_) spring.row.segment<2>(*displaced_) = pushed(m, i, phase, *errors.floating);
      problem_.springs.push_back(std::move(spring));
    }
  }
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
