// The inputs that a spec lacks for a computation, found beforehand and reported together.
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
  geometry,    ///< the gears, and the pair if there are two
  pair,        ///< the mounted pair, its contact
  load,        ///< teeth under torque, or probes of one tooth
  compensate,  ///< corrections, which may aim at teeth under torque
  propose,     ///< flank modifications for teeth under torque
  scatter,     ///< effect of tolerances on the pair
  rate,        ///< strength by the standard
  run,         ///< everything for which the spec has a table
};

/// Everything that a spec lacks, each with an example, with the keys of a file: a second gear, a
/// torque, and for a rating its load, the gears' materials and the inputs of its factors. A wrong
/// material is included. Nothing is listed for a search and for an unknown gear, which have other
/// verbs.
std::vector<Error> missing_for(SpecUse use, const JobSpec& spec);

/// The same as one error; none if nothing is missing.
std::optional<Error> missing_error(SpecUse use, const JobSpec& spec);

/// The missing inputs of a rating alone. `tables` are those of the materials of both gears,
/// and `halves` is 2 for double-helical gears.
std::vector<Error> missing_for_rating(const RatingTable& rating,
                                      const std::array<MaterialInput, 2>& materials,
                                      const std::array<std::string, 2>& tables, int halves = 1);

/// The table of a gear's material: its own, that of gear 1, or [rating.material]; if there is none,
/// its own or that of gear 1.
std::string material_table(const JobSpec& spec, int which);

}  // namespace gearwright
