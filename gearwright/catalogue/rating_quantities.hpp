// The quantities of a strength rating: `rating` of a result.
//
// A factor is said once, with where it stands in the rating; value, formula number and branch are
// taken from there by every door.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "gearwright/catalogue/quantity.hpp"
#include "gearwright/rating/spectrum.hpp"

namespace gearwright {

/// What the teeth themselves bear beside the standard: loaded tooth contact, over all positions.
struct ToothContact {
  double torque;                      ///< T_1 K_A K_γ K_v  N m, which lies on gear 1
  double pressure;                    ///< p_H  N/mm², the greatest
  std::array<double, 2> root_stress;  ///< N/mm², the greatest principal stress
  double face_load_factor;            ///< K_Hβ of the line load
};

struct RatingView {
  const RatingInput& input;
  const Rating& rating;
  double power_kW;               ///< 0: without a speed
  std::array<double, 2> torque;  ///< N m
  std::array<double, 2> speed;   ///< 1/min, 0: not given
  std::optional<SpectrumRating> spectrum;
  std::optional<double> torque_holding;  ///< N m
  std::optional<double> face_holding;    ///< mm
  std::optional<ToothContact> contact;
};

const Quantities<RatingView>& rating_quantities();

/// Where a factor stands in the standard, and the branch that was taken; of gear 1 and gear 2 where
/// the branches differ.
struct FactorSource {
  std::string key, formula;
  std::vector<std::string> branches;
};
std::vector<FactorSource> factor_sources(const Rating& rating);

/// "ISO 6336-1, 6.5.4, (13), (14): subcritical, N ≤ 0.85"; empty for a key that is no factor.
std::string source_text(const Rating& rating, std::string_view key);

}  // namespace gearwright
