// The whole contact analysis of a mesh: both flanks, the pattern, a map of errors, and the halves of
// double-helical gears. The verb `contact` and the drive return it.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "gearwright/contact/contact.hpp"
#include "gearwright/contact/error_map.hpp"
#include "gearwright/contact/pattern.hpp"

namespace gearwright {

/// A number for which derivatives were requested, with its name in results.
struct NamedSlope {
  std::string name;   ///< "center_distance_per_mm"
  double unit = 1.0;  ///< the unit that `name` ends with, in mm or rad; π/180 for "…_per_deg"
};

/// A contact analysis with the results of additional requests. For a double-helical pair, the whole
/// gears are analysed. One gear floats along its axis, so both halves share the load
/// (contact/halves.hpp). The analysis of the whole gears has no pattern.
struct ContactView {
  ContactResult driving;            ///< the working flanks for the given driving gear
  ContactResult other;              ///< the non-working flanks, at the same positions
  double marking = 0.0;             ///< thickness of the marking compound, mm
  std::optional<Angle> min_play{};  ///< play of gear 2 between its flanks; < 0 if the gears jam
  /// The peak to peak of the continuous transmission error of the working flanks, or none if
  /// contact is lost.
  std::optional<Angle> continuous_span{};
  std::vector<NamedSlope> slopes{};  ///< one entry for each requested derivative
  std::optional<ErrorMap> map{};
  std::array<std::string, 2> map_axes{};                ///< names of the errors x and y of the map
  std::optional<std::array<FlankRaster, 2>> pattern{};  ///< pattern on both gears; none if
                                                        ///< [contact] does not request a pattern
  std::vector<ContactView> halves{};  ///< the halves of a double-helical pair, z > 0 and z < 0
  std::vector<double> float_axial{};  ///< Δz  mm, of gear 1 relative to gear 2 at each position;
                                      ///< empty without double-helical gears
};

}  // namespace gearwright
