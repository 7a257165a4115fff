// What a spec lacks for what is to be computed of it, found before anything is, and told at once.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "gearwright/base/error.hpp"
#include "gearwright/catalogue/rating_keys.hpp"

namespace gearwright {

struct JobSpec;  // spec/spec.hpp

enum class SpecUse {
  geometry,    ///< of the gears, and of the pair where there are two
  pair,        ///< the mounted pair, its contact
  load,        ///< teeth under torque, or probes of one tooth
  compensate,  ///< corrections, which may aim at teeth under torque
  scatter,     ///< what tolerances do to the pair
  rate,        ///< strength by the standard
  run,         ///< whatever the spec has a table for
};

/// Everything that a spec lacks, each with an example, with the keys of a file: a second gear, a
/// torque, and for a rating its load, the gears' materials and what its factors need. A material that
/// is not missing but wrong is among them. Of a search and of an unknown gear nothing: their verbs
/// are others.
std::vector<Error> missing_for(SpecUse use, const JobSpec& spec);

/// The same as one error; none: nothing is missing.
std::optional<Error> missing_error(SpecUse use, const JobSpec& spec);

/// Of a rating alone. `tables`: where the materials of both gears stand, or would.
std::vector<Error> missing_for_rating(const RatingTable& rating,
                                      const std::array<MaterialInput, 2>& materials,
                                      const std::array<std::string, 2>& tables);

/// The table that a gear's material is given in: its own, that of gear 1, or [rating.material]; its
/// own or that of gear 1 where there is none.
std::string material_table(const JobSpec& spec, int which);

}  // namespace gearwright
