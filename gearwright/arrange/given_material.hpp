// The material of a gear as given on a drawing, and the complete material that results.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "gearwright/base/result.hpp"
#include "gearwright/rating/factor.hpp"
#include "gearwright/rating/material.hpp"

namespace gearwright {

/// The given data. If the table of materials contains `name`, the row of this name provides the
/// missing values.
struct MaterialInput {
  std::optional<std::string> name;
  std::optional<MaterialKind> kind;
  std::optional<double> youngs_modulus;    ///< E        N/mm²
  std::optional<double> poisson_ratio;     ///< ν
  std::optional<double> density;           ///< ρ        kg/m³
  std::optional<double> sigma_Hlim;        ///< σ_Hlim   N/mm²
  std::optional<double> sigma_Flim;        ///< σ_Flim   N/mm²
  std::optional<double> surface_hardness;  ///< HV
  std::optional<double> yield_strength;    ///< R_e      N/mm²
  std::vector<double> temperatures;        ///< °C, at which the lists of a plastic apply
  ByTemperature sigma_Hlim_by, sigma_Flim_by, youngs_modulus_by;
};

/// The material of `owner`, for example "gear1.material". Given values replace the values in the
/// table of materials.
///
/// Errors    a member of `owner` if a strength is unknown, or if the standard does not cover the
///           material
Result<Material> material_of(const MaterialInput& given, const std::string& owner,
                             RatingEdition edition);

/// The density of the given material, kg/mm³. The strength of the material need not be known. There
/// is no density if the material is a plastic without a given density, or if neither `kind` nor a
/// name in the table is given.
std::optional<double> density_of(const MaterialInput& given);

}  // namespace gearwright
