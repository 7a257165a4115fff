// Extracts a few characteristic values from a loaded contact, to compare pairs.
#pragma once

#include <optional>
#include <vector>

#include "gearwright/load/loaded_contact.hpp"

namespace gearwright {

/// If a contact has no result, the numbers are NaN, and face_load_factor is absent.
struct LoadedScore {
  Angle peak_to_peak;                        ///< peak to peak of the loaded transmission error
  double max_pressure = 0.0;                 ///< MPa
  std::optional<double> face_load_factor{};  ///< K_Hβ, for line contact only
  bool edge_carries = false;
};

/// One score for each torque. The list is empty if no teeth touch at some position, if a position
/// does not converge, or if the slices are too fine for the contact.
std::vector<LoadedScore> loaded_scores(const LoadedContact& contact);

/// The score if there is no result.
LoadedScore no_score();
/// The score in which each member is the worse of the two values in `a` and `b`. NaN is worse than
/// any number.
LoadedScore worse_of(const LoadedScore& a, const LoadedScore& b);

/// The effect of corrections under a torque. Each member of a score is the worst value over all
/// scenarios.
struct AimedLoad {
  double torque;  ///< N mm, on gear 1
  LoadedScore before, after;
};

}  // namespace gearwright
