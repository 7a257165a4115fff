// Computes the peak to peak, the harmonics, the stiffness and the extremes of the positions under
// one torque. A score contains a few of these values, by which pairs are compared.
//                                    theory: docs/theory/12-loaded-contact.md
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "gearwright/load/loaded_contact.hpp"

namespace gearwright {

/// The values of ISO 6336 for the analysed pair under one torque.
struct LoadStandard {
  double stiffness = 0.0;  ///< c_γα  N/(mm µm)
  /// σ_F0 of each gear, MPa: F_t/(b m_n) Y_F Y_S Y_β; none if a gear has no critical section.
  std::optional<std::array<double, 2>> root_stress{};
  double low_load = 1.0;  ///< c_γα at 100 N/mm divided by `stiffness`, but at least 1
};

struct SummaryBasis {
  double face;         ///< b  mm, common face width
  double base_radius;  ///< r_b1  mm
  double body_twist;   ///< approach due to the twist of both gear bodies, mm per N/mm of line load
  bool whole_pitch;    ///< true if the positions are evenly spaced over one pitch
  LoadRegime regime;   ///< for point contact, only `whole_pitch` is used
};

/// Computes the members that follow from `torque.torque` and `torque.positions`.
void summarise(LoadedTorque& torque, const SummaryBasis& basis);

/// Returns the amplitudes of the loaded TE at orders of the mesh frequency from 1 to at most 20.
///
/// Domain    solved positions, evenly spaced over one pitch
std::vector<Angle> harmonics(const std::vector<LoadedPosition>& positions);

/// Returns the peak-to-peak transmission error under load along the line of action, mm. It is the
/// rotation of gear 2 times r_b2.
///
/// Domain    LoadRegime::line
double peak_to_peak_on_line(const LoadedTorque& torque, const Gear& gear_2);

/// Returns the load share of a tooth pair at one position, summed over the places where it touches.
double share_of(const LoadedPosition& position, int pair);

/// Returns, of all torques with harmonics, the one with the least peak-to-peak loaded transmission
/// error. Returns nullptr if there are fewer than two torques or if no torque has harmonics.
const LoadedTorque* quietest(const LoadedContact& contact);

/// The loaded contact under one torque in a few numbers. Without a result, the numbers are NaN, and
/// face_load_factor is absent.
struct LoadedScore {
  Angle peak_to_peak;                        ///< peak to peak of the loaded transmission error
  double max_pressure = 0.0;                 ///< MPa
  std::optional<double> face_load_factor{};  ///< K_Hβ, for line contact only
  bool edge_carries = false;
};

/// Returns one score for each torque. The list is empty if there is a position at which no teeth
/// touch or the search does not converge. It is also empty if the slices are too fine for the
/// contact.
std::vector<LoadedScore> loaded_scores(const LoadedContact& contact);

LoadedScore no_score();
/// Returns the score in which each member is the worse of the two values in `a` and `b`. NaN is
/// worse than any number. `face_load_factor` is absent unless both scores have it.
LoadedScore worse_of(const LoadedScore& a, const LoadedScore& b);

/// The effect of corrections under a torque. A score has the worst values over all scenarios.
struct AimedLoad {
  double torque;  ///< N mm, on gear 1
  LoadedScore before, after;
};

}  // namespace gearwright
