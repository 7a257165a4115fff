// Inverse problems of the rating: the torque, the face width or the steel with sufficient safety.
//
// Load factors depend on the load and on the face width, so there is no closed form. The functions
// evaluate the rating within a bracket, and every result has been rated.
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

/// True if flank and root of both gears have the required safety.
bool holds(const Rating& rating, const WantedSafety& wanted);

/// The greatest torque on gear 1 with the required safeties, N m, to 1e-9 of it; none if no torque
/// between 1e-6 and 1e6 times that of the input has them.
///
/// Law  safeties fall with the torque
std::optional<double> torque_of_safety(const RatedPair& pair, const RatingInput& input,
                                       const WantedSafety& wanted);

/// The same pair with another common face width, mm, and its overlap ratio.
RatedPair with_face_width(RatedPair pair, double face_width);

/// The greatest face width of the search, in modules.
constexpr double kMostFaceModules = 40.0;

/// The least common face width with the required safeties, mm, to 1e-7 of it and rated; none if no
/// width from one module up to `most` has them. Safeties decrease where a tolerance reaches its
/// next step, and ranges of widths narrower than 1e-4 of the width are skipped.
std::optional<double> face_width_of_safety(const RatedPair& pair, const RatingInput& input,
                                           const WantedSafety& wanted, double most);

/// Alternative steels of the table, the least strong first.
inline constexpr std::array<std::string_view, 4> kSteelsByStrength{"42CrMo4", "34CrNiMo6",
                                                                   "31CrMoV9", "17CrNiMo6"};

/// The least strong steel of the table that is sufficient for the gears with insufficient safety.
std::optional<std::string> steel_of_safety(const RatedPair& pair, const RatingInput& input,
                                           const WantedSafety& wanted);

}  // namespace gearwright
