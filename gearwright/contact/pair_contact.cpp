#include "gearwright/contact/pair_contact.hpp"

#include <utility>

#include "gearwright/contact/contact_setup.hpp"

namespace gearwright {

Result<std::shared_ptr<const ContactPair>> contact_pair(const Pair& pair,
                                                        const ContactErrors& errors,
                                                        const ContactOptions& options) {
  std::array<bool, 2> fields{};
  for (std::size_t i = 0; i < 2; ++i) {
    // Derivatives with respect to a modification need the field of removed material, even if
    // nothing is removed.
    for (const Influence& influence : options.request.influences)
      fields[i] = fields[i] || influence.modified_gear == static_cast<int>(i) + 1;
  }
  const auto setup = ContactSetup::of(pair, errors, options.modifications, fields);
  if (!setup) return setup.error();
  return setup->shared_pair(errors, options.gear2_drives);
}

std::optional<Error> check_request(const ContactRequest& request) {
  if (request.positions < 2)
    return refused("contact.positions", request.positions, "must be at least 2 for each pitch");
  if (request.pitches < 1) return refused("contact.pitches", request.pitches, "must be at least 1");
  if (!(request.marking > 0.0))
    return refused("contact.marking", request.marking,
                   "must be > 0 mm, because this value is the thickness of the marking compound");
  return std::nullopt;
}

Result<Contact> contact(const Pair& pair, const ContactErrors& errors,
                        const ContactOptions& options) {
  if (auto error = check_request(options.request)) return *error;
  auto touching = contact_pair(pair, errors, options);
  if (!touching) return touching.error();
  Contact contact;
  static_cast<ContactResult&>(contact) = analyse_contact(**touching, options.request);
  contact.pair = std::move(touching).take();
  return contact;
}

}  // namespace gearwright
