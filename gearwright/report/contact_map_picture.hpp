// Peak to peak of the transmission error over two errors, as a field of steps.
#pragma once

#include <string>
#include <vector>

#include "gearwright/report/contact_report.hpp"

namespace gearwright {

/// Round levels over the map's values, arc seconds, growing; few enough to tell apart.
std::vector<double> map_levels(const ErrorMap& map);

/// Domain    a map (contract)
std::string map_figure(const ContactReport& report);

}  // namespace gearwright
