// The closed forms behind `compensate`. Internal to job/.
#pragma once

#include "gearwright/job/compensate_answer.hpp"

namespace gearwright {

/// The tool setting of circular arcs; none unless a rack F cuts one gear and a rack P the other.
std::optional<SettingAnswer> arc_setting(const SolvedJob& job, const ContactSetup& setup);

/// The lead that removes the slope of the transmission error. None for involute gears, which touch
/// along lines and use slopes instead, and if the pair does not touch in the middle of its mesh.
std::optional<LeadAnswer> lead_without_slope(const SolvedJob& job, const ContactSetup& setup);

}  // namespace gearwright
