// Makes the solids of whole gears and of drives, at their positions or laid out for printing.
//
// External gears of one body with the same bore are one solid. In this solid, a plain cylinder
// joins each gear to the next one. Gears with different bores, internal gears, racks, and gears
// without room for a cylinder between them are separate workpieces.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "gearwright/arrange/two_halves.hpp"
#include "gearwright/cad/toothed_body.hpp"
#include "gearwright/drive/drive_layout.hpp"

namespace gearwright {

/// Returns the body of a gear in its own frame. The body includes the bore (for an internal gear,
/// the rim), both halves of a double-helical gear, and the flank modifications. `which` is the
/// number of the gear in its pair, 1 or 2. The halves must mesh with the halves of the mating gear.
/// The stagger therefore turns the halves of two external gears in opposite directions. It turns
/// the halves of an external and an internal gear in the same direction.
///
/// Domain    a gear for which gear_body() returns no error (contract)
/// Errors    `double_helical.gap` if the halves are staggered but have no gap; the errors of
///           modify()
Result<ToothedBody> body_as_made(const Gear& gear, const std::string& name,
                                 const std::optional<Halves>& halves, int which,
                                 const BothFlanks& modifications);

/// Returns every copy of every solid, each at its position in the common frame of one file. A copy
/// refers to the first solid with the same shape. Solids of one body have the same colour. If a
/// gear is not joined to the other gears of its body, `separate` contains the reason.
///
/// Errors    a gear without an outline; the errors of body_as_made()
Result<std::vector<ToothedBody>> drive_solids(const Drive& drive, const DriveLayout& layout);

/// Places the solids side by side on the plane z = 0 for printing. A solid with several gears lies
/// on its wider end.
std::vector<ToothedBody> laid_out(std::vector<ToothedBody> bodies);

}  // namespace gearwright
