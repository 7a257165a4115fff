// Computes the gap beside the line of action of an internal pair on crossed axes. The flanks touch
// on the line of action, and the gap around a point of contact has the shape of a saddle. Without
// crowned leads, the flanks therefore overlap on two sides of the point.
//
//   η     angle between the generators (straight lines) of the two flanks, in the tangent plane
//   λ_i   distance of the contact from base tangent point i along the line of action; flank i is
//         curved by 1/λ_i across its generator and straight along it
//   L     distance of the base tangent points, mm, λ_2 = λ_1 + L
//   K_i   = 8 C_βi cos² β_bi/b_i²  1/mm: curvature of the lead crowning C_βi along the generator
//                                              theory: docs/theory/04-conjugate-action.md, 4.11
#pragma once

#include <array>
#include <optional>

#include "gearwright/pair/mesh.hpp"

namespace gearwright {

/// Returns, for each gear, the least lead crowning, mm, if only this gear is crowned. With this
/// crowning, the flanks do not overlap beside any point of the path. Returns none for a gear if
/// crowning only this gear is not sufficient.
///
/// Formula   [T4.36], at the end of the path at which the result is greater
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
