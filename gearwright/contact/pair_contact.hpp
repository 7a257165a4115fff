// Computes the contact of a mounted pair in one call. The result owns all data that it uses.
//
//   const auto touching = contact(*pair, {.crossing = 0.02_deg});
//   if (touching) use(touching->peak_to_peak);
//
// A ContactPair points to its gears and their modifications. The functions of this file copy both.
// The copies live as long as the ContactPair, so `pair` may be destroyed earlier.
#pragma once

#include <array>
#include <memory>
#include <optional>

#include "gearwright/base/result.hpp"
#include "gearwright/contact/contact.hpp"
#include "gearwright/gear/modifications.hpp"
#include "gearwright/pair/pair.hpp"

namespace gearwright {

struct ContactOptions {
  PairModifications modifications{};
  bool gear2_drives = false;  ///< if true, trailing flanks of gear 1 touch
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
/// Errors    `gearN` if the gear has no usable flank; `gearN.modifications.…` as
///           make_removal_field; `errors.cutter_lead[N−1]` as check_cutter_lead
Result<std::shared_ptr<const ContactPair>> contact_pair(const Pair& pair,
                                                        const ContactErrors& errors = {},
                                                        const ContactOptions& options = {});

/// Returns an error if a value of the request lies outside the domain of analyse_contact().
std::optional<Error> check_request(const ContactRequest& request);

/// Analyses the contact of the pair under its errors. Lost contact is not an error. In this case,
/// `contact_lost` is set.
///
/// Errors    as contact_pair and check_request
/// Accuracy  as analyse_contact
Result<Contact> contact(const Pair& pair, const ContactErrors& errors = {},
                        const ContactOptions& options = {});

}  // namespace gearwright
