// Gear materials by the kinds of ISO 6336-5, and a table of common steels.
//
//   σ_Hlim, σ_Flim   allowable stress numbers of the reference test gears, N/mm²
//   HV, HB           hardness of the surface, Vickers and Brinell; HB ≈ 0.95 HV
//   R_e              yield strength or 0.2 % proof stress, N/mm²
//
// The table is intended for a first result. Its values are those of quality MQ at a usual hardness.
// For a final design they must be checked against the standard and the supplier's data.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace gearwright {

/// The kinds of ISO 6336-5, with its letters. The order is that of kMaterialKinds.
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
  plastic              ///< rated by VDI 2736 only
};

/// Words of the kinds in a file, in their order, and their letters in the standard.
std::span<const std::string_view> material_kind_words();
std::string_view material_letters(MaterialKind kind);

/// Values by temperature: °C, N/mm²; rising temperatures.
using ByTemperature = std::vector<std::array<double, 2>>;

/// Linear interpolation between two temperatures; none outside the list.
std::optional<double> at_temperature(const ByTemperature& list, double celsius);

struct Material {
  std::string name;
  MaterialKind kind = MaterialKind::case_hardened;
  double sigma_Hlim = 0.0;                 ///< N/mm²
  double sigma_Flim = 0.0;                 ///< N/mm²
  double youngs_modulus = 206000.0;        ///< E  N/mm²
  double poisson_ratio = 0.3;              ///< ν
  double density = 7.83e-6;                ///< ρ  kg/mm³
  std::optional<double> hardness_HV{};     ///< of the surface
  std::optional<double> yield_strength{};  ///< R_e  N/mm²
  bool from_table = false;                 ///< limits of the shipped table
  /// Values of a plastic, which replace the numbers above if they are not empty.
  ByTemperature sigma_Hlim_by{}, sigma_Flim_by{}, youngs_modulus_by{};

  bool surface_hardened() const {
    return kind == MaterialKind::case_hardened || kind == MaterialKind::induction_hardened ||
           kind == MaterialKind::nitrided || kind == MaterialKind::nitrocarburized;
  }
  std::optional<double> hardness_HB() const {
    return hardness_HV ? std::optional(0.95 * *hardness_HV) : std::nullopt;
  }
};

/// A row of the table.
struct NamedMaterial {
  std::string_view name;
  MaterialKind kind;
  double hardness_HV;  ///< usual, of the surface
  std::optional<double> yield_strength;
  std::string_view note;
};

std::span<const NamedMaterial> named_materials();

/// The line of ISO 6336-5 for quality MQ: limits that grow with the hardness between the ends of
/// the line; none outside them.
///
/// Formula   ISO 6336-5, clause 5, σ = A·x + B, x in HV or HB by kind
/// Source    confirmed by printed reports for case-hardened steel (1500, 430) and for 34CrNiMo6 at
///           240 HB (700, 290; the line gives 704, 294); for the other kinds, compare
///           docs/theory/11-rating.md with the tables of the standard
struct Limits {
  double sigma_Hlim, sigma_Flim;  ///< N/mm²
};
std::optional<Limits> limits_of(MaterialKind kind, double hardness_HV);

/// A row of the table with its limits, at another hardness if one is given.
///
/// None      for a name that is not in the table, or a hardness off the kind's line
std::optional<Material> material_named(std::string_view name,
                                       std::optional<double> hardness_HV = std::nullopt);

}  // namespace gearwright
