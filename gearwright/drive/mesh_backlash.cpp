// Computes the thickness allowances that give the meshes of a drive their required backlash.
//
//   j_n    backlash in the normal section, mm
//   t      thinning −(E_sn,a + E_sn,b) of the two gears of a mesh, mm [T9.13]
//                                              theory: docs/theory/13-drives.md, 13.5
#include <algorithm>
#include <cmath>

#include "gearwright/base/numbers.hpp"
#include "gearwright/drive/drive_geometry.hpp"

namespace gearwright {

namespace {

struct MeshThinning {
  std::size_t mesh;
  double thinning;  // t  mm
};

// Returns the t that gives the mesh its required backlash. Returns none if no backlash is required
// or if the gears are not mounted. For circular arcs, dt/dj_n is not exactly 1, so the result is
// only approximate.
std::optional<MeshThinning> needed_thinning(DriveGraph& graph, const DriveGeometry& made,
                                            std::size_t m) {
  const auto& wanted = graph.meshes[m].backlash;
  std::optional<double> now;
  if (const auto& rack = made.racks[m]) now = rack->normal_backlash();
  if (const auto& pair = made.pairs[m])
    if (const auto backlash = backlash_of(*pair)) now = backlash->normal;
  if (!wanted || !now) return std::nullopt;
  double per_backlash = 1.0;  // dt/dj_n = cos α_wn/cos α_n
  if (const ParallelPair* pair = made.involutes(m))
    per_backlash = pair->mesh.rack.angles.cos_alpha /
                   std::cos(pair->gears[0].spec.normal_pressure_angle.rad());
  double thinning = (*wanted - *now) * per_backlash;
  for (const std::size_t g : graph.meshes[m].gears)
    thinning -= graph.gears[g].thickness_allowance();
  return MeshThinning{m, thinning};
}

// Divides the thinning of each mesh between its two gears. If neither gear has a thinning yet, the
// division is equal. The mesh with the least thinning comes first. After this mesh, the meshes with
// a gear that already has a thinning come before all others. In this order, all gears become
// thinner if the meshes of a set need similar thinnings.
std::vector<std::optional<double>> divided(const DriveGraph& graph,
                                           std::vector<MeshThinning> open) {
  std::vector<std::optional<double>> of_gear(graph.gears.size());
  const auto joins = [&](const MeshThinning& mesh) {
    const auto [a, b] = graph.meshes[mesh.mesh].gears;
    return of_gear[a] || of_gear[b];
  };
  while (!open.empty()) {
    const auto next = std::min_element(open.begin(), open.end(), [&](const auto& x, const auto& y) {
      return joins(x) != joins(y) ? joins(x) : x.thinning < y.thinning;
    });
    const auto [a, b] = graph.meshes[next->mesh].gears;
    if (!joins(*next)) of_gear[a] = next->thinning / 2;
    if (!of_gear[a]) of_gear[a] = next->thinning - *of_gear[b];
    if (!of_gear[b]) of_gear[b] = next->thinning - *of_gear[a];
    open.erase(next);
  }
  return of_gear;
}

}  // namespace

DriveGraph with_backlash(DriveGraph graph) {
  constexpr int kPasses = 8;        // involute teeth need two passes
  constexpr double kClose = 1e-10;  // mm, change of an allowance that ends the iteration
  const auto has_backlash = [](const DriveMesh& mesh) { return mesh.backlash.has_value(); };
  if (std::none_of(graph.meshes.begin(), graph.meshes.end(), has_backlash)) return graph;
  double change = kInfinity;
  std::size_t mounted = 0;
  for (int pass = 0; pass < kPasses && change > kClose; ++pass) {
    const DriveGeometry made = drive_geometry(graph);
    std::vector<MeshThinning> needed;
    for (std::size_t m = 0; m < graph.meshes.size(); ++m)
      if (const auto mesh = needed_thinning(graph, made, m)) needed.push_back(*mesh);
    if (needed.size() < mounted) return graph;  // some teeth cannot be made thin enough
    mounted = needed.size();
    const auto thinning = divided(graph, std::move(needed));
    change = 0.0;
    for (std::size_t g = 0; g < thinning.size(); ++g) {
      if (!thinning[g]) continue;
      double& own = graph.gears[g].thickness_allowance();
      change = std::max(change, std::abs(-*thinning[g] - own));
      own = -*thinning[g];
    }
  }
  return graph;
}

}  // namespace gearwright
