// Notes on the input (profile shifts that follow from the centre distance, flanks that overlap,
// keys that were ignored) and warnings about the contact.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "gearwright/arrange/given_pair.hpp"
#include "gearwright/contact/contact.hpp"
#include "gearwright/gear/gear.hpp"
#include "gearwright/gear/warning.hpp"
#include "gearwright/pair/pair.hpp"

namespace gearwright {

/// True if at least one profile shift is absent and is computed from the given centre distance.
bool shifts_follow(const GivenPair& given);

/// Returns a note that lists the computed shifts, which are in `cylindrical`. Returns none if no
/// shift is computed or if all computed shifts are 0.
std::optional<Warning> note_shifts(const GivenPair& given);

/// Returns a note about a gear with the pressure angle 14.5° whose rack is not given. The note
/// names the standard rack of this pressure angle. Returns none if the gear has `cut_by` or
/// `basic`.
std::optional<Warning> note_rack(const GearInput& gear, int which);

/// Returns an error if `pair.choose_profile_shifts` is false. The message names the absent shifts
/// and the values that they would have by default.
///
/// Domain    shifts_follow(given), with computed shifts
std::optional<Error> forbidden_shifts(const GivenPair& given);

/// Returns a note that, on crossed axes, the flanks of an internal pair overlap beside the line of
/// action. Returns none if the lead crowning in `given` prevents the overlap in both directions of
/// rotation.
std::optional<Warning> note_saddle(const GivenPair& given, const Pair& pair);

/// Appends to `warnings` each warning of `found` that `warnings` does not contain yet. The message
/// of each appended warning begins with the text `before`.
void add_new(std::vector<Warning> found, std::vector<Warning>& warnings,
             std::string_view before = {});
inline constexpr std::string_view kSecondHalf = "Half at z < 0: ";

/// Returns the warning that the key or table `what` was ignored.
Warning not_read(const std::string& what);

/// Returns the error of hole_error() if a bore or rim leaves too little material to the roots of
/// the gear or to its groove. `groove` is the radius of the groove, mm.
std::optional<Error> body_error(const Gear& gear, const std::optional<Bore>& bore,
                                std::optional<double> groove = {});

/// Returns a warning about the body of a gear. For an external gear, the warning states that the
/// bore leaves no material below the roots, or that its keyway is not possible. For an internal
/// gear, it states that the rim leaves no material outside the roots. For both, it states that the
/// rim is too thin for the rim thickness factor of a rating. In a double-helical gear, the groove
/// with the diameter `groove` mm also limits the body.
std::optional<Warning> body_warning(const Gear& gear, std::optional<double> groove, int which);

/// Warns if the gears jam, see jams(). `touched` is a part of the message. The text names the
/// surfaces that are in contact at the same time, for example "both flanks of a tooth space are".
void warn_of_jam(Angle least_play, const Gear& moved, RackTravel rack, std::string_view touched,
                 std::vector<Warning>& warnings);

/// Warns of a jam, of lost contact, of contact at the root end of the usable flank of a gear
/// without undercut, and of searches that did not converge. `least_play` is none if the flanks of
/// `driving` or of `other` never touch. For a pinion and its rack, `gears` contains only the
/// pinion.
void warn_of_contact(const ContactResult& driving, const ContactResult& other,
                     std::optional<Angle> least_play, const std::vector<const Gear*>& gears,
                     std::vector<Warning>& warnings);

}  // namespace gearwright
