#include "gearwright/load/unloaded_tips.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "gearwright/base/contract.hpp"
#include "gearwright/base/numbers.hpp"
#include "gearwright/base/parallel.hpp"
#include "gearwright/load/loaded_position.hpp"
#include "gearwright/math/involute.hpp"

namespace gearwright {

namespace {

using detail::Position;
using detail::PositionSolver;

constexpr int kHeights = 8;      // points along the face at which a tip is examined
constexpr int kMostTurns = 30;   // limit of iterations, each of which at least halves the error
constexpr double kClose = 5e-6;  // mm: tolerance of a relief; reliefs are made in whole µm
// Greatest relief that is tried, in modules. It is less than kFarGap, because the contact problem
// does not include places with a wider gap.
constexpr double kGreatest = 1.0 / 40;

// The equation ρ_1 = a + r_b1 φ + c z of the contact of tooth pair 0, with z and φ in the frame N.
struct PathPlace {
  double a = 0.0, c = 0.0, base_radius = 0.0;

  double rotation(double rho1, double z) const { return (rho1 - a - c * z) / base_radius; }
};

// Fits a and c to the places of least gap by least squares. The equation is exact for involutes.
PathPlace path_place(const Position& at, const FaceSlices& slices, double base_radius) {
  double n = 0.0;
  double z1 = 0.0;
  double zz = 0.0;
  double y1 = 0.0;
  double zy = 0.0;
  for (const PairPlaces& p : at.pairs) {
    for (int j = 0; j < slices.count; ++j) {
      const auto& place = p.at[static_cast<std::size_t>(j)];
      if (!place || place->kind != TouchKind::line) continue;
      const double z = slices.middle(j);
      const double y = roll_length(place->radius[0], base_radius) - base_radius * p.turn;
      n += 1.0;
      z1 += z;
      zz += z * z;
      y1 += y;
      zy += z * y;
    }
  }
  GW_EXPECTS(n > 0.0);
  const double spread = n * zz - z1 * z1;
  const double c = spread > 1e-9 * n * zz ? (n * zy - z1 * y1) / spread : 0.0;
  return {(y1 - c * z1) / n, c, base_radius};
}

// A place at which the tip of a gear begins or ends contact.
struct TipPlace {
  std::size_t gear;
  int slice;
  double rotation;
};

std::vector<TipPlace> tip_places(const PathPlace& path, const TipPath& ends,
                                 const FaceSlices& slices, bool alike) {
  std::vector<TipPlace> list;
  const int count = alike ? 1 : std::min(kHeights, slices.count);
  for (int k = 0; k < count; ++k) {
    const int j = count == 1 ? slices.count / 2 : k * (slices.count - 1) / (count - 1);
    list.push_back({1, j, path.rotation(ends.begin, slices.middle(j))});
    list.push_back({0, j, path.rotation(ends.end, slices.middle(j))});
  }
  return list;
}

// Returns the distance s between tip and flank at a place. It is 0 if the place carries load, and
// none if the forces do not converge.
std::optional<double> distance_at(PositionSolver& solver, const TipPlace& tip, double moment) {
  Position at = solver.prepare(tip.rotation);
  if (at.rows.empty()) return kInfinity;
  at.problem.moment = moment;
  const ContactSolution x = solve_contact(at.problem);
  if (!x.found()) return std::nullopt;
  for (std::size_t i = 0; i < at.rows.size(); ++i) {
    const auto [pair, slice] = at.rows[i];
    if (at.pairs[static_cast<std::size_t>(pair)].pair != 0 || slice != tip.slice) continue;
    const auto k = static_cast<Eigen::Index>(i);
    if (x.line_load[k] > 0.0) return 0.0;
    return at.problem.yield->row(k).dot(x.line_load) + at.problem.gap[k] -
           x.approach * at.problem.arm[k];
  }
  return kInfinity;
}

// Returns the helix modifications of the flanks, combined with these tip reliefs.
PairModifications with_reliefs(const PairModifications& all, const std::array<double, 2>& amount,
                               const TipPath& path) {
  PairModifications made;
  for (std::size_t g = 0; g < 2; ++g) {
    for (std::size_t side = 0; side < 2; ++side) {
      FlankModifications& flank = made[g][side];
      flank.tip_relief = {amount[g], path.start_diameter[g], ReliefShape::linear};
      flank.lead_crowning = all[g][side].lead_crowning;
      flank.lead_slope = all[g][side].lead_slope;
      flank.end_relief = all[g][side].end_relief;
    }
  }
  return made;
}

// True if all sections of the face have the same contact, so that one section is sufficient.
bool alike_sections(const ContactSetup& setup, const LoadRequest& request) {
  const auto plain = [](const FlankModifications& m) {
    return m.lead_crowning == 0.0 && m.lead_slope == 0.0 && m.end_relief.amount == 0.0;
  };
  bool alike = setup.gear(1).spec.helix_angle.rad() == 0.0 &&
               setup.place().errors == ContactErrors() && !request.deflects();
  for (const auto& gear : setup.modifications())
    alike = alike && std::all_of(gear.begin(), gear.end(), plain);
  return alike;
}

}  // namespace

Result<UnloadedTips> unloaded_tips(const ContactSetup& setup, const TipPath& path,
                                   const PairCompliance& compliance, const LoadRequest& request,
                                   bool gear2_drives) {
  GW_EXPECTS(request.regime == LoadRegime::line && !request.torques.empty());
  const Gear& one = setup.gear(1);
  const Gear& two = setup.gear(2);
  const double torque = *std::max_element(request.torques.begin(), request.torques.end());
  const double moment = torque * std::abs(double(two.spec.teeth) / one.spec.teeth);
  const auto plain = setup.with_modifications({});
  if (!plain) return plain.error();
  std::vector<TipPlace> tips;
  {
    const ContactPair pair = plain->pair(ContactErrors(), gear2_drives);
    const LoadRequest aligned = request.undeflected();
    PositionSolver solver(pair, one, two, compliance, aligned);
    tips = tip_places(path_place(solver.prepare(0.0), compliance.slices[0], one.base_radius()),
                      path, compliance.slices[0], alike_sections(setup, request));
  }
  // The iteration starts with reliefs that are usually so great that no tip carries load. Each
  // iteration reduces the relief of a gear by the least distance that remains at its tips. With
  // less relief, the load is spread over more teeth, so the distance decreases by less than the
  // relief. The reliefs therefore approach the least possible reliefs from above.
  const double greatest = kGreatest * one.spec.normal_module;
  UnloadedTips found;
  found.amount = {greatest, greatest};
  for (int turn = 1; turn <= kMostTurns; ++turn) {
    const auto relieved =
        setup.with_modifications(with_reliefs(setup.modifications(), found.amount, path));
    if (!relieved) return relieved.error();
    const ContactPair pair = relieved->pair(gear2_drives);
    std::vector<std::optional<double>> distance(tips.size());
    parallel_for(tips.size(), [&](std::size_t i) {
      PositionSolver solver(pair, one, two, compliance, request);
      distance[i] = distance_at(solver, tips[i], moment);
    });
    std::array<std::optional<double>, 2> least{kInfinity, kInfinity};
    // If the forces at a place do not converge, the least distance of its gear stays unknown,
    // because an empty std::optional is less than every number.
    for (std::size_t i = 0; i < tips.size(); ++i) {
      auto& known = least[tips[i].gear];
      if (distance[i] < known) known = distance[i];
    }
    bool still = true;
    for (std::size_t g = 0; g < 2; ++g) {
      if (turn == 1) found.unloaded[g] = least[g] > 0.0;
      if (!found.unloaded[g] || !(least[g] > kClose) || *least[g] == kInfinity) continue;
      found.amount[g] = std::max(0.0, found.amount[g] - *least[g]);
      still = false;
    }
    if (still) break;
  }
  return found;
}

}  // namespace gearwright
