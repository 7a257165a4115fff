#include "gearwright/load/loaded_score.hpp"

#include <algorithm>
#include <cmath>

#include "gearwright/base/numbers.hpp"

namespace gearwright {

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
