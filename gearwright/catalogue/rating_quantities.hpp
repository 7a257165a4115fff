// The quantities of a strength rating: `rating` of a result.
//
// A factor is described once, with its member of the rating. All interfaces take value, formula
// number and branch from there.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "gearwright/catalogue/quantity.hpp"
#include "gearwright/rating/spectrum.hpp"

namespace gearwright {

/// Tooth contact under load in addition to the standard, over all positions.
struct ToothContact {
  double torque;                      ///< T_1 K_A K_γ K_v  N m, on gear 1
  double pressure;                    ///< p_H  N/mm², the greatest
  std::array<double, 2> root_stress;  ///< N/mm², the greatest principal stress
  double face_load_factor;            ///< K_Hβ of the line load
};

struct RatingView {
  RatedPair pair;
  RatingInput input;
  Rating rating;
  std::optional<SpectrumRating> spectrum;
  std::optional<double> torque_holding;  ///< N m, the greatest with the required safeties
  std::optional<double> face_holding;    ///< mm, the least common face width with them
  std::optional<ToothContact> contact;   ///< if the spec requests it
};

const Quantities<RatingView>& rating_quantities();

/// The clause of a factor in the standard, and the branch that was used; for gear 1 and gear 2 if
/// the branches differ.
struct FactorSource {
  std::string key, formula;
  std::vector<std::string> branches;
};
std::vector<FactorSource> factor_sources(const Rating& rating);

/// "ISO 6336-1, 6.5.4, (13), (14): subcritical, N ≤ 0.85"; empty for a key that is not a factor.
std::string source_text(const Rating& rating, std::string_view key);

}  // namespace gearwright
