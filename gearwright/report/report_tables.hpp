// Writes the tables of the page, for gears side by side and for the pair. html_text.hpp defines the
// numbers of digits.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "gearwright/arrange/two_halves.hpp"
#include "gearwright/catalogue/gear_quantities.hpp"
#include "gearwright/catalogue/quantity.hpp"
#include "gearwright/report/report.hpp"

namespace gearwright {

/// "Gear 1", "Gear 2"
std::vector<std::string> gear_headings(std::size_t gears);

/// Writes the data of the drawing, the derived values and the data of the cutters, with one column
/// for each gear. If a gear is double-helical, `gears` contains one of its halves.
std::string gear_table(const std::vector<const Gear*>& gears,
                       const std::array<std::optional<Halves>, 2>& halves,
                       UnitSystem units = UnitSystem::mm);

/// Writes the additional data of gears with few teeth, which are the points F, C and J and the
/// circular fillets. The symbols are defined in gear_figures.hpp. The result is empty if no gear
/// has such data.
std::string few_teeth_table(const std::vector<const Gear*>& gears,
                            UnitSystem units = UnitSystem::mm);

/// Writes the quantities that the catalogue defines for a pair, under their headings.
std::string pair_table(const Pair& pair, UnitSystem units);

/// Writes the points A to E with their distances from the pitch point, radii of curvature and
/// sliding.
std::string path_table(const InvolutePair& pair, UnitSystem units);

/// Writes the interferences with their names and amounts. If there are none, a sentence states
/// this.
std::string interference_table(const InvolutePair& pair, UnitSystem units);

/// Writes a box for each available key figure. These are ratio or travel, centre distance, contact
/// ratio, backlash (at both ends of the tolerances), mass, safety factors, torque, contact
/// pressure, transmission error and its greatest percentile. The result is empty if there are no
/// key figures.
std::string key_figures(const ReportInput& input);

/// Writes one box for each key for which the records have a value, in the order of `keys`. If there
/// are several records, a box shows the range from the value of the first record to the value of
/// the last record.
std::string key_boxes(const QuantityTable& table, const std::vector<ValueRecord>& records,
                      std::span<const std::string_view> keys, UnitSystem units);

}  // namespace gearwright
