// Teeth under load as their figures take them, and what these have in common.
//
//   T     torque on gear 1, N mm
//   TE    loaded transmission error, rad
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "gearwright/figure/figure.hpp"
#include "gearwright/load/load_summary.hpp"
#include "gearwright/pair/pair.hpp"

namespace gearwright {

struct LoadScene {
  std::array<const Gear*, 2> gears{};
  const ParallelPair* pair = nullptr;  ///< that turns under the slider; null: teeth touch at points
  bool gear2_drives = false;
  LoadedContact contact;               ///< positions evenly over one pitch, from −half a pitch on
  std::vector<LoadStandard> standard;  ///< at each torque; may be empty
  std::optional<std::size_t> chosen = {};  ///< torque whose fields are drawn; none: the greatest
};

/// The torques that pictures and tables show, by their place in the contact: all, or of many so many
/// as curves can be told apart, the first and the last among them.
std::vector<std::size_t> shown_torques(const LoadScene& scene);
/// The torque whose pressures and stresses are drawn.
const LoadedTorque& shown_torque(const LoadScene& scene);
/// "250 N m"
std::string torque_words(const LoadedTorque& torque);

/// Colours of curves, for as many torques as are shown.
std::string curve_style(std::size_t i);
std::vector<FigureKey> torque_keys(const LoadScene& scene);

/// The pitch of gear 1, rad; how far a tooth pair is through its mesh at a position, in pitches.
double pitch_of(const LoadScene& scene);
double own_pitches(const LoadScene& scene, const LoadedPosition& at, const LoadedPair& pair);

/// A position for each frame of a figure, by its number in the contact: of many so many as the eye
/// can tell apart, from where gear 1 is not turned.
std::vector<std::size_t> frame_positions(const LoadScene& scene);

/// Places of the slices along the face of gear `which` (0, 1), mm.
std::vector<double> heights_of(const LoadScene& scene, std::size_t which);

}  // namespace gearwright
