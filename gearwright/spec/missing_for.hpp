// Finds the inputs that a spec lacks for a computation. The missing inputs are found before the
// computation and reported together.
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
  pair,        ///< the mounted pair and its contact
  load,        ///< teeth under torque, or probes of one tooth
  compensate,  ///< corrections, which may be for teeth under torque
  propose,     ///< flank modifications for teeth under torque
  scatter,     ///< effect of tolerances on the pair
  rate,        ///< strength according to a standard
  run,         ///< every computation for which the spec has a table
};

/// Returns all inputs that a spec lacks. Each error names the key in the file and gives an example.
/// The inputs are a second gear, a torque, a tolerance for scatter and, for a rating, its load, the
/// materials of the gears and the inputs of its factors. A wrong material is also reported. The
/// list is empty for a search, an unknown gear, a drive and a rack.
std::vector<Error> missing_for(SpecUse use, const JobSpec& spec);

/// Returns the missing inputs as one error, or nothing if no input is missing.
std::optional<Error> missing_error(SpecUse use, const JobSpec& spec);

/// Returns the missing inputs of a rating alone. `tables` are the tables of the materials of both
/// gears, and `halves` is 2 for double-helical gears.
std::vector<Error> missing_for_rating(const RatingTable& rating,
                                      const std::array<MaterialInput, 2>& materials,
                                      const std::array<std::string, 2>& tables, int halves = 1);

/// Returns the name of the table that contains the material of a gear. It is the first of these
/// tables that the spec gives: the material of the gear itself, the material of gear 1, and
/// [rating.material]. If the spec gives none of them, it is the table of gear 1, in which the user
/// should give the material.
std::string material_table(const JobSpec& spec, int which);

}  // namespace gearwright
