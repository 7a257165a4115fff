// The flank deviations that a grade of ISO 1328-1 allows, as limits of random variables.
//
//   f_H   limit of the slope deviation over an evaluation range
//   f_f   limit of the form deviation from the line that has the slope deviation
//                                    theory: docs/theory/14-scatter.md, [T14.23]
#pragma once

#include <optional>

#include "gearwright/inspection/flank_tolerances.hpp"
#include "gearwright/scatter/tolerance.hpp"

namespace gearwright {

/// The deviations that a grade allows on the flanks of a gear, mm.
struct GradedFlank {
  double profile_slope;              ///< ± f_Hα, converted from L_α to the whole usable flank
  double helix_slope;                ///< ± f_Hβ, converted from L_β to the whole face
  double profile_form, helix_form;   ///< f_fα, f_fβ
  double total_pitch, single_pitch;  ///< F_p, f_pt
  double helix_total;                ///< F_β
};

/// The deviations that the grade `quality` of an edition of the standard allows for a gear.
///
/// Formula   [T14.23], with the values of flank_tolerances()
/// Domain    a grade of the edition (contract)
/// None      for circular-arc teeth, which the standard does not cover, or if the gear has no
///           evaluation range
std::optional<GradedFlank> graded_flank(const Gear& gear, FlankTolerances edition, int quality);

/// Deviations of parallel axes by ISO/TR 10064-3, ± rad. ISO/TR 10064-3 gives them as lengths in
/// proportion to the bearing span, so the angles do not depend on the span.
///
/// Formula   [T14.23]
struct GradedAxes {
  double crossing, intersecting;
};
GradedAxes graded_axes(double greater_helix_total, double face_width);

}  // namespace gearwright
