// Converts the units of a spec to mm when it is read, and results and specs back to the units of
// the user when they are written.
//
// Internal to spec/, job/ and the programs, because public headers do not contain trees.
#pragma once

#include "gearwright/catalogue/unit_system.hpp"
#include "gearwright/spec/json.hpp"

namespace gearwright {

struct GivenKeys;  // catalogue/spelling.hpp

/// The spec in mm with the keys of the catalogue, without the key `units`. `given` receives the
/// units and, for inch, the lengths as written.
///
/// Throws  SpecError if `units` is not a known word, or if the key of a length has the wrong unit
Json in_catalogue_units(const Json& spec, GivenKeys& given);

/// A result or a part of a spec, with keys, numbers and sentences converted to this unit system. A
/// spec inside a result gets the key `units`. A second call changes nothing.
Json in_units(UnitSystem units, const Json& record);

/// A whole spec in this unit system, with the key `units` if it is not "mm".
Json spec_in(UnitSystem units, const Json& spec);

}  // namespace gearwright
