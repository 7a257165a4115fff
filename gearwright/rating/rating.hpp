// Computes all factors, stresses and safety factors of a pair to ISO 6336, method B.
//
//   const auto pair = rated_pair(mounted);
//   const auto r = rate(*pair, {.torque = 40953, .speed = 1165.9, .materials = {steel, steel}});
//   if (r) use(r->S_F[0].value, r->S_F[0].formula);
//
// Lists of two values are in the order gear 1, gear 2 of the spec, whichever is the pinion. A
// factor whose optional input is not given is 1, and its branch states this. Scuffing and
// micropitting (ISO/TS 6336-20, -21, -22) are not covered. For plastics, rating/plastic.hpp
// computes the same numbers to VDI 2736, at the temperatures of the teeth. Factors that this
// guideline does not contain are absent.
//                                              theory: docs/theory/11-rating.md
#pragma once

#include <array>
#include <cstdlib>
#include <optional>
#include <vector>

#include "gearwright/base/error.hpp"
#include "gearwright/rating/distribution.hpp"
#include "gearwright/rating/dynamic.hpp"
#include "gearwright/rating/flank.hpp"
#include "gearwright/rating/plastic.hpp"
#include "gearwright/rating/rated_pair.hpp"
#include "gearwright/rating/root.hpp"

namespace gearwright {

/// Returns the torque on gear 1 that balances the torque T_2 on gear 2, T_1 = T_2 |z_1/z_2|.
/// Losses are neglected.
inline double balancing_torque(double torque_2, int z1, int z2) {
  return torque_2 * std::abs(z1) / std::abs(z2);
}

struct RatingInput {
  RatingEdition edition = RatingEdition::iso_2006;
  double torque = 0.0;                        ///< T_1  N m, on gear 1
  std::optional<double> speed;                ///< n_1  1/min, of gear 1
  double application_factor = 1.0;            ///< K_A
  double mesh_load_factor = 1.0;              ///< K_γ  if several meshes share the power
  std::optional<double> life_h;               ///< L_h  h
  bool reversed = false;                      ///< true for bending in both directions (idler)
  std::optional<double> viscosity;            ///< ν_40 mm²/s
  std::optional<std::array<int, 2>> quality;  ///< accuracy grades of ISO 1328-1
  std::optional<std::array<double, 2>> flank_roughness, root_roughness;  ///< Rz  µm
  std::optional<double> tip_relief;                                      ///< C_a  µm
  // Factors given by the user.
  std::optional<double> dynamic_factor;    ///< K_v
  std::optional<double> face_load_factor;  ///< K_Hβ
  /// True if K_Hβ is computed from the load along the teeth. `face_load_factor` then applies only
  /// to the torque and the face width of this input.
  bool face_load_computed = false;
  bool face_load_assumed = false;  ///< true if `face_load_factor` is the default of a search
  std::optional<double> face_load_factor_root;        ///< K_Fβ
  std::optional<double> transverse_load_factor;       ///< K_Hα
  std::optional<double> transverse_load_factor_root;  ///< K_Fα
  std::optional<PinionMounting> mounting;
  std::optional<MeshShafts> shafts;    ///< used to compute K_Hβ if neither K_Hβ nor a mounting is
                                       ///< given
  std::optional<double> misalignment;  ///< f_ma  µm, used with `shafts` or if K_Hβ is computed from
                                       ///< the load along the teeth; by default from the helix
                                       ///< slope tolerances
  std::optional<RatedBody> body;
  std::array<std::optional<double>, 2> rim{};  ///< s_R  mm, rim thickness for Y_B
  LifeChoice life;
  PlasticInput plastic;  ///< for VDI 2736
  std::array<Material, 2> materials;
};

struct Rating {
  Rating() = default;  ///< empty; prevents aggregate initialisation
  RatingEdition edition = RatingEdition::iso_2006;
  Factor F_t;               ///< N
  std::optional<Factor> v;  ///< m/s
  std::array<std::optional<Factor>, 2> N_L;
  std::optional<std::array<Tolerances, 2>> tolerance;  ///< µm, if the quality is given
  Factor K_A, K_gamma, K_v;
  std::optional<Factor> m_red, n_E1, N;
  FaceLoad face;
  Factor K_Fbeta, K_Halpha, K_Falpha;
  Stiffness stiffness;
  Factor Z_H, Z_E, Z_epsilon, Z_beta, Z_L, Z_v, Z_R;
  FactorPair Z_B, Z_NT, Z_L_at_N, Z_v_at_N, Z_R_at_N, Z_W, Z_X;  ///< Z_B contains Z_D of the wheel
  Factor sigma_H0;
  FactorPair sigma_H, sigma_HG, S_H;
  std::array<CriticalSection, 2> section;
  FactorPair Y_F, Y_S, Y_beta, Y_B, Y_DT, Y_ST, Y_M, Y_NT, Y_delta_relT, Y_R_relT, Y_X;
  FactorPair sigma_F0, sigma_F, sigma_FG, S_F;
  std::optional<Factor> Y_epsilon;               ///< VDI 2736 only
  std::optional<ToothTemperatures> temperature;  ///< °C, VDI 2736 only
  std::vector<Warning> limits;                   ///< limits of the standard that this pair exceeds
};

/// Returns the error of rate() for missing inputs and for a grade that the edition of ISO 1328-1
/// does not have. This error does not depend on the pair.
std::optional<Error> missing_input(const RatingInput& input, int halves = 1);
/// Formula   [T11.1], [T11.22], [T11.40]
/// Errors    `rating.torque` if it is not > 0; `gearN.material` if it has no strength;
///           `rating.speed` if it is absent and K_v requires it; `rating.quality` if it is absent
///           and a factor requires it; `rating.face_load_factor` if neither this factor nor a
///           mounting nor a shaft is given; `rating.mounting` or `gearN.shaft` for double-helical
///           gears without a face load factor; `gearN.rack` if no tangent touches the root;
///           `gearN.profile_shift` if single pair contact reaches a base circle; for VDI 2736 also
///           `rating.plastic…`, `rating.edition` if neither gear is made of plastic or if a gear is
///           internal, and `gearN.material…` if there is no value at the temperature
/// Laws      (1) σ_F0 ∝ T, σ_H0 ∝ √T
///           (2) if lengths are multiplied by k and the torque by k³, the nominal stresses do not
///               change
///           (3) if gear 1 and gear 2 are exchanged, and torque and speed are those of the new
///               gear 1, the numbers do not change
Result<Rating> rate(const RatedPair& pair, const RatingInput& input);

// The missing inputs of a rating. Interfaces add missing loads and materials to this list.

/// Returns the errors that missing_input() joins into one. `halves` is 2 for double-helical gears,
/// whose face load factor is not computed from a mounting.
std::vector<Error> missing_inputs(const RatingInput& input, int halves);

}  // namespace gearwright
