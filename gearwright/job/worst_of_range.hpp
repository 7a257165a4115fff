// Finds errors inside the ranges of `compensate` for which a pair is worse than for given errors.
//                                    theory: docs/theory/14-scatter.md, [T14.15]
//
// The peak to peak is not quasi-convex in the errors: if the contact moves from one edge to another
// inside the ranges, it may be greater there than at every corner.
#pragma once

#include <array>
#include <optional>

#include "gearwright/contact/contact_setup.hpp"
#include "gearwright/spec/spec.hpp"

namespace gearwright {

/// The values of the errors with ranges, in the units of their keys, at the greatest peak to peak that a
/// search of the ranges finds. None if it exceeds `known` by less than 2 % or 0.01″, and without
/// ranges.
///
/// Accuracy  the worst of several local maxima; not a bound
std::optional<std::array<double, kErrorCount>> worse_inside_ranges(const ContactSetup& setup,
                                                                   const JobSpec& spec, Angle known,
                                                                   Progress* progress);

}  // namespace gearwright
