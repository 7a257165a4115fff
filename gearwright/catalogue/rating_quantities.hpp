// The quantities of a strength rating. A result contains them under `rating`.
//
// Each factor is described once, with its member of the rating. All interfaces use this description
// to show the value, the formula number and the branch.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "gearwright/catalogue/quantity.hpp"
#include "gearwright/rating/sizing.hpp"

namespace gearwright {

/// The computed tooth contact under load, over all positions. It supplements the standard's rating.
struct ToothContact {
  double torque;                      ///< T_1 K_A K_γ K_v  N m, on gear 1
  double pressure;                    ///< p_H  N/mm², greatest pressure
  std::array<double, 2> root_stress;  ///< N/mm², greatest principal stress at the root of each gear
  double face_load_factor;            ///< K_Hβ of the computed line load
};

struct RatingAnswer : PairRating {
  /// The greatest torque with the required safety factors, N m; under the spectrum, if there is one.
  std::optional<double> torque_holding{};
  /// The least common face width with the required safety factors, mm; none if K_Hβ is computed.
  std::optional<double> face_holding{};
  /// The computed tooth contact; none unless the spec requests this computation.
  std::optional<ToothContact> contact{};
};

const Quantities<RatingAnswer>& rating_quantities();

/// The clause of the standard for a factor, and the branch that was used. If gear 1 and gear 2 have
/// different branches, both are listed.
struct FactorSource {
  std::string key, formula;
  std::vector<std::string> branches;
};
std::vector<FactorSource> factor_sources(const Rating& rating);

/// Returns the source as text, for example "ISO 6336-1, 6.5.4, (13), (14): subcritical, N ≤ 0.85".
/// Returns "" for a key that is not a factor.
std::string source_text(const Rating& rating, std::string_view key);

}  // namespace gearwright
