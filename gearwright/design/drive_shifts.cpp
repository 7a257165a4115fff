#include "gearwright/design/drive_shifts.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "gearwright/base/contract.hpp"
#include "gearwright/drive/drive_geometry.hpp"
#include "gearwright/pair/shift.hpp"

namespace gearwright {

namespace {

double rounded_up(double x) {
  constexpr double kPerUnit = 1e4;
  return std::ceil(x * kPerUnit) / kPerUnit + 0.0;  // + 0.0 turns −0 into 0
}

// Returns x_u of each external gear. x_u is the limit for teeth without allowance minus x_E − x.
// The difference x_E − x is the distance, in modules, by which the thickness allowance moves the
// cutter.
GearShifts undercut_limits(const DriveGraph& graph) {
  GearShifts limits;
  for (const DriveGear& gear : graph.gears) {
    limits.emplace_back();
    if (gear.teeth <= 0 || !gear.spec) continue;
    CylindricalSpec spec = *gear.spec;
    spec.teeth = gear.teeth;
    spec.profile_shift = 0.0;
    // A backlash thins each gear of its mesh by at most j_n/2, because α_wn ≥ α_n if Σx ≥ 0.
    for (const DriveMesh& mesh : graph.meshes)
      if (mesh.backlash && (&graph.gear(mesh, 0) == &gear || &graph.gear(mesh, 1) == &gear))
        spec.thickness_allowance = std::min(spec.thickness_allowance, -*mesh.backlash / 2);
    const auto made = make_gear(spec);
    const auto least = made ? made->undercut_free_shift() : std::nullopt;
    if (least) limits.back() = *least - made->reference().generating_profile_shift;
  }
  return limits;
}

// Returns shifts of two external gears without undercut, with the least sum ≥ 0. The sum is divided
// according to [T2.18a], so each shift grows by z/(z1 + z2) per unit of the sum. If the sum is 0,
// the sum of the rounded shifts is also 0.
std::array<double, 2> balanced_shifts(const std::array<int, 2>& z,
                                      const std::array<double, 2>& limits) {
  const auto start = divided_shift_sum(z[0], z[1], 0.0);
  double sum = 0.0;
  for (const std::size_t i : {0, 1})
    sum = std::max(sum, (limits[i] - start[i]) * (z[0] + z[1]) / z[i]);
  const auto x = divided_shift_sum(z[0], z[1], sum);
  const double first = rounded_up(x[0]);
  return {first, std::max(sum == 0.0 ? 0.0 - first : rounded_up(x[1]), rounded_up(limits[1]))};
}

// Moves the centre distance of a mesh of two external gears into a band if it lies outside. The new
// distance determines the sum of the shifts. The first gear gets the part that `first_of` computes,
// unless a gear is then undercut. Returns false if the teeth cannot have this distance.
template <class Part>
bool move_into(const std::array<double, 2>& band, const DriveGraph& graph, const DriveMesh& mesh,
               const GearShifts& limits, const Part& first_of, GearShifts& shifts) {
  const auto [a, b] = mesh.gears;
  const DriveGear& gear = graph.gears[a];
  ShiftProblem problem;
  problem.z1 = gear.teeth;
  problem.z2 = graph.gears[b].teeth;
  problem.normal_module = gear.spec->normal_module;
  problem.normal_pressure_angle = gear.spec->normal_pressure_angle;
  problem.helix_angle = {gear.spec->helix_angle, graph.gears[b].spec->helix_angle};
  problem.x1 = shifts[a];
  problem.x2 = shifts[b];
  const auto own = complete_shifts(problem);
  if (!own) return false;
  const double distance = std::clamp(own->center_distance, band[0], band[1]);
  if (distance == own->center_distance) return true;
  problem.x1.reset();
  problem.x2.reset();
  problem.center_distance = distance;
  const auto moved = complete_shifts(problem);
  if (!moved) return false;
  const double sum = moved->x1 + moved->x2;
  shifts[a] = std::max(first_of(sum), rounded_up(*limits[a]));
  shifts[b] = sum - *shifts[a];
  if (*shifts[b] >= *limits[b]) return true;
  shifts[b] = rounded_up(*limits[b]);
  shifts[a] = sum - *shifts[b];
  return true;
}

// Prevents undercut of gears whose shifts follow from the centre distance. If such a shift is less
// than x_u, it is set to x_u, and the mating gear's shift follows from the centre distance.
void raise(DriveGraph graph, const GearShifts& limits, GearShifts& shifts) {
  bool all_given = true;
  for (std::size_t g = 0; g < shifts.size(); ++g) {
    graph.gears[g].shift = shifts[g];
    all_given = all_given && (shifts[g] || !limits[g]);
  }
  if (all_given) return;
  const DriveGeometry made = drive_geometry(graph);
  for (std::size_t g = 0; g < shifts.size(); ++g)
    if (limits[g] && !shifts[g] && made.shift[g] && *made.shift[g] < *limits[g])
      shifts[g] = rounded_up(*limits[g]);
}

}  // namespace

std::vector<GearShifts> shift_trials(const DriveGraph& graph,
                                     const std::optional<std::array<double, 2>>& distance) {
  const GearShifts limits = undercut_limits(graph);
  GearShifts least(limits.size()), balanced(limits.size());
  for (std::size_t m = 0; m < graph.meshes.size(); ++m) {
    const DriveMesh& mesh = graph.meshes[m];
    GW_EXPECTS(!mesh.center_distance);
    // The first mesh of a planet determines the centre distance of its other meshes.
    if (m > 0 && graph.frame(mesh)) continue;
    for (const std::size_t g : mesh.gears)
      if (limits[g]) balanced[g] = least[g] = std::max(0.0, rounded_up(*limits[g]));
    const auto [a, b] = mesh.gears;
    if (!limits[a] || !limits[b]) continue;
    const auto x =
        balanced_shifts({graph.gears[a].teeth, graph.gears[b].teeth}, {*limits[a], *limits[b]});
    balanced[a] = x[0];
    balanced[b] = x[1];
    if (!distance) continue;
    const int z1 = graph.gears[a].teeth, z2 = graph.gears[b].teeth;
    const auto divided = [&](double sum) { return rounded_up(divided_shift_sum(z1, z2, sum)[0]); };
    const auto kept = [own = *least[a]](double) { return own; };
    if (!move_into(*distance, graph, mesh, limits, divided, balanced)) return {};
    if (!move_into(*distance, graph, mesh, limits, kept, least)) return {};
  }
  raise(graph, limits, balanced);
  if (balanced != least) raise(graph, limits, least);
  std::vector<GearShifts> trials{balanced};
  if (balanced != least) trials.push_back(least);
  return trials;
}

}  // namespace gearwright
