#include "gearwright/load/load_summary.hpp"

#include <algorithm>
#include <cmath>

#include "gearwright/base/numbers.hpp"
#include "gearwright/base/units.hpp"
#include "gearwright/contact/contact.hpp"

namespace gearwright {

namespace {

using Solved = std::vector<const LoadedPosition*>;

// Returns the mean, least and greatest stiffness (load divided by approach), in N/(mm µm) for a
// line load or N/µm for a force. `yield` returns the approach at a position. The mean stiffness is
// `load` divided by the mean of `yield`.
template <class Yield>
LoadedTorque::Stiffness stiffness(const Solved& positions, double load, Yield yield) {
  double sum = 0.0;
  double least = kInfinity;
  double greatest = 0.0;
  for (const LoadedPosition* p : positions) {
    const double u = yield(*p) / kMmPerUm;
    sum += u;
    least = std::min(least, u);
    greatest = std::max(greatest, u);
  }
  const auto n = static_cast<double>(positions.size());
  return {load / (sum / n), load / greatest, load / least};
}

void summarise_lines(LoadedTorque& t, const Solved& solved, const SummaryBasis& basis) {
  const double force = t.torque / basis.base_radius;
  const double line_load = force / basis.face;
  for (LoadedPosition& p : t.positions)
    if (p.approach > 0.0) p.stiffness = line_load / (p.approach / kMmPerUm);
  t.stiffness = stiffness(solved, line_load, [](const auto& p) { return p.approach; });
  t.without_twist = stiffness(
      solved, line_load, [&](const auto& p) { return p.approach - line_load * basis.body_twist; });
  t.tangent = stiffness(solved, line_load, [&](const auto& p) { return p.tangent * force; });
  if (t.face_load.size() > 0) t.face_load_factor = t.face_load.maxCoeff() / t.face_load.mean();
}

void summarise_points(LoadedTorque& t, const Solved& solved) {
  for (LoadedPosition& p : t.positions)
    if (p.approach > 0.0) p.stiffness = p.force / (p.approach / kMmPerUm);
  // The force differs between positions, so each approach is divided by the force at its position.
  t.stiffness = stiffness(solved, 1.0, [](const auto& p) { return p.approach / p.force; });
  t.tangent = stiffness(solved, 1.0, [](const auto& p) { return p.tangent; });
}

}  // namespace

std::vector<Angle> harmonics(const std::vector<LoadedPosition>& positions) {
  std::vector<double> te;
  for (const LoadedPosition& p : positions) te.push_back(p.te.rad());
  return harmonics(te);
}

double peak_to_peak_on_line(const LoadedTorque& torque, const Gear& gear_2) {
  return torque.peak_to_peak.rad() * gear_2.base_radius();
}

double share_of(const LoadedPosition& p, int pair) {
  double sum = 0.0;
  for (const LoadedPair& k : p.pairs)
    if (k.pair == pair) sum += k.share;
  return sum;
}

void summarise(LoadedTorque& t, const SummaryBasis& basis) {
  Solved solved;
  for (const LoadedPosition& p : t.positions)
    if (p.solved()) solved.push_back(&p);
  if (solved.empty()) return;
  if (basis.whole_pitch && solved.size() == t.positions.size())
    t.harmonics = harmonics(t.positions);
  double least = kInfinity;
  double greatest = -kInfinity;
  t.max_pressure = t.max_width_ratio = 0.0;
  t.max_root_stress = {0.0, 0.0};
  for (const LoadedPosition* p : solved) {
    least = std::min(least, p->te.rad());
    greatest = std::max(greatest, p->te.rad());
    t.max_pressure = std::max(t.max_pressure, p->max_pressure);
    t.max_width_ratio = std::max(t.max_width_ratio, p->max_width_ratio);
    t.edge_carries = t.edge_carries || p->edge_carries;
    for (int g = 0; g < 2; ++g)
      t.max_root_stress[g] = std::max(t.max_root_stress[g], p->root_stress[g]);
    for (const LoadedPair& pair : p->pairs) {
      t.max_share = std::max(t.max_share, share_of(*p, pair.pair));
      t.beyond_flank = t.beyond_flank || pair.point.beyond;
      if (basis.regime == LoadRegime::point) continue;
      if (t.face_load.size() == 0) t.face_load = Eigen::VectorXd::Zero(pair.line_load.size());
      t.face_load += pair.line_load / static_cast<double>(solved.size());
    }
  }
  t.peak_to_peak = Angle::radians(greatest - least);
  basis.regime == LoadRegime::point ? summarise_points(t, solved)
                                    : summarise_lines(t, solved, basis);
}

const LoadedTorque* quietest(const LoadedContact& contact) {
  if (contact.torques.size() < 2) return nullptr;
  const LoadedTorque* quiet = nullptr;
  for (const LoadedTorque& t : contact.torques) {
    if (t.harmonics.empty()) continue;
    if (!quiet || t.peak_to_peak.rad() < quiet->peak_to_peak.rad()) quiet = &t;
  }
  return quiet;
}

std::vector<LoadedScore> loaded_scores(const LoadedContact& contact) {
  if (contact.slices_too_fine) return {};
  std::vector<LoadedScore> scores;
  for (const LoadedTorque& t : contact.torques) {
    if (!std::all_of(t.positions.begin(), t.positions.end(),
                     [](const LoadedPosition& p) { return p.solved(); }))
      return {};
    scores.push_back({t.peak_to_peak, t.max_pressure, std::nullopt, t.edge_carries});
    if (contact.regime == LoadRegime::line) scores.back().face_load_factor = t.face_load_factor;
  }
  return scores;
}

LoadedScore no_score() { return {Angle::radians(kNoNumber), kNoNumber, std::nullopt, false}; }

LoadedScore worse_of(const LoadedScore& a, const LoadedScore& b) {
  const auto worse = [](double x, double y) { return std::isnan(x) || x > y ? x : y; };
  LoadedScore s{Angle::radians(worse(a.peak_to_peak.rad(), b.peak_to_peak.rad())),
                worse(a.max_pressure, b.max_pressure), std::nullopt,
                a.edge_carries || b.edge_carries};
  if (a.face_load_factor && b.face_load_factor)
    s.face_load_factor = worse(*a.face_load_factor, *b.face_load_factor);
  return s;
}

}  // namespace gearwright
