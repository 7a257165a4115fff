// The contact of a mounted pair in one call. The result owns all data that it uses.
//
//   const auto touching = contact(*pair, {.crossing = 0.02_deg});
//   if (touching) use(touching->peak_to_peak);
//
// The caller need not keep `pair`, because its gears and the modifications are copied.
#pragma once

#include <array>
#include <memory>
#include <optional>

#include "gearwright/base/result.hpp"
#include "gearwright/contact/contact.hpp"
#include "gearwright/pair/pair.hpp"

namespace gearwright {

/// For all teeth of a gear. Right and left are defined in gear/modifications.hpp.
struct GearModifications {
  FlankModifications right{}, left{};
};

GearModifications on_both_flanks(const FlankModifications& modifications);

struct ContactOptions {
  std::array<GearModifications, 2> modifications{};  ///< for gear 1, gear 2
  bool gear2_drives = false;                         ///< if true, trailing flanks of gear 1 touch
  ContactRequest request{};
};

/// A contact analysis together with its pair, for example for contact_pattern(*contact.pair, 64).
struct Contact : ContactResult {
  Contact() = default;                      ///< empty; contact() fills it
  std::shared_ptr<const ContactPair> pair;  ///< also keeps gears and modifications alive
};

/// The pair for contact analyses, patterns, maps and CompensationTask::pair_at. It owns its gears.
///
/// Units     mm, rad
/// Errors    `gearN` without a usable flank; `gearN.modifications.…` as make_removal_field;
///           `errors.cutter_lead[N]` as check_cutter_lead
Result<std::shared_ptr<const ContactPair>> contact_pair(const Pair& pair,
                                                        const ContactErrors& errors = {},
                                                        const ContactOptions& options = {});

/// If contact is lost, the result is not an error, but `contact_lost` is set.
///
/// Errors    as contact_pair
/// Domain    `options.request` as analyse_contact (contract)
/// Accuracy  as analyse_contact
Result<Contact> contact(const Pair& pair, const ContactErrors& errors = {},
                        const ContactOptions& options = {});

}  // namespace gearwright
