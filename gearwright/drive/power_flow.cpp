#include "gearwright/drive/power_flow.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "gearwright/base/contract.hpp"
#include "gearwright/math/decompositions.hpp"

namespace gearwright {

namespace {

/// A power below this fraction of the input power is a rounding error. For the power of a mesh, an
/// input power of less than 1 counts as 1.
constexpr double kIdle = 1e-11;
/// If at most this number of meshes carry load, all patterns of their signs σ are tried.
constexpr std::size_t kMostSigns = 16;

// Returns the bodies with an unknown external torque, which are the fixed bodies, the output, and
// all inputs except the first one.
std::vector<std::size_t> reacting(const DriveGraph& graph) {
  std::vector<std::size_t> list = graph.fixed;
  list.insert(list.end(), graph.inputs.begin() + 1, graph.inputs.end());
  list.push_back(graph.output);
  return list;
}

class Statics {
 public:
  Statics(const DriveGraph& graph, const std::vector<double>& speeds,
          const std::vector<MeshEfficiency>& efficiencies)
      : graph_(graph), speeds_(speeds), efficiencies_(efficiencies), reacting_(reacting(graph)) {}

  // Computes the flow for given driving gears. A mesh whose driver is −1 has no friction.
  PowerFlow solve(const std::vector<int>& driver) const {
    const std::size_t n = graph_.bodies.size();
    const std::size_t meshes = graph_.meshes.size();
    GW_EXPECTS(meshes + reacting_.size() == n);
    Eigen::MatrixXd m = Eigen::MatrixXd::Zero(as_index(n), as_index(n));
    Eigen::VectorXd rhs = Eigen::VectorXd::Zero(as_index(n));
    for (std::size_t k = 0; k < meshes; ++k) {
      for (const auto& [body, torque] : torques(k, driver[k]))
        m(as_index(body), as_index(k)) += torque;
    }
    for (std::size_t r = 0; r < reacting_.size(); ++r)
      m(as_index(reacting_[r]), as_index(meshes + r)) = 1.0;
    rhs(as_index(graph_.inputs.front())) = -1.0;
    const Eigen::VectorXd x = solve_linear(m, rhs);

    PowerFlow flow;
    flow.torque.assign(n, 0.0);
    flow.torque[graph_.inputs.front()] = 1.0;
    for (std::size_t r = 0; r < reacting_.size(); ++r)
      flow.torque[reacting_[r]] = x(as_index(meshes + r));
    for (std::size_t k = 0; k < meshes; ++k) flow.load.push_back(x(as_index(k)));
    double out = 0.0;
    for (std::size_t b = 0; b < n; ++b) {
      const double power = flow.torque[b] * speeds_[b];
      (power > 0.0 ? flow.power_in : out) += power;
    }
    flow.efficiency = flow.power_in > 0.0 ? -out / flow.power_in : 0.0;
    // With one degree of freedom, the input drives. If power also flows in at the output, the drive
    // is self-locking.
    if (graph_.inputs.size() == 1 && flow.torque[graph_.output] * speeds_[graph_.output] >= 0.0)
      flow.efficiency = 0.0;
    find_drivers(flow, driver);
    return flow;
  }

  // Returns the bodies on which a mesh acts, each with its torque for λ = 1. [T13.6]
  std::vector<std::pair<std::size_t, double>> torques(std::size_t mesh, int driver) const {
    const DriveGear& a = graph_.gear(graph_.meshes[mesh], 0);
    const DriveGear& b = graph_.gear(graph_.meshes[mesh], 1);
    const MeshEfficiency& eta = efficiencies_[mesh];
    const double share = driver == 0   ? eta.first_drives
                         : driver == 1 ? 1.0 / eta.second_drives
                                       : 1.0;
    const double t_a = a.factor();
    const double t_b = b.factor() * share;
    std::vector<std::pair<std::size_t, double>> list{{a.body, t_a}, {b.body, t_b}};
    if (const auto frame = graph_.frame(graph_.meshes[mesh])) list.push_back({*frame, -t_a - t_b});
    return list;
  }

 private:
  static Eigen::Index as_index(std::size_t i) { return static_cast<Eigen::Index>(i); }

  // Finds the driving gears of a solution, [T13.7], and the powers in the frames. The torque of a
  // mesh on gear a is z_a λ. Gear a supplies the power −z_a λ (ω_a − ω_c) to the mesh. If this
  // power is > 0, gear a drives.
  void find_drivers(PowerFlow& flow, const std::vector<int>& assumed) const {
    for (std::size_t k = 0; k < graph_.meshes.size(); ++k) {
      const DriveMesh& mesh = graph_.meshes[k];
      const DriveGear& a = graph_.gear(mesh, 0);
      const DriveGear& b = graph_.gear(mesh, 1);
      const auto frame = graph_.frame(mesh);
      const double carried = frame ? speeds_[*frame] : 0.0;
      const auto parts = torques(k, assumed[k]);
      const double into_a = -parts[0].second * flow.load[k] * (speeds_[a.body] - carried);
      const double into_b = -parts[1].second * flow.load[k] * (speeds_[b.body] - carried);
      const double power = std::max(into_a, into_b);
      const bool idle = !(power > kIdle * std::max(flow.power_in, 1.0));
      flow.driver.push_back(idle ? -1 : into_a > 0.0 ? 0 : 1);
      flow.mesh_power.push_back(idle ? 0.0 : power);
    }
  }

  const DriveGraph& graph_;
  const std::vector<double>& speeds_;
  const std::vector<MeshEfficiency>& efficiencies_;
  std::vector<std::size_t> reacting_;
};

// True if the driving gears of the solution are those that were assumed. Idle meshes always agree.
bool consistent(const std::vector<int>& assumed, const std::vector<int>& found) {
  for (std::size_t k = 0; k < found.size(); ++k)
    if (found[k] >= 0 && found[k] != assumed[k]) return false;
  return true;
}

// True if power circulates. Each group of planets, and each mesh in the housing, is a branch that
// passes power from body to body. Power circulates if a branch carries more power than flows in
// from outside.
bool circulates(const DriveGraph& graph, const Statics& statics, const std::vector<double>& speeds,
                const PowerFlow& flow) {
  const std::vector<PlanetGroup> groups = planet_groups(graph);
  std::vector<std::size_t> unit(graph.meshes.size());
  for (std::size_t m = 0; m < unit.size(); ++m) unit[m] = groups.size() + m;
  for (std::size_t g = 0; g < groups.size(); ++g)
    for (const std::size_t m : groups[g].meshes) unit[m] = g;
  std::vector<std::vector<double>> branch(groups.size() + unit.size(),
                                          std::vector<double>(graph.bodies.size()));
  for (std::size_t m = 0; m < unit.size(); ++m)
    for (const auto& [body, torque] : statics.torques(m, flow.driver[m]))
      branch[unit[m]][body] += torque * flow.load[m] * speeds[body];
  return std::any_of(branch.begin(), branch.end(), [&](const auto& powers) {
    return std::any_of(powers.begin(), powers.end(),
                       [&](double p) { return std::abs(p) > flow.power_in * (1 + 1e-9); });
  });
}

}  // namespace

Result<PowerFlow> power_flow(const DriveGraph& graph, const std::vector<double>& speeds,
                             const std::vector<MeshEfficiency>& efficiencies) {
  const Statics statics(graph, speeds, efficiencies);
  const std::size_t meshes = graph.meshes.size();
  const auto finish = [&](PowerFlow flow) {
    flow.circulating = circulates(graph, statics, speeds, flow);
    for (std::size_t m = 0; m < meshes; ++m) {
      for (const auto& [body, torque] : statics.torques(m, flow.driver[m])) {
        const double power = torque * flow.load[m] * speeds[body];
        if (std::abs(power) > kIdle * flow.power_in) flow.paths.push_back({m, body, power});
      }
    }
    return flow;
  };
  const PowerFlow lossless = statics.solve(std::vector<int>(meshes, -1));
  std::vector<int> signs = lossless.driver;
  for (std::size_t turn = 0; turn < 2 * meshes + 2; ++turn) {
    PowerFlow flow = statics.solve(signs);
    if (consistent(signs, flow.driver)) {
      if (flow.efficiency > 0.0) return finish(std::move(flow));
      break;
    }
    signs = flow.driver;
  }
  std::vector<std::size_t> loaded;
  for (std::size_t m = 0; m < meshes; ++m)
    if (lossless.driver[m] >= 0) loaded.push_back(m);
  if (loaded.size() > kMostSigns)
    return Error{
        "drive.mesh", "",
        fmt::format(
            "the directions of power in {} meshes were not found by iteration, and all "
            "combinations can be tried only for at most {} meshes; divide the drive into parts",
            loaded.size(), kMostSigns)};
  for (std::size_t pattern = 0; pattern < (std::size_t(1) << loaded.size()); ++pattern) {
    signs = lossless.driver;
    for (std::size_t k = 0; k < loaded.size(); ++k)
      signs[loaded[k]] = static_cast<int>(pattern >> k & 1);
    PowerFlow flow = statics.solve(signs);
    if (flow.efficiency > 0.0 && consistent(signs, flow.driver)) return finish(std::move(flow));
  }
  return PowerFlow{};
}

std::vector<Rational> lossless_loads(const DriveGraph& graph, const DriveMotion& motion,
                                     std::size_t body, std::size_t held) {
  GW_EXPECTS(motion.freedom == 1 && motion.redundant.empty());
  GW_EXPECTS(held == graph.output || graph.is_input(held));
  const std::size_t n = graph.bodies.size();
  const std::size_t meshes = graph.meshes.size();
  std::vector<std::size_t> reactions = graph.fixed;
  reactions.push_back(held);
  GW_EXPECTS(meshes + reactions.size() == n);
  RationalMatrix rows(n, std::vector<Rational>(n + 1));
  for (std::size_t m = 0; m < meshes; ++m) {
    const auto column = mesh_row(graph, graph.meshes[m]);
    for (std::size_t b = 0; b < n; ++b) rows[b][m] = column[b];
  }
  for (std::size_t r = 0; r < reactions.size(); ++r) rows[reactions[r]][meshes + r] = 1;
  rows[body][n] = -1;
  const auto pivots = reduce_rows(rows, n);
  GW_EXPECTS(pivots.size() == n);
  std::vector<Rational> loads;
  for (std::size_t m = 0; m < meshes; ++m) loads.push_back(rows[m][n]);
  return loads;
}

}  // namespace gearwright
