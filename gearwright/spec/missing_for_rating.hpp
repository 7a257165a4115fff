// What a spec must have before its gears can be rated, told at once.
#pragma once

#include <array>
#include <optional>

#include "gearwright/base/error.hpp"
#include "gearwright/catalogue/material_keys.hpp"
#include "gearwright/catalogue/rating_keys.hpp"

namespace gearwright {

/// Everything that a rating still wants, in one error with the keys of a file: the load, the gears'
/// materials, what its factors need. A material that is not missing but wrong is told first and
/// alone. `named`: the gears whose tables would have the materials.
std::optional<Error> missing_for_rating(const RatingTable& table,
                                        const std::array<MaterialInput, 2>& materials,
                                        std::array<int, 2> named = {1, 2});

}  // namespace gearwright
