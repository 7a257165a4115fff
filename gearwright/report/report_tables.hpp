// The tables of the page, for gears side by side and for the pair. Numbers of digits are in
// html_text.hpp.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "gearwright/arrange/two_halves.hpp"
#include "gearwright/catalogue/pair_quantities.hpp"

namespace gearwright {

/// "Gear 1", "Gear 2"
std::vector<std::string> gear_headings(std::size_t gears);

/// Gears side by side: the data of the drawing, the derived values, and how the gears are cut. For
/// double-helical gears, `gears` are halves.
std::string gear_table(const std::vector<const Gear*>& gears,
                       const std::array<std::optional<Halves>, 2>& halves,
                       UnitSystem units = UnitSystem::mm);

/// Additional data of gears with few teeth: the points F, C and J, and circular fillets (symbols in
/// gear_figures.hpp). Empty if no gear has any.
std::string few_teeth_table(const std::vector<const Gear*>& gears,
                            UnitSystem units = UnitSystem::mm);

/// The catalogue's quantities of a pair, under their headings.
std::string pair_table(const Pair& pair, UnitSystem units = UnitSystem::mm);

/// Points A … E: distance from the pitch point, radii of curvature, sliding.
std::string path_table(const InvolutePair& pair, UnitSystem units = UnitSystem::mm);

/// Interference by name and amount, or the sentence that none was found.
std::string interference_table(const InvolutePair& pair, UnitSystem units = UnitSystem::mm);

}  // namespace gearwright
