#include "gearwright/rating/accuracy.hpp"

#include <cstdlib>

namespace gearwright {

FlankTolerances tolerance_edition(RatingEdition edition) {
  return edition == RatingEdition::iso_2006 ? FlankTolerances::iso_1995 : FlankTolerances::iso_2013;
}

Tolerances tolerances(RatingEdition edition, int grade, const RatedGear& gear, double normal_module,
                      double alpha_t) {
  // None of these tolerances depends on the helix angle, so it is 0 here.
  const ToleranceSubject subject{gear.reference_diameter, normal_module, gear.face_width,
                                 std::abs(gear.teeth),    0.0,           alpha_t};
  const FlankToleranceValues t = flank_tolerances(tolerance_edition(edition), grade, subject);
  return {t.single_pitch, *t.base_pitch, t.profile_form, t.helix_slope};
}

}  // namespace gearwright
