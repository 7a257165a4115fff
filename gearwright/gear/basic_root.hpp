// The rack that cuts a given root diameter and root form diameter. It is used for gears that are given
// by their base cylinder.
//
//   d_f, d_Ff             root and root form diameter, mm
//   h_fP*, ρ_fP*, h_Ff*   dedendum, tip rounding and flank depth of the rack, in modules
//                                              theory: docs/theory/04-conjugate-action.md, 4.2
#pragma once

#include <optional>

#include "gearwright/base/result.hpp"
#include "gearwright/gear/gear.hpp"

namespace gearwright {

/// The rack of `spec`, with the dedendum that gives d_f and, if d_Ff is given, with the tip rounding
/// whose fillet ends at d_Ff.
///
/// Formula   h_fP* = x_E ± (d − d_f)/(2 m_n), h_Ff* = x_E − (ρ_F − ρ_C) sin α_t/m_n,
///           ρ_fP* = (h_fP* − h_Ff*)/(1 − sin α_n); [T4.4]
/// Errors    `root_diameter`, `root_form_diameter` with the allowed range; for an internal gear
///           `root_form_diameter` is not supported, because a rack does not cut its fillet
Result<StraightRack> rack_leaving_root(const CylindricalSpec& spec, double root_diameter,
                                       std::optional<double> root_form_diameter);

}  // namespace gearwright
