// Gear materials, classified as in ISO 6336-5, a table of common materials, and their life factors.
//
//   σ_Hlim, σ_Flim   allowable stress numbers of the reference test gears, N/mm²
//   HV, HB           hardness of the surface, Vickers and Brinell; HB ≈ 0.95 HV
//   R_e              yield strength or 0.2 % proof stress, N/mm²
//
// The table is intended for a first result. Its values apply to quality MQ at a usual hardness. For
// a final design, the user must check them against the standard and the supplier's data.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "gearwright/rating/factor.hpp"

namespace gearwright {

/// The kinds of material of ISO 6336-5, with their letters in the standard.
enum class MaterialKind {
  case_hardened,       ///< Eh
  through_hardened,    ///< V
  normalized,          ///< St
  induction_hardened,  ///< IF   flank and root
  nitrided,            ///< NT, NV (nitr.)
  nitrocarburized,     ///< NV (nitrocar.)
  cast,                ///< GG
  nodular,             ///< GGG (perl., bai.)
  nodular_ferritic,    ///< GGG (ferr.)
  malleable,           ///< GTS (perl.)
  plastic              ///< rated to VDI 2736 only
};

/// Returns the names of the kinds in a spec, in the order of the enumerators.
std::span<const std::string_view> material_kind_words();
std::string_view material_letters(MaterialKind kind);

/// Pairs of temperature, °C, and value, N/mm², by ascending temperature.
using ByTemperature = std::vector<std::array<double, 2>>;
/// Returns the value at a temperature by linear interpolation, or none outside the list.
std::optional<double> at_temperature(const ByTemperature& list, double celsius);

struct Material {
  std::string name;
  MaterialKind kind = MaterialKind::case_hardened;
  double sigma_Hlim = 0.0;                  ///< N/mm²
  double sigma_Flim = 0.0;                  ///< N/mm²
  double youngs_modulus = 206000.0;         ///< E  N/mm²
  double poisson_ratio = 0.3;               ///< ν
  std::optional<double> density = 7.83e-6;  ///< ρ  kg/mm³; none for a plastic of unknown density
  std::optional<double> hardness_HV{};      ///< hardness of the surface
  std::optional<double> yield_strength{};   ///< R_e  N/mm²
  bool from_table = false;                  ///< true if the limits come from the built-in table
  /// Values of a plastic by temperature. A non-empty list replaces the member without `_by`.
  ByTemperature sigma_Hlim_by{}, sigma_Flim_by{}, youngs_modulus_by{};

  bool has_strengths() const { return has_flank_strength() && has_root_strength(); }
  bool has_flank_strength() const { return sigma_Hlim > 0.0 || !sigma_Hlim_by.empty(); }
  bool has_root_strength() const { return sigma_Flim > 0.0 || !sigma_Flim_by.empty(); }
  bool surface_hardened() const {
    return kind == MaterialKind::case_hardened || kind == MaterialKind::induction_hardened ||
           kind == MaterialKind::nitrided || kind == MaterialKind::nitrocarburized;
  }
  std::optional<double> hardness_HB() const {
    return hardness_HV ? std::optional(0.95 * *hardness_HV) : std::nullopt;
  }
};

/// Returns a material of this kind with the usual elasticity and density of the kind, but without
/// strength values. Returns none for a plastic, whose elasticity and density depend on its grade.
std::optional<Material> material_of_kind(MaterialKind kind);

struct NamedMaterial {
  std::string_view name;
  MaterialKind kind;
  double hardness_HV;  ///< usual hardness of the surface
  std::optional<double> yield_strength;
  std::string_view note;
};

std::span<const NamedMaterial> named_materials();

/// The allowable stress numbers for quality MQ. limits_of() computes them for a hardness, from the
/// line of ISO 6336-5. It returns none if the kind has no such line, or if the hardness is outside
/// the range of this line.
///
/// Formula   ISO 6336-5, clause 5, σ = A·x + B, with x in HV or HB depending on the kind
/// Source    Printed reports confirm the values for case-hardened steel (1500, 430) and for
///           34CrNiMo6 at 240 HB (700, 290; the line gives 705, 294). The values for the other
///           kinds have not been compared with the standard (docs/theory/11-rating.md)
struct Limits {
  double sigma_Hlim, sigma_Flim;  ///< N/mm²
};
std::optional<Limits> limits_of(MaterialKind kind, double hardness_HV);

/// Returns the material of the table with this name, at the given hardness or, if none is given, at
/// its usual hardness.
///
/// None      if the name is not in the table, or if the hardness is outside the range of
///           limits_of()
std::optional<Material> material_named(std::string_view name,
                                       std::optional<double> hardness_HV = std::nullopt);

// A life factor is the strength at a given number of load cycles, divided by the strength at the
// reference number.
//
//   N_L   load cycles           Z_NT, Y_NT   life factors of flank and root, for test conditions
//
// Between the number of cycles for static stress and the reference number, the factors are straight
// lines in log N and log σ. Beyond the reference number, they decrease to 0.85 at 10¹⁰ cycles,
// unless experience permits a factor of 1.

struct Life {
  Factor factor;     ///< Z_NT or Y_NT
  double reference;  ///< exponent of factors such as Z_L that apply to the reference number of
                     ///< cycles. It is 0 for static stress, linear in log N up to this number, and
                     ///< then 1
};

struct LifeChoice {
  bool limited_pitting = false;  ///< true if some pitting is permitted (longer line of Z_NT)
  double at_10_10 = 0.85;        ///< Z_NT, Y_NT at 10¹⁰ cycles, 0.85 … 1
};

/// Returns the life factor of the flank. Without `cycles`, it is 1, as at the reference number.
///
/// Formula   [T11.41]; ISO 6336-2, clause 10; confirmed at 10⁹ and 10¹⁰ by printed reports
/// Law       the factor is continuous and does not increase with N
Life flank_life(MaterialKind kind, std::optional<double> cycles, const LifeChoice& choice = {});

/// Returns the life factor of the root. Without `cycles`, it is 1, as at the reference number.
///
/// Formula   [T11.41]; ISO 6336-3, clause 12
Life root_life(MaterialKind kind, std::optional<double> cycles, const LifeChoice& choice = {});

}  // namespace gearwright
