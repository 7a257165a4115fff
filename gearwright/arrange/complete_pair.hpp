// Computes the profile shifts, the centre distance and the shaft angle of a pair, as far as
// they are not given. Internal to arrange/.
#pragma once

#include <optional>
#include <vector>

#include "gearwright/arrange/given_pair.hpp"
#include "gearwright/pair/partners.hpp"

namespace gearwright {

/// Returns the position of the gears of the pair. Computed shifts and the diameters of shortened
/// tips are written into the gears of `given`. If the shaft angle is computed from the centre
/// distance, it is written into `given.pair`. `shift_wanted` is true if at least one shift is
/// absent and must be computed from the centre distance. If both are absent, divided_shift_sum()
/// divides their sum. However, if this sum is at most −0.4 in an internal pair, a pinion cut by a
/// rack gets at least the shift that avoids undercut, and the internal gear gets the rest.
///
/// Domain    two gears (contract)
/// Errors    `gear2.helix_angle` if a sign seems to be missing; `gearN.profile_shift`,
///           `pair.mounting` or `pair.shorten_tips` if this value requires a single rack but the
///           racks differ; the errors of check_partners, complete_shifts and complete_place. An
///           error of `profile_shift` names the given shift
Result<PairPlace> complete_pair(GivenPair& given, bool shift_wanted);

/// Returns the name of the member with the requested backlash, such as "pair.backlash".
const char* backlash_field(const PairInput& pair);

/// Sets the thickness allowances of both gears so that the mounted pair has the requested backlash.
/// `backlash_split` divides the thinning between the gears.
///
/// Accuracy  1e-9 mm or degrees; relative to the backlash if this exceeds 1
/// Domain    given.pair.wants_backlash(), two gears cut by racks, both shifts known (contract)
/// Errors    `pair.backlash…` if no allowances give this backlash; `pair` if the pair has no
///           contact; the errors of make_gear and mount for the gears before thinning
std::optional<Error> thin_for_backlash(GivenPair& given, const std::optional<PairPlace>& place,
                                       std::vector<Warning>& warnings);

/// Sets the thickness allowances of the pinion and of the rack so that they have the requested
/// backlash, and returns the total thinning, mm. `nominal` has the teeth without thinning.
///
/// Formula   the backlash is a linear function of the allowances, [T2.36], [T2.37]
/// Domain    given.pair.wants_backlash() and given.rack (contract)
double thin_rack_for_backlash(GivenPair& given, const RackPair& nominal);

/// Returns the error of a pinion or rack that cannot be made with the allowances of
/// thin_rack_for_backlash(). It names the requested backlash.
Error of_backlash(const Error& error, const GivenPair& given);

/// Returns a warning if the thinning is negative, so that the teeth are thicker than as cut.
std::optional<Warning> thickened_warning(const PairInput& pair, double thinning);

}  // namespace gearwright
