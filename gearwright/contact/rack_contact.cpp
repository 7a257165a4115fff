#include "gearwright/contact/rack_contact.hpp"

#include <algorithm>

#include "gearwright/contact/contact_setup.hpp"
#include "gearwright/contact/continuous.hpp"
#include "gearwright/gear/gear.hpp"

namespace gearwright {

std::optional<Error> check_rack_errors(const ContactErrors& errors) {
  const bool slope = errors.helix_twist[1] != 0.0;
  if (!slope && errors.cutter_lead[1] == Angle()) return std::nullopt;
  return Error{
      slope ? "errors.helix_twist[1]" : "errors.cutter_lead[1]", "",
      "must be 0, because errors of the teeth of a rack are not supported; give the error for the "
      "pinion, where it has the same effect"};
}

Result<std::shared_ptr<const ContactPair>> contact_pair(const RackPair& pair,
                                                        const ContactErrors& errors,
                                                        const ContactOptions& options) {
  const auto& [right, left] = options.modifications[0];
  GW_EXPECTS(!any_modification(options.modifications[1]));
  auto made = SetupGear::of(pair.pinion, 1, errors.cutter_lead[0]);
  if (!made) return made.error();
  if (auto error = check_rack_errors(errors)) return *error;
  SetupGear pinion = std::move(made).take();
  const auto& influences = options.request.influences;
  const bool wanted = std::any_of(influences.begin(), influences.end(),
                                  [](const Influence& i) { return i.modified_gear == 1; });
  if (auto error = pinion.modify(1, {right, left}, wanted)) return *error;
  ContactMount mount;
  mount.center_distance = pair.center_distance;
  mount.errors = errors;
  mount.gear2_drives = options.gear2_drives;
  struct Held {
    SetupGear pinion;
    ContactPair pair;
  };
  const auto held =
      std::make_shared<const Held>(Held{pinion, ContactPair(pinion.flanks(), pair.rack, mount)});
  return std::shared_ptr<const ContactPair>(held, &held->pair);
}

Result<RackContact> contact(const RackPair& pair, const ContactErrors& errors,
                            const ContactOptions& options) {
  if (auto error = check_request(options.request)) return *error;
  auto driving = contact_pair(pair, errors, options);
  if (!driving) return driving.error();
  ContactOptions reversed = options;
  reversed.gear2_drives = !options.gear2_drives;
  reversed.request.influences.clear();
  const auto other = contact_pair(pair, errors, reversed);
  if (!other) return other.error();

  RackContact found;
  found.pair = std::move(driving).take();
  static_cast<ContactResult&>(found) = analyse_contact(*found.pair, options.request);
  found.non_working = analyse_contact(**other, reversed.request);
  found.min_play = least_play(found, found.non_working, options.gear2_drives);
  found.continuous_span = continuous_span(*found.pair, options.request.positions);
  return found;
}

}  // namespace gearwright
