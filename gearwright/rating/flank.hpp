// Factors of surface durability (pitting) to ISO 6336-2.
//
//   σ_H0 = Z_H Z_E Z_ε Z_β √(F_t (u + 1)/(d_1 b u))      σ_H = Z_B,D σ_H0 √(K_A K_γ K_v K_Hβ K_Hα)
//   σ_HG = σ_Hlim Z_NT Z_L Z_v Z_R Z_W Z_X               S_H = σ_HG/σ_H
//
//                                              theory: docs/theory/11-rating.md
#pragma once

#include <optional>

#include "gearwright/rating/factor.hpp"
#include "gearwright/rating/material.hpp"
#include "gearwright/rating/rated_pair.hpp"

namespace gearwright {

Factor zone_factor(const RatedPair& pair);  ///< Z_H [T11.17]
/// Returns Z_B of the pinion and Z_D of the wheel. Z_D is 1 for an internal wheel. The factors are
/// infinite if single pair contact reaches a base circle, where the radius of curvature is 0.
/// [T11.18]
FactorPair single_contact_factors(const RatedPair& pair);
Factor elasticity_factor(const std::array<Material, 2>& materials);  ///< Z_E  √(N/mm²) [T11.19]
Factor contact_ratio_factor(const RatedPair& pair);                  ///< Z_ε [T11.20]
Factor flank_helix_factor(const RatedPair& pair);                    ///< Z_β [T11.21]

/// Inputs of the lubricant film factors. `sigma_Hlim` is the lower σ_Hlim of the two materials
/// and determines the constants of the factors.
struct Film {
  double sigma_Hlim = 0.0;                  ///< N/mm²
  std::optional<double> viscosity;          ///< ν_40  mm²/s
  std::optional<double> velocity;           ///< v     m/s
  std::optional<std::array<double, 2>> Rz;  ///< roughness of the flanks of pinion and wheel, µm
};

// The following three functions return values at the reference number of cycles. For a limited
// life, rate() raises these values to the power Life::reference.
Factor lubricant_factor(const Film& film);                         ///< Z_L [T11.23]
Factor velocity_factor(const Film& film);                          ///< Z_v [T11.24]
Factor roughness_factor(const RatedPair& pair, const Film& film);  ///< Z_R [T11.25]
/// Returns Z_W of each gear. Z_W can be greater than 1 for the softer gear only. [T11.26]
FactorPair work_hardening_factors(const RatedPair& pair, const std::array<Material, 2>& materials,
                                  const Film& film);

/// Returns the nominal contact stress σ_H0, N/mm² [T11.16], due to the tangential force F_t in N.
/// `Z` is the product of the Z factors.
double nominal_contact_stress(const RatedPair& pair, double tangential_force, double Z);

}  // namespace gearwright
