// Teeth under a torque in a few numbers, for those who compare one pair with another.
#pragma once

#include <optional>
#include <vector>

#include "gearwright/load/loaded_contact.hpp"

namespace gearwright {

/// NaN where there is no answer to compare with.
struct LoadedScore {
  Angle peak_to_peak;                        ///< of the loaded transmission error
  double max_pressure = 0.0;                 ///< MPa
  std::optional<double> face_load_factor{};  ///< K_Hβ, of lines
  bool edge_carries = false;
};

/// One for each torque; none where at a position nothing touches, a position came to no end, or the
/// slices are too fine for the contact.
std::vector<LoadedScore> loaded_scores(const LoadedContact& contact);

/// That of none.
LoadedScore no_score();
/// The worst of both, number by number; NaN stays.
LoadedScore worse_of(const LoadedScore& a, const LoadedScore& b);

/// What corrections do under a torque: the worst over all scenarios, number by number.
struct AimedLoad {
  double torque;  ///< N mm
  LoadedScore before, after;
};

}  // namespace gearwright
