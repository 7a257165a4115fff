// The questions the other way round: which torque, which face width, which steel makes a pair hold.
//
// Load factors change with the load and with the face, so nothing here is a formula: the rating
// itself is asked, in a bracket, and what is answered has been rated.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "gearwright/rating/rating.hpp"

namespace gearwright {

struct WantedSafety {
  double flank = 1.0;  ///< S_Hmin
  double root = 1.0;   ///< S_Fmin
};

/// Both gears are as safe as wanted, flank and root.
bool holds(const Rating& rating, const WantedSafety& wanted);

/// The greatest torque on gear 1 with the wanted safeties, N m, to 1e-9 of it; none: no torque has
/// them within 1e-6 to 1e6 times that of the input.
///
/// Law  safeties fall with the torque
std::optional<double> torque_of_safety(const RatedPair& pair, const RatingInput& input,
                                       const WantedSafety& wanted);

/// The same pair with another common face width, mm: its overlap follows.
RatedPair with_face_width(RatedPair pair, double face_width);

/// Wider faces than this, in modules, nobody cuts: where the search for one ends.
constexpr double kMostFaceModules = 40.0;

/// The least common face width with the wanted safeties, mm, to 1e-7 of it and rated; none: no width
/// from one module up to `most` has them. Safeties fall where a tolerance comes to its next step:
/// ranges of widths narrower than 1e-4 of the width are passed over.
std::optional<double> face_width_of_safety(const RatedPair& pair, const RatingInput& input,
                                           const WantedSafety& wanted, double most);

/// Steels of the shipped table that a gear may be made of instead, the least strong first.
inline constexpr std::array<std::string_view, 4> kSteelsByStrength{"42CrMo4", "34CrNiMo6",
                                                                   "31CrMoV9", "17CrNiMo6"};

/// A steel of the shipped table for the gears that fall short, the least strong that is enough.
std::optional<std::string> steel_of_safety(const RatedPair& pair, const RatingInput& input,
                                           const WantedSafety& wanted);

}  // namespace gearwright
