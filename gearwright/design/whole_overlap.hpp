// Chooses helix angles for which the overlap ratio is a whole number.
//
//   ε_β = b sin β/(π m_n)   overlap ratio
//
// If the overlap ratio is a whole number, the total length of the contact lines is constant, so the
// stiffness of the mesh hardly varies [T9.14]. The exact helix angle is rounded up to a hundredth
// of a degree, because drawings show helix angles in hundredths of a degree.
//                                              theory: docs/theory/09-design-search.md
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "gearwright/design/search_problem.hpp"

namespace gearwright {

/// The least helix angle that is tried for a whole overlap ratio, degrees. At smaller angles, a
/// hundredth of a degree changes the overlap ratio by more than 1 %.
inline constexpr double kLeastOverlapHelix_deg = 1.0;

/// The band of helix angles, degrees, for callers without a band. From 5° on, an overlap ratio
/// exceeds its whole number by at most 0.2 %. At 30°, the axial force is 58 % of F_t.
inline constexpr std::array kUsualOverlapHelix_deg{5.0, 30.0};

/// Returns the least multiple of 0.01° at which the face width has at least this overlap ratio,
/// degrees. Returns none if the face width is too small for this overlap ratio.
///
/// Formula   [T9.19]
/// Units     module and face width in mm
/// Domain    all numbers > 0
std::optional<double> overlap_helix_deg(double overlap_ratio, double module, double face_width);

/// Returns the least and the greatest face width to be tried for a module. A band of b/d_1 gives
/// the widths for all numbers of teeth of the pinion and all helix angles of the band.
std::array<double, 2> overlap_face_widths(const SearchProblem& problem, double module,
                                          const std::array<double, 2>& band_deg);

/// Returns the choices for every module of the problem, every face width of its bands, and every
/// overlap ratio. The helix angles are of either hand and within the band. The choices are sorted
/// by helix angle, module and face width. For a band of b/d_1, some choices suit only some numbers
/// of teeth; SearchSpace omits the other trials.
std::vector<HelixChoice> whole_overlap_choices(const SearchProblem& problem,
                                               const std::vector<double>& overlap_ratios,
                                               const std::array<double, 2>& band_deg);

/// Sets the choices of a problem with overlap ratios, and their helix angles.
void set_overlap_choices(SearchProblem& problem);

}  // namespace gearwright
