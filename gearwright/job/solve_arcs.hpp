// What a spec with racks of arcs may ask for, and its pair.
//
// Internal to job/: solve asks for them where an involute pair would be completed.
#pragma once

#include <optional>

#include "gearwright/pair/arc_pair.hpp"
#include "gearwright/spec/spec.hpp"

namespace gearwright {

/// A gear, or a cutter of one, has a rack of arcs.
bool has_arcs(const JobSpec& spec);

/// What has no meaning for circular-arc teeth: a gear cut by one of them, tips shortened by profile
/// shifts, crossed axes.
std::optional<Error> check_arcs(const JobSpec& spec);

/// Refuses a spec with racks of arcs for a verb that knows involute gears only.
std::optional<Error> refuse_arcs(const JobSpec& spec, const std::string& verb);

}  // namespace gearwright
