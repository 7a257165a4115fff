// The keys of [gearN.material]: what the teeth are made of, for loads and ratings.
#pragma once

#include <optional>
#include <string>

#include "gearwright/catalogue/key.hpp"

namespace gearwright {

struct MaterialInput {
  std::optional<std::string> name;
  std::optional<double> youngs_modulus;  ///< E        N/mm²
  std::optional<double> poisson_ratio;   ///< ν
};

const KeyTable& material_keys();

}  // namespace gearwright
