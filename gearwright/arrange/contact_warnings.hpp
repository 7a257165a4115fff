// The warnings about the contact of a pair with errors of mounting. They state facts that the
// numbers of the contact analysis do not show.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "gearwright/contact/contact.hpp"
#include "gearwright/gear/warning.hpp"

namespace gearwright {

/// Warns if the gears jam, see jams(). `touched` is the part of the message that names the surfaces
/// in contact at the same time: "both flanks of a tooth space are".
void warn_of_jam(Angle least_play, const Gear& moved, RackTravel rack, std::string_view touched,
                 std::vector<Warning>& warnings);

/// Warns of a jam, of lost contact, of contact below the usable flanks, and of searches that did
/// not converge. `least_play` is none if the driving flanks or the other flanks never touch. For a
/// pinion and its rack, `gears` contains only the pinion.
void warn_of_contact(const ContactResult& driving, const ContactResult& other,
                     std::optional<Angle> least_play, const std::vector<const Gear*>& gears,
                     std::vector<Warning>& warnings);

}  // namespace gearwright
