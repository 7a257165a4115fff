// Computes the damage by a load spectrum, and the safety factors of the spectrum.
//
//   n_i   cycles of step i        N_i(σ)  permissible cycles at the stress σ
//   U     damage Σ n_i/N_i, 1 at failure (Miner)
//
// As in ISO 6336-6, every step is rated with its own load factors and with K_A = 1, because the
// spectrum replaces K_A. The safety factor is the factor from 0.001 to 1000 by which all stresses
// must be multiplied for a damage of 1. A stress below the strength at 10¹⁰ cycles causes no
// damage. A stress above the static strength causes failure.
#pragma once

#include <optional>
#include <vector>

#include "gearwright/rating/rating.hpp"

namespace gearwright {

struct LoadBin {
  double torque = 0.0;  ///< N m, on gear 1
  double speed = 0.0;   ///< 1/min, of gear 1
  double hours = 0.0;   ///< h
  /// K_Hβ under this torque, in place of RatingInput::face_load_factor.
  std::optional<double> face_load_factor{};
};

struct SpectrumRating {
  std::array<double, 2> damage_flank,
      damage_root;  ///< U of gear 1 and gear 2; infinite if a stress
                    ///< exceeds the static strength
  std::array<double, 2> S_H, S_F;
};

/// Returns the input of a rating under one step of the load, with K_A = 1 and without a life.
RatingInput input_of(const LoadBin& step, RatingInput input);

/// Formula   [T11.42]; ISO 6336-6, Miner's rule
/// Errors    as rate()
/// Domain    at least one step; torques, speeds and hours > 0 (contract)
/// Laws      (1) a spectrum of one step has the safety factors of rate() with K_A = 1 and the life
///           of this step
///           (2) if a step is divided in two, the result does not change
///           (3) U ≤ 1 if S ≥ 1
Result<SpectrumRating> rate_spectrum(const RatedPair& pair, const RatingInput& input,
                                     const std::vector<LoadBin>& spectrum);

}  // namespace gearwright
