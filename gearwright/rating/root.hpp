// Factors of tooth bending strength to ISO 6336-3.
//
//   σ_F0 = F_t/(b m_n) Y_F Y_S Y_β Y_B Y_DT                 σ_F = σ_F0 K_A K_γ K_v K_Fβ K_Fα
//   σ_FG = σ_Flim Y_ST Y_M Y_NT Y_δrelT Y_RrelT Y_X, Y_ST = 2     S_F = σ_FG/σ_F
//
// The critical section lies where a line at 30° to the tooth's centre line (60° for an internal
// gear) is tangent to the fillet. The fillet has the radius ρ_F there, and the chord of the section
// is s_Fn. The load acts at the outer point of single pair contact (d_en, α_Fen), with the lever
// arm h_F.
//                                              theory: docs/theory/11-rating.md
#pragma once

#include <optional>

#include "gearwright/rating/factor.hpp"
#include "gearwright/rating/material.hpp"
#include "gearwright/rating/rated_pair.hpp"

namespace gearwright {

/// The point of load application, in method B and in method C.
enum class LoadPoint { single_contact, tip };

struct CriticalSection {
  double theta;      ///< ϑ      rad, solved from θ = 2 G tan θ/z_n − H
  double s_Fn;       ///< mm
  double rho_F;      ///< mm
  double h_F;        ///< mm
  double alpha_Fen;  ///< rad
  double d_en;       ///< mm, negative for an internal gear
  double q_s;        ///< s_Fn/(2 ρ_F)
};

/// Returns the critical section of a gear in the normal plane, from the rack that cut it (x_E,
/// ρ_fP*, h_fP*, s_pr*). For an internal gear, the equivalent radius ρ_fPv represents its pinion
/// cutter.
///
/// Formula   [T11.27]…[T11.31]; ISO 6336-3, 6.2
/// None      if no tangent at 30° (60°) touches the fillet, or if s_Fn, ρ_F or h_F is not > 0
std::optional<CriticalSection> critical_section(const RatedPair& pair, const RatedGear& gear,
                                                LoadPoint at = LoadPoint::single_contact);

/// Returns the effective face width of a root, mm. If the gear is wider than the common face width,
/// at most one module of the excess counts at each end.
double root_face_width(const RatedPair& pair, const RatedGear& gear);

/// Returns Y_F [T11.32]. In the edition of 2019, Y_F includes the load distribution factor f_ε.
Factor form_factor(RatingEdition edition, const RatedPair& pair, const CriticalSection& section);
Factor stress_correction_factor(const CriticalSection& section);         ///< Y_S [T11.33]
Factor root_helix_factor(RatingEdition edition, const RatedPair& pair);  ///< Y_β [T11.34]
/// The rim thickness above which Y_B is defined, 0.5 h or, for an internal gear, 1.75 m_n.
struct LeastRim {
  double thickness;   ///< mm
  const char* words;  ///< "half the tooth height"
};
LeastRim least_rim(double side, double normal_module, double tooth_height);
/// Returns Y_B [T11.35] for a rim thickness `rim` in mm. Without `rim`, the rim is thick enough.
Factor rim_factor(const RatedGear& gear, double normal_module, std::optional<double> rim);
Factor deep_tooth_factor(const RatedPair& pair, std::optional<int> grade);  ///< Y_DT [T11.36]

/// Return Y_δrelT [T11.37] and Y_RrelT [T11.38] at the reference number of cycles.
Factor notch_sensitivity_factor(const Material& material, const CriticalSection& section);
Factor surface_factor(const Material& material, std::optional<double> Rz);
Factor root_size_factor(const Material& material, double normal_module);  ///< Y_X [T11.39]

}  // namespace gearwright
