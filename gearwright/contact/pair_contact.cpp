#include "gearwright/contact/pair_contact.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "gearwright/gear/gear_field.hpp"

namespace gearwright {

namespace {

using SharedPair = std::shared_ptr<const ContactPair>;

// A ContactPair and what it points to, in one piece of memory.
struct Held {
  std::array<Gear, 2> gears;
  std::array<std::array<std::optional<RemovalField>, 2>, 2> removal;
  std::optional<ContactPair> pair;

  ContactGear side(int i) const {
    const auto field = [&](int k) { return removal[i][k] ? &*removal[i][k] : nullptr; };
    return {&gears[i], {field(0), field(1)}};
  }
};

bool any_modification(const FlankModifications& m) {
  for (const Relief* relief : {&m.tip_relief, &m.root_relief, &m.end_relief})
    if (relief->amount != 0.0 || relief->reach) return true;
  return m.topography || m.profile_crowning != 0.0 || m.profile_slope != 0.0 ||
         m.lead_crowning != 0.0 || m.lead_slope != 0.0;
}

}  // namespace

GearModifications on_both_flanks(const FlankModifications& modifications) {
  return {modifications, modifications};
}

Result<SharedPair> contact_pair(const Pair& pair, const ContactErrors& errors,
                                const ContactOptions& options) {
  const auto held = std::make_shared<Held>();
  held->gears = pair.mounted().gears;
  for (int i = 0; i < 2; ++i) {
    const Gear& gear = held->gears[i];
    if (!gear.root_form_radius()) {
      return Error{gear_field(i + 1), "", "has no usable flank to touch with; see its warnings"};
    }
    if (auto error = check_cutter_lead(gear, i + 1, errors.cutter_lead[i])) return *error;
    // Derivatives by a modification need its field, even where nothing is removed.
    const bool asked =
        std::any_of(options.request.influences.begin(), options.request.influences.end(),
                    [&](const Influence& influence) { return influence.modified_gear == i + 1; });
    const GearModifications& flanks = options.modifications[i];
    if (!asked && !any_modification(flanks.right) && !any_modification(flanks.left)) continue;
    for (int k = 0; k < 2; ++k) {
      auto field = make_removal_field(k == 0 ? flanks.right : flanks.left, flank_extent(gear));
      if (!field) return of_flank(i + 1, k, field.error());
      held->removal[i][k] = std::move(field).take();
    }
  }
  const ContactMount mount{pair.center_distance(), pair.shaft_angle(), options.gear2_drives,
                           errors};
  held->pair.emplace(held->side(0), held->side(1), mount);
  return SharedPair(held, &*held->pair);
}

Result<Contact> contact(const Pair& pair, const ContactErrors& errors,
                        const ContactOptions& options) {
  auto touching = contact_pair(pair, errors, options);
  if (!touching) return touching.error();
  Contact contact;
  static_cast<ContactResult&>(contact) = analyse_contact(**touching, options.request);
  contact.pair = std::move(touching).take();
  return contact;
}

std::optional<Error> check_cutter_lead(const Gear& gear, int which, Angle change) {
  if (change == Angle()) return std::nullopt;
  const double delta = change.deg();
  const std::string field = fmt::format("errors.cutter_lead[{}]", which - 1);
  if (gear.twist() == 0.0)
    return refused(field, delta, "a spur gear has no lead to change; give it a helix angle");
  if (gear.cut_by)
    return refused(field, delta,
                   fmt::format("the gear is cut by a gear, whose lead is that of its guide; a "
                               "change of it is `errors.helix_twist[{}]`",
                               which - 1));
  const double lambda = 90.0 - std::abs(gear.spec.helix_angle.deg()) + delta;
  if (lambda > kMinLead.deg() && lambda < kMaxLead.deg()) return std::nullopt;
  return refused(
      field, delta,
      fmt::format("makes the lead angle {} degrees; it must stay between {} and {}",
                  format_number(lambda, kMaxLead.deg()), kMinLead.deg(), kMaxLead.deg()));
}

Error of_flank(int which, int side, Error error) {
  const char* const flank = side == 0 ? "modifications.right" : "modifications.left";
  return of_gear(which, within(flank, std::move(error)));
}

FlankExtent flank_extent(const Gear& gear) {
  return {gear.involute() ? gear.base_radius() : 0.0, gear.root_form_radius().value(),
          gear.tip_form_radius(), gear.spec.face_width};
}

}  // namespace gearwright
