// A few numbers of teeth under a torque, for comparing pairs.
#pragma once

#include <optional>
#include <vector>

#include "gearwright/load/loaded_contact.hpp"

namespace gearwright {

/// NaN if there is no result.
struct LoadedScore {
  Angle peak_to_peak;                        ///< of the loaded transmission error
  double max_pressure = 0.0;                 ///< MPa
  std::optional<double> face_load_factor{};  ///< K_Hβ, of lines
  bool edge_carries = false;
};

/// One for each torque; none if no teeth touch at a position, a position does not converge, or the
/// slices are too fine for the contact.
std::vector<LoadedScore> loaded_scores(const LoadedContact& contact);

/// The score if there is no result.
LoadedScore no_score();
/// The worse of both for each number; NaN is kept.
LoadedScore worse_of(const LoadedScore& a, const LoadedScore& b);

/// The effect of corrections under a torque: the worst of each number over all scenarios.
struct AimedLoad {
  double torque;  ///< N mm
  LoadedScore before, after;
};

}  // namespace gearwright
