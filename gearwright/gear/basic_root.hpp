// The rack that cuts a given root, which determines the dedendum of a gear given by its base
// cylinder.
//
//   d_f, d_Ff   root and root form diameter, mm     h_fP*, ρ_fP*, h_Ff*  of the rack, in modules
//                                              theory: docs/theory/04-conjugate-action.md, 4.2
#pragma once

#include <optional>

#include "gearwright/base/result.hpp"
#include "gearwright/gear/gear.hpp"

namespace gearwright {

/// The rack of `spec` with the dedendum that leaves d_f and, when d_Ff is given, the tip rounding
/// whose fillet begins there.
///
/// Formula   h_fP* = x_E ± (d − d_f)/(2 m_n), h_Ff* = x_E − (ρ_F − ρ_C) sin α_t/m_n,
///           ρ_fP* = (h_fP* − h_Ff*)/(1 − sin α_n); [T4.4]
/// Errors    `root_diameter`, `root_form_diameter`: what is allowed (no fillet form if internal
///           is taken: a rack does not cut it)
Result<StraightRack> rack_leaving_root(const CylindricalSpec& spec, double root_diameter,
                                       std::optional<double> root_form_diameter);

}  // namespace gearwright
