// Tooth contact of a pinion with its rack under errors of mounting.
//
// The analysis is the same as for two gears, but with the travel of the rack instead of the
// rotation of gear 2 [T8.29]. Travel and its error are stored as angles x/r, where r is the
// reference radius of the pinion. A positive travel has the direction −y of the housing. The rim of
// an external gear 2 moves in the same direction.
//
//   const auto touching = contact(*rack_pair, {.crossing = 0.02_deg});
//   if (touching) use(touching->rack.of(touching->peak_to_peak));   // mm
#pragma once

#include <memory>
#include <optional>

#include "gearwright/contact/pair_contact.hpp"
#include "gearwright/pair/rack_pair.hpp"

namespace gearwright {

struct RackContact : ContactResult {
  RackContact() = default;  ///< empty; contact() fills it
  /// The contact of the non-working flanks at the same positions.
  ContactResult non_working;
  /// Peak to peak of the continuous curve; none if contact is lost at a position.
  std::optional<Angle> continuous_span;
  std::optional<Angle> min_play;  ///< least play of the rack, as travel/r; < 0 if the teeth jam
  std::shared_ptr<const ContactPair> pair;  ///< also keeps the pinion and its modifications alive
};

/// Returns an error if `errors.helix_twist[1]` or `errors.cutter_lead[1]` is not 0, because errors
/// of the teeth of a rack are not supported.
std::optional<Error> check_rack_errors(const ContactErrors& errors);

/// Makes the pair of a pinion and a rack for contact analyses. The result owns the pinion.
///
/// Units     mm, rad; `options.modifications[1]` must be empty (contract)
/// Errors    `gear1` if the pinion has no usable flank; `gear1.modifications.…` as
///           make_removal_field; `errors.cutter_lead[0]` as check_cutter_lead; as check_rack_errors
Result<std::shared_ptr<const ContactPair>> contact_pair(const RackPair& pair,
                                                        const ContactErrors& errors = {},
                                                        const ContactOptions& options = {});

/// Analyses the contact of a pinion and a rack under errors.
///
/// Errors    as contact_pair and check_request
/// Accuracy  as analyse_contact
/// Laws      (1) without errors and modifications, the transmission error is constant, at every
///           centre distance   (2) if a wheel with z2 teeth replaces the rack, the result differs
///           by the order of 1/z2
Result<RackContact> contact(const RackPair& pair, const ContactErrors& errors = {},
                            const ContactOptions& options = {});

}  // namespace gearwright
