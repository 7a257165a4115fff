// The solids of whole gears and of drives, in their places and laid out for printing.
//
// External gears of one body with the same bore are one solid, in which a plain cylinder joins each
// gear to the next one. Such a body is a stepped planet or the intermediate shaft of a train. Gears
// with different bores are separate workpieces, and so are rings.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "gearwright/arrange/two_halves.hpp"
#include "gearwright/cad/toothed_body.hpp"
#include "gearwright/drive/drive_layout.hpp"

namespace gearwright {

/// A gear in its own frame with its bore or, if it is internal, its rim, with both halves if it is
/// double-helical, and with its modifications. The halves of gear 2 are turned in the opposite
/// direction, unless it is internal, so that the halves of mating gears have the same stagger.
///
/// Domain    a gear for which gear_body() returns no error (contract)
/// Errors    `double_helical.gap` if the halves are staggered but have no gap; those of modify()
Result<ToothedBody> body_as_made(const Gear& gear, const std::string& name,
                                 const std::optional<Halves>& halves, int which,
                                 const std::array<FlankModifications, 2>& modifications);

/// Every copy of every solid in its place, in the common frame of one file. Copies refer to the
/// first solid with the same shape. Solids of one body have the same colour. If a gear is not
/// joined to a gear of its body, `separate` gives the reason.
///
/// Errors    a gear without an outline; those of body_as_made()
Result<std::vector<ToothedBody>> drive_solids(const Drive& drive, const DriveLayout& layout);

/// The same solids laid out side by side on the plane z = 0 for printing. The wider end of a solid
/// with several gears is below.
std::vector<ToothedBody> laid_out(std::vector<ToothedBody> bodies);

}  // namespace gearwright
