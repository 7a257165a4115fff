// The flanks of an internal pair on crossed axes beside their line of action: both touch there, but
// the gap is a saddle, so that they overlap on two sides until a lead is crowned.
//
//   η     angle between the straight lines of the two flanks, in their common tangent plane
//   λ_i   distance of the contact from base tangent point i along the line, λ_2 = λ_1 + L; the
//         curvature of flank i is 1/λ_i across its straight line, and 0 along it
//   K_i   = 8 C_βi cos² β_bi/b_i²  1/mm: curvature of the lead crowning C_βi along that line
//                                              theory: docs/theory/04-conjugate-action.md, 4.11
#pragma once

#include <array>
#include <optional>

#include "gearwright/pair/mesh.hpp"

namespace gearwright {

/// Lead crowning of each gear alone above which the flanks clear each other beside every point of
/// their path, mm; none if the crowning of that gear alone is not sufficient.
///
/// Formula   [T4.36], at the end of the path at which it is greatest
/// Domain    a crossed internal pair with L > 0 (contract)
std::array<std::optional<double>, 2> needed_crowning(const MeshInput<double>& in,
                                                     const Mesh<double>& mesh);

/// True if these lead crownings, mm, make the gap positive beside every point of the path.
///
/// Formula   [T4.35]
/// Domain    as needed_crowning
bool clears_beside_line(const MeshInput<double>& in, const Mesh<double>& mesh,
                        const std::array<double, 2>& crowning);

}  // namespace gearwright
