// Finds the torque, the face width or the steel with which the safety factors are sufficient.
//
// Load factors depend on the load and on the face width, so there is no closed form. The functions
// rate the pair repeatedly within a bracket. Each returned value has itself been rated.
//
// If there is a load spectrum, its safety factors are used instead of those of the single load.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "gearwright/rating/rating.hpp"
#include "gearwright/rating/spectrum.hpp"

namespace gearwright {

/// Either the required safeties S_Hmin and S_Fmin, or the safeties S_H and S_F of a pair, which are
/// the smaller values of its two gears.
struct Safeties {
  double flank = 1.0, root = 1.0;
};

bool holds(const Safeties& found, const Safeties& wanted);

/// A rating, with all inputs that are needed to rate the gears again.
struct PairRating {
  RatedPair pair{};
  RatingInput input{};
  Rating rating{};
  Safeties wanted{};             ///< required safety factors
  std::vector<LoadBin> steps{};  ///< of the load spectrum, with K_Hβ if it is computed
  std::optional<SpectrumRating> spectrum{};
};

/// True if flank and root of both gears have the required safety factors.
bool holds(const Rating& rating, const Safeties& wanted);

/// Returns the greatest torque on gear 1 with the required safety factors, N m. Returns none if
/// there is no such torque between 1e-6 and 1e6 times the torque of the input. With a spectrum, the
/// torques of all steps are multiplied by the same factor, and the result is the greatest of them.
///
/// Accuracy  1e-9, relative
/// Laws      (1) safety factors decrease as the torque increases
///           (2) a spectrum of one step has the result of a single load with K_A = 1 and the life
///               of this step; this law also applies to face_width_of_safety()
std::optional<double> torque_of_safety(const RatedPair& pair, const RatingInput& input,
                                       const Safeties& wanted,
                                       const std::vector<LoadBin>& spectrum = {});
/// Returns the pair with another common face width, mm, and the corresponding overlap ratio.
RatedPair with_face_width(RatedPair pair, double face_width);

/// The greatest face width of the search, in modules.
constexpr double kMostFaceModules = 40.0;

/// Returns the least common face width with the required safety factors, mm. Returns none if there
/// is no such width from one module up to `most`.
///
/// Accuracy  1e-7, relative. Safety factors decrease where a tolerance reaches its next step, so
///           the sufficient widths may form several ranges. A range narrower than 1e-4 of the width
///           may be missed
std::optional<double> face_width_of_safety(const RatedPair& pair, const RatingInput& input,
                                           const Safeties& wanted, double most,
                                           const std::vector<LoadBin>& spectrum = {});
/// Alternative steels of the table, the weakest first.
inline constexpr std::array<std::string_view, 4> kSteelsByStrength{"42CrMo4", "34CrNiMo6",
                                                                   "31CrMoV9", "17CrNiMo6"};
/// Returns the weakest of these steels that makes the safety factors sufficient if it replaces the
/// material of the gears whose safety factors are too low. Returns none if there is no such steel,
/// if the pair cannot be rated, or for a rating of plastics.
std::optional<std::string> steel_of_safety(const RatedPair& pair, const RatingInput& input,
                                           const Safeties& wanted,
                                           const std::vector<LoadBin>& spectrum = {});

}  // namespace gearwright
