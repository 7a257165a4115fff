// The keys of [gearN.material]: what the teeth are made of, for loads and ratings.
#pragma once

#include <optional>
#include <string>

#include "gearwright/catalogue/key.hpp"
#include "gearwright/rating/material.hpp"

namespace gearwright {

/// As given. A name of the shipped table brings the rest; whatever stands beside it counts instead.
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
};

const KeyTable& material_keys();

}  // namespace gearwright
