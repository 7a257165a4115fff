#include "gearwright/contact/rack_contact.hpp"

#include <algorithm>

#include "gearwright/contact/contact_setup.hpp"
#include "gearwright/contact/continuous.hpp"
#include "gearwright/gear/gear.hpp"

namespace gearwright {

namespace {

// A pair and the fields of removed material to which it points.
struct Held {
  std::array<std::shared_ptr<const RemovalField>, 2> removal;
  std::optional<ContactPair> pair;
};

// The error if a rack would have an error of its teeth.
std::optional<Error> rack_error(const ContactErrors& errors) {
  const bool slope = errors.helix_twist[1] != 0.0;
  if (!slope && errors.cutter_lead[1] == Angle()) return std::nullopt;
  return Error{
      slope ? "errors.helix_twist[1]" : "errors.cutter_lead[1]", "",
      "must be 0, because errors of the teeth of a rack are not supported; the error of the "
      "pinion has the same effect"};
}

}  // namespace

Result<RackContact> contact(const RackPair& pair, const ContactErrors& errors,
                            const ContactOptions& options) {
  const auto& [right, left] = options.modifications[0];
  GW_EXPECTS(!any_modification({options.modifications[1].right, options.modifications[1].left}));
  const Gear& pinion = pair.pinion;
  if (!pinion.root_form_radius())
    return Error{gear_field(1), "",
                 "has no usable flank; the warnings of the verb gear give the reason",
                 FailureKind::no_flank};
  if (auto error = rack_error(errors)) return *error;
  if (auto error = check_cutter_lead(pinion, 1, errors.cutter_lead[0])) return *error;

  // Derivatives by a modification need its field, even if nothing is removed.
  const auto& influences = options.request.influences;
  const bool fields = any_modification({right, left}) ||
                      std::any_of(influences.begin(), influences.end(),
                                  [](const Influence& i) { return i.modified_gear == 1; });
  std::array<std::shared_ptr<const RemovalField>, 2> removal;
  for (int side = 0; fields && side < 2; ++side) {
    auto field = make_removal_field(side == 0 ? right : left, flank_extent(pinion));
    if (!field) return of_flank(1, side, field.error());
    removal[static_cast<std::size_t>(side)] =
        std::make_shared<const RemovalField>(std::move(field).take());
  }
  const auto driven_by = [&](bool gear2_drives) {
    ContactMount mount;
    mount.center_distance = pair.center_distance;
    mount.errors = errors;
    mount.gear2_drives = gear2_drives;
    const auto held = std::make_shared<Held>(Held{removal, {}});
    held->pair.emplace(ContactGear{&pinion, {removal[0].get(), removal[1].get()}}, pair.rack,
                       mount);
    return std::shared_ptr<const ContactPair>(held, &*held->pair);
  };

  RackContact found;
  found.pair = driven_by(options.gear2_drives);
  static_cast<ContactResult&>(found) = analyse_contact(*found.pair, options.request);
  ContactRequest other = options.request;
  other.influences.clear();
  found.non_working = analyse_contact(*driven_by(!options.gear2_drives), other);
  found.min_play = least_play(found, found.non_working, options.gear2_drives);
  found.continuous_span =
      continuous_span(*found.pair, std::max(kLeastSpanPositions, options.request.positions));
  return found;
}

}  // namespace gearwright
