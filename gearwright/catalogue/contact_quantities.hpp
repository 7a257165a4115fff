// The quantities of tooth contact, with positions, patterns and maps. A result contains them under
// `contact`.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "gearwright/catalogue/quantity.hpp"
#include "gearwright/contact/contact.hpp"
#include "gearwright/contact/error_map.hpp"
#include "gearwright/contact/pattern.hpp"

namespace gearwright {

/// A number for which derivatives were requested, with its name in results.
struct NamedSlope {
  std::string name;   ///< "center_distance_per_mm"
  double unit = 1.0;  ///< one unit of the number, in rad or mm
};

/// A contact analysis with the results of additional requests. For a double-helical pair, it is the
/// analysis of the whole gears.
struct ContactView {
  const ContactResult* working;      ///< the working flanks
  const ContactResult* non_working;  ///< the non-working flanks, at the same positions
  double marking = 0.0;              ///< thickness of the marking compound, mm
  std::optional<Angle> min_play{};   ///< least backlash as rotation of gear 2; < 0 if the gears jam
  std::vector<NamedSlope> slopes{};  ///< one entry for each requested derivative
  const std::array<FlankRaster, 2>* pattern = nullptr;
  const ErrorMap* map = nullptr;
  std::array<std::string, 2> map_axes{};             ///< names of the errors x and y of the map
  std::optional<Angle> continuous_span{};            ///< peak-to-peak value of the continuous
                                                     ///< transmission error
  const std::vector<double>* float_axial = nullptr;  ///< Δz  mm, of gear 1 relative to gear 2 at
                                                     ///< each position; null for a single helix
  std::vector<ContactView> halves{};  ///< the halves of a double-helical pair, z > 0 and z < 0
};

const Quantities<ContactView>& contact_quantities();
const Quantities<ContactPoint>& position_quantities();

}  // namespace gearwright
