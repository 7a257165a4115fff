#include "gearwright/scatter/grades.hpp"

#include <cmath>

#include "gearwright/arrange/measured_gear.hpp"
#include "gearwright/base/units.hpp"
#include "gearwright/inspection/evaluation_ranges.hpp"

namespace gearwright {

std::optional<GradedFlank> graded_flank(const Gear& gear, FlankTolerances edition, int quality) {
  GW_EXPECTS(has_class(edition, quality));
  const auto ranges = gear.involute() ? evaluation_ranges(gear) : std::nullopt;
  if (!ranges) return std::nullopt;
  const FlankToleranceValues t = flank_tolerances(edition, quality, tolerance_subject(gear));
  const double profile = std::abs((ranges->tip_form.length - ranges->root_form.length) /
                                  (ranges->profile[1] - ranges->profile[0]));
  const double helix = std::abs(gear.spec.face_width / (ranges->helix[1] - ranges->helix[0]));
  return GradedFlank{kMmPerUm * t.profile_slope * profile,
                     kMmPerUm * t.helix_slope * helix,
                     kMmPerUm * t.profile_form,
                     kMmPerUm * t.helix_form,
                     kMmPerUm * t.cumulative_pitch,
                     kMmPerUm * t.single_pitch,
                     kMmPerUm * t.helix_total};
}

GradedAxes graded_axes(double greater_helix_total, double face_width) {
  return {0.5 * greater_helix_total / face_width, greater_helix_total / face_width};
}

}  // namespace gearwright
