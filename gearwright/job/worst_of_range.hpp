// Searches the ranges of errors in [compensate.range] for errors under which the pair is worse than
// under the scenarios that are already known.
//                                    theory: docs/theory/14-scatter.md, [T14.15]
//
// The peak to peak is not quasi-convex in the errors: if the contact moves from one edge to another
// inside the ranges, the peak to peak may be greater there than at every corner.
#pragma once

#include <array>
#include <optional>

#include "gearwright/contact/contact_setup.hpp"
#include "gearwright/spec/spec.hpp"

namespace gearwright {

/// The errors at the greatest peak to peak that the search finds, in the units of their keys. There
/// is no result if the spec has no ranges, if the greatest value is at a corner, or if it exceeds
/// `known` by less than 2 % or by less than 0.01″.
///
/// Accuracy  the worst of several local maxima; not a bound
std::optional<std::array<double, kErrorCount>> worse_inside_ranges(const ContactSetup& setup,
                                                                   const JobSpec& spec, Angle known,
                                                                   Progress* progress);

}  // namespace gearwright
