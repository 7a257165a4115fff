// The units of a spec tree on the way in, and of records and specs on the way out. Everything between is in mm.
//
// Internal to spec/, job/ and the programs, because public headers do not contain trees.
#pragma once

#include "gearwright/catalogue/unit_system.hpp"
#include "gearwright/spec/json.hpp"

namespace gearwright {

struct GivenKeys;  // catalogue/spelling.hpp

/// The spec with the keys of the catalogue and without the key `units`. The units and, for inch, the lengths as they
/// are written are noted in `given`.
///
/// Throws  SpecError if `units` is not a known word, or if a key of a length is not in the units of the spec
Json in_catalogue_units(const Json& spec, GivenKeys& given);

/// A record or a part of a spec with the keys, numbers and sentences of this system. A spec inside a record gets the key
/// `units`. A second call changes nothing.
Json in_units(UnitSystem units, const Json& record);

/// A whole spec in this system, with the key `units` if it is not "mm".
Json spec_in(UnitSystem units, const Json& spec);

}  // namespace gearwright
