// The tables of a spec file. The keys of gears and searches have headers of their own.
#pragma once

#include <string>

#include "gearwright/catalogue/compensate_keys.hpp"
#include "gearwright/catalogue/drawing_keys.hpp"
#include "gearwright/catalogue/error_keys.hpp"
#include "gearwright/catalogue/gear_keys.hpp"
#include "gearwright/catalogue/rating_keys.hpp"
#include "gearwright/catalogue/scatter_keys.hpp"

namespace gearwright {

/// The inputs of a spec. The places of most members are given by spec_keys(). The gears (GivenPair)
/// and `scatter` have readers of their own.
struct SpecTables : GivenPair {
  std::string title;
  DrawingInput drawing;
  FitInput fit;
  ErrorsInput errors;
  ContactInput contact;
  CompensateInput compensate;
  ScatterInput scatter;
  LoadInput load;
  RatingTable rating;
};

/// The keys of the file itself: title, [gear1], [gear2], [pair] and so on.
const KeyTable& spec_keys();

/// Returns every table that can be reached from spec_keys(), each once. The first one is
/// spec_keys() itself.
std::vector<const KeyTable*> all_key_tables();

/// True if the last part of the path is a key of any table, or the last part of a permitted word of
/// any key. For example, lead_crowning_um is the last part of the word "gear1.lead_crowning_um".
bool is_spec_key(std::string_view path);

}  // namespace gearwright
