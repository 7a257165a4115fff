// What the page tells about teeth under load, as plain data, and what its pictures have in common.
//
//   T     torque on gear 1, N mm
//   TE    loaded transmission error, rad
#pragma once

#include <array>
#include <string>
#include <vector>

#include "gearwright/load/load_summary.hpp"
#include "gearwright/pair/pair.hpp"
#include "gearwright/report/plot_axis.hpp"

namespace gearwright {

struct LoadReport {
  std::array<const Gear*, 2> gears{};
  const InvolutePair* pair = nullptr;  ///< that turns under the slider; null: teeth touch at points
  bool gear2_drives = false;
  LoadedContact contact;               ///< positions evenly over one pitch, from −half a pitch on
  std::vector<LoadStandard> standard;  ///< at each torque; may be empty
};

/// The torques that pictures and tables show, by their place in the contact: all, or of many so many
/// as curves can be told apart, the first and the last among them.
std::vector<std::size_t> shown_torques(const LoadReport& report);
/// The torque whose pressures and stresses are drawn: the greatest.
const LoadedTorque& heaviest(const LoadReport& report);
/// "250 N m"
std::string torque_words(const LoadedTorque& torque);

/// Colours of curves, for as many torques as are shown.
std::string curve_style(std::size_t i);
/// A caption's key to them (HTML).
std::string torque_keys(const LoadReport& report);

/// The pitch of gear 1, rad; how far a tooth pair is through its mesh at a position, in pitches.
double pitch_of(const LoadReport& report);
double own_pitches(const LoadReport& report, const LoadedPosition& at, const LoadedPair& pair);

/// A position for each place of the slider (report/turning.hpp), by its number in the contact: of
/// many so many as the eye can tell apart.
std::vector<std::size_t> slider_positions(const LoadReport& report);
/// The attributes of the group that is seen while the slider stands there: place k of n.
std::string frame_attributes(std::size_t k, std::size_t n);

/// Places of the slices along the face of gear `which` (0, 1), mm.
std::vector<double> heights_of(const LoadReport& report, std::size_t which);

}  // namespace gearwright
