#include "gearwright/inspection/usable_flank.hpp"

#include <algorithm>

namespace gearwright {

ContactPlace UsableFlank::place(double diameter) const {
  if (contains(diameter)) return ContactPlace::usable;
  if (internal ? diameter > root_end : !(diameter >= root_end)) return ContactPlace::below_flank;
  return (internal ? diameter >= tip : diameter <= tip) ? ContactPlace::on_tip_rounding
                                                        : ContactPlace::beyond_tip;
}

std::optional<UsableFlank> usable_flank(const Gear& gear) {
  if (!gear.involute() || !gear.exists()) return std::nullopt;
  const double d_b = gear.reference().base_diameter;
  UsableFlank flank{0.0, 2 * gear.tip_form_radius(), 2 * gear.actual_tip_radius(), gear.internal()};
  if (gear.internal()) {
    const bool cut = gear.tooth && gear.tooth->form_radius;
    flank.root_end = cut ? 2 * *gear.tooth->form_radius : gear.root_diameter;
    flank.tip_end = std::max(flank.tip_end, d_b);
  } else {
    const auto form = gear.root_form_radius();
    if (!form) return std::nullopt;
    flank.root_end = std::max(2 * *form, d_b);
  }
  if (!(flank.least() < flank.greatest())) return std::nullopt;
  return flank;
}

double v_circle_diameter(const Gear& gear) {
  return gear.reference_diameter +
         gear.side() * 2 * gear.spec.profile_shift * gear.spec.normal_module;
}

double usual_contact_diameter(const Gear& gear, const UsableFlank& flank) {
  const double d_v = v_circle_diameter(gear);
  return flank.contains(d_v) ? d_v : flank.middle();
}

}  // namespace gearwright
