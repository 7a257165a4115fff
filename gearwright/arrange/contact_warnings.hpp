// The warnings about the contact of a pair under errors: facts that its numbers do not show.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "gearwright/contact/contact.hpp"
#include "gearwright/gear/warning.hpp"

namespace gearwright {

/// Warns if the gears jam, see jams(). `touched` names the surfaces that are in contact at once:
/// "both flanks of a tooth space are".
void warn_of_jam(Angle least_play, const Gear& moved, RackTravel rack, std::string_view touched,
                 std::vector<Warning>& warnings);

/// Warns of a jam, of lost contact, of contact below the usable flanks, and of searches that did not
/// converge. `least_play` is none if one of the flanks never touches. For a pinion and its rack,
/// `gears` contains only the pinion.
void warn_of_contact(const ContactResult& driving, const ContactResult& other,
                     std::optional<Angle> least_play, const std::vector<const Gear*>& gears,
                     std::vector<Warning>& warnings);

}  // namespace gearwright
