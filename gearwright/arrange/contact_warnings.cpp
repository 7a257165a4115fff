#include "gearwright/arrange/notes.hpp"

#include <fmt/format.h>

#include <array>

#include "gearwright/gear/gear.hpp"

namespace gearwright {

void warn_of_jam(Angle least_play, const Gear& moved, RackTravel rack, std::string_view touched,
                 std::vector<Warning>& warnings) {
  if (!jams(least_play, moved)) return;
  warnings.push_back(
      {WarningCode::jam,
       fmt::format(
           "The {} jam, because {} in contact at the same time. {} would have to yield by {}.",
           rack ? "pinion and the rack" : "gears", touched, rack ? "The rack" : "Gear 2",
           rack ? fmt::format("{:.6f} mm", rack.of(-least_play))
                : fmt::format("{:.6f} degrees", -least_play.deg())),
       0});
}

void warn_of_contact(const ContactResult& driving, const ContactResult& other,
                     std::optional<Angle> least_play, const std::vector<const Gear*>& gears,
                     std::vector<Warning>& warnings) {
  const auto warn = [&](WarningCode code, std::string text, int gear = 0) {
    warnings.push_back({code, std::move(text), gear});
  };
  std::array<bool, 2> below{};
  for (const ContactPoint& p : driving.positions) {
    below[0] = below[0] || p.kind == TouchKind::form1;
    below[1] = below[1] || p.kind == TouchKind::form2;
  }
  for (std::size_t i = 0; i < gears.size(); ++i) {
    const Gear& gear = *gears[i];
    if (!below[i] || gear.undercut) continue;
    warn(WarningCode::contact_below_form,
         fmt::format(
             "Contact reaches the end of the usable flank of gear {} at a diameter of {:.4f} mm, "
             "where the root fillet begins. The tip of the mating gear enters the fillet, where "
             "the true transmission error is larger than the computed error.",
             i + 1, 2 * *gear.root_form_radius()),
         static_cast<int>(i) + 1);
  }
  if (driving.contact_lost)
    warn(WarningCode::contact_lost,
         "Contact is lost at some positions, where no tooth pair touches.");
  if (least_play)
    warn_of_jam(*least_play, *gears.back(), driving.rack, "both flanks of a tooth space are",
                warnings);
  if (driving.unfinished + other.unfinished > 0) {
    warn(WarningCode::contact_search_unfinished,
         fmt::format("{} searches for a contact point did not converge. The result of each search "
                     "is the best point that it found.",
                     driving.unfinished + other.unfinished));
  }
}

}  // namespace gearwright
