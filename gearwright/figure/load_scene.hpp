// Contains the data of the figures under load, and functions that these figures share.
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
  const ParallelPair* pair = nullptr;  ///< the pair that turns; null if teeth touch at points
  bool gear2_drives = false;
  LoadedContact contact;               ///< positions evenly spaced over one pitch, from −½ pitch
  std::vector<LoadStandard> standard;  ///< results of the standard at each torque; may be empty
  std::optional<std::size_t> chosen = {};  ///< index of the shown torque; by default the greatest
  /// Suffix of the ids of figures. It is "-2" for the second half of a double-helical pair,
  /// otherwise empty.
  std::string part{};
  /// The halves of a double-helical pair at z > 0 and at z < 0, or only one half if they are
  /// mirror images. For such a pair, the other members describe the whole gears.
  std::vector<LoadScene> halves{};
};

/// Returns the torques that pictures and tables show, as indices of `contact.torques`. If there are
/// too many torques to distinguish, returns a selection that includes the first and the last.
std::vector<std::size_t> shown_torques(const LoadScene& scene);
const LoadedTorque& shown_torque(const LoadScene& scene);
std::string torque_words(const LoadedTorque& torque);

/// Return the style of curve i of the shown torques, and the keys of all these curves.
std::string curve_style(std::size_t i);
std::vector<FigureKey> torque_keys(const LoadScene& scene);

/// Return the pitch of gear 1, rad, and the rotation of a tooth pair from the centre line at a
/// position, in pitches.
double pitch_of(const LoadScene& scene);
double own_pitches(const LoadScene& scene, const LoadedPosition& at, const LoadedPair& pair);

/// Returns the positions of the frames of a figure, as indices of LoadedTorque::positions, starting
/// at rotation 0 of gear 1. If there are many positions, only as many are used as can be
/// distinguished.
std::vector<std::size_t> frame_positions(const LoadScene& scene);

/// Returns the positions of the slices along the face of gear `which` (0, 1), mm.
std::vector<double> heights_of(const LoadScene& scene, std::size_t which);

}  // namespace gearwright
