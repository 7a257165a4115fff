#include "gearwright/drive/drive_rating.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "gearwright/base/contract.hpp"
#include "gearwright/base/numbers.hpp"

namespace gearwright {

namespace {

bool carries(const Drive& drive, std::size_t mesh) { return drive.flow->driver[mesh] >= 0; }

bool drives(const Drive& drive, std::size_t mesh, int side) {
  return drive.flow->driver[mesh] == side;
}

RatingInput of_gear_use(RatingInput input, const FlankUse& use) {
  if (input.life_h) *input.life_h *= use.engagements;
  input.reversed = input.reversed || use.both;
  return input;
}

// Combines the values of gear 1 from `one` and of gear 2 from `two`. All other values are the same
// in both ratings.
Rating joined(Rating one, const Rating& two) {
  for (FactorPair Rating::*pair :
       {&Rating::Z_B,      &Rating::Z_NT,     &Rating::Z_L_at_N,     &Rating::Z_v_at_N,
        &Rating::Z_R_at_N, &Rating::Z_W,      &Rating::Z_X,          &Rating::sigma_H,
        &Rating::sigma_HG, &Rating::S_H,      &Rating::Y_F,          &Rating::Y_S,
        &Rating::Y_beta,   &Rating::Y_B,      &Rating::Y_DT,         &Rating::Y_ST,
        &Rating::Y_M,      &Rating::Y_NT,     &Rating::Y_delta_relT, &Rating::Y_R_relT,
        &Rating::Y_X,      &Rating::sigma_F0, &Rating::sigma_F,      &Rating::sigma_FG,
        &Rating::S_F})
    (one.*pair)[1] = (two.*pair)[1];
  one.N_L[1] = two.N_L[1];
  return one;
}

}  // namespace

FlankUse flank_use(const Drive& drive, std::size_t mesh, int side) {
  GW_EXPECTS(drive.flow && !drive.flow->self_locking());
  const DriveGraph& graph = drive.graph;
  const std::size_t gear = graph.meshes[mesh].gears[static_cast<std::size_t>(side)];
  const bool rides = graph.body(graph.gears[gear]).carrier.has_value();
  FlankUse use;
  for (std::size_t m = 0; m < graph.meshes.size(); ++m) {
    for (const int s : {0, 1}) {
      if (graph.meshes[m].gears[static_cast<std::size_t>(s)] != gear || !carries(drive, m))
        continue;
      if (drives(drive, m, s) == drives(drive, mesh, side)) {
        use.engagements += rides ? 1 : graph.copies(graph.meshes[m]);
      } else {
        use.both = true;
      }
    }
  }
  return use;
}

RatingInput mesh_load(const Drive& drive, std::size_t mesh, const DriveLoad& load) {
  GW_EXPECTS(drive.flow && !drive.flow->self_locking() && load.torque > 0.0);
  const DriveMesh& m = drive.graph.meshes[mesh];
  const DriveGear& one = drive.graph.gear(m, 0);
  RatingInput input = load.common;
  const int n = drive.graph.copies(m);
  input.torque = std::abs(one.factor() * drive.flow->load[mesh]) * load.torque / n;
  if (!load.mesh_load_factors.empty()) input.mesh_load_factor = load.mesh_load_factors[mesh];
  if (n == 1) input.mesh_load_factor = 1.0;
  if (load.speed) {
    const auto own = drive.speed_ratio(one.body);
    const auto frame = drive.graph.frame(m);
    const auto carrier = frame ? drive.speed_ratio(*frame) : std::optional(0.0);
    if (own && carrier) input.speed = std::abs((*own - *carrier) * *load.speed);
  }
  return input;
}

Result<std::vector<std::optional<MeshRating>>> rate_meshes(const Drive& drive,
                                                           const DriveLoad& load,
                                                           const GearMaterials& material) {
  const auto& pairs = drive.geometry.pairs;
  const auto arcs =
      std::find_if(pairs.begin(), pairs.end(), [](const auto& p) { return p && p->arcs(); });
  if (arcs != pairs.end()) {
    const auto mesh = static_cast<std::size_t>(arcs - pairs.begin());
    return Error{"drive.mesh", drive.graph.meshes[mesh].name,
                 "has circular-arc teeth, but ISO 6336 rates involute teeth only"};
  }
  if (!drive.flow || drive.flow->self_locking())
    return Error{"drive.mesh", "",
                 drive.flow
                     ? "cannot be rated, because the drive is self-locking and transmits no power"
                     : "has no torque, because the drive has no efficiency, geometry or speed, or "
                       "because its meshes are redundant"};
  std::vector<std::optional<MeshRating>> ratings(drive.graph.meshes.size());
  for (std::size_t m = 0; m < ratings.size(); ++m) {
    const auto& pair = drive.geometry.pairs[m];
    if (!carries(drive, m) || !drive.geometry.involutes(m)) continue;
    const auto of_mesh = [&](Error error) {
      error.rule = fmt::format("{} (mesh {})", error.rule, drive.graph.meshes[m].name);
      return error;
    };
    auto rated = rated_pair(*pair);
    if (!rated) return of_mesh(rated.error());
    MeshRating made;
    made.pair = *rated;
    if (pair->gear(1).gap) made.pair.halves = 2;
    made.input = mesh_load(drive, m, load);
    for (const std::size_t i : {0, 1}) {
      auto steel = material(drive.graph.meshes[m].gears[i]);
      if (!steel) return steel.error();
      made.input.materials[i] = std::move(steel).take();
    }
    const std::array<FlankUse, 2> use{flank_use(drive, m, 0), flank_use(drive, m, 1)};
    auto one = rate(made.pair, of_gear_use(made.input, use[0]));
    auto two = rate(made.pair, of_gear_use(made.input, use[1]));
    if (!one) return of_mesh(one.error());
    if (!two) return of_mesh(two.error());
    made.rating = joined(std::move(one).take(), *two);
    if (drive.graph.copies(drive.graph.meshes[m]) > 1) {
      if (load.factor_origin) made.rating.K_gamma.branch = load.factor_origin;
      if (!load.factor_origin && made.input.mesh_load_factor == 1.0)
        made.rating.K_gamma.branch = "planets that carry equal loads";
    }
    made.engagements = {use[0].engagements, use[1].engagements};
    ratings[m] = std::move(made);
  }
  return ratings;
}

bool rates_equal_shares(const Drive& drive) {
  bool several = false;
  for (std::size_t m = 0; m < drive.ratings.size(); ++m) {
    if (!drive.ratings[m] || drive.graph.copies(drive.graph.meshes[m]) == 1) continue;
    if (drive.ratings[m]->input.mesh_load_factor != 1.0) return false;
    several = true;
  }
  return several && !drive.loaded;
}

std::optional<double> least_safety(const Drive& drive, FactorPair Rating::*safety) {
  std::optional<double> least;
  for (const auto& r : drive.ratings) {
    if (!r) continue;
    const auto& [one, two] = r->rating.*safety;
    const double s = std::min(one.value, two.value);
    least = std::min(least.value_or(s), s);
  }
  return least;
}

std::optional<double> greatest_sliding(const DriveGeometry& geometry) {
  std::optional<double> most;
  for (const auto& pair : geometry.pairs) {
    const InvolutePair* involute = pair ? pair->involute() : nullptr;
    if (!involute) continue;
    const auto &a = involute->sliding_A, &e = involute->sliding_E;
    for (const auto& zeta : {a.zeta_1, a.zeta_2, e.zeta_1, e.zeta_2})
      most = std::max(most.value_or(0.0), std::abs(zeta.value_or(kInfinity)));
  }
  return most;
}

}  // namespace gearwright
