// The pair of circular-arc gears as JSON. Internal to job/ and its tests.
#pragma once

#include "gearwright/pair/arc_pair.hpp"
#include "gearwright/spec/json.hpp"

namespace gearwright {

/// The marking compound's thickness for the ellipses of a result, where nobody named one.
constexpr double kMarking_mm = 0.00635;

/// The keys of a pair, `null` where only an involute has such a value, and `arc_contacts`.
Json arc_pair_json(const ArcPair& pair);

}  // namespace gearwright
