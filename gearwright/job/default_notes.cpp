#include "gearwright/job/default_notes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "gearwright/base/printable.hpp"
#include "gearwright/gear/gear_field.hpp"

namespace gearwright {

namespace {

// "`gear1.profile_shift` = 0.433 and `gear2.profile_shift` = 0.14": those that nobody gave.
std::string chosen_shifts(const JobSpec& spec) {
  std::string text;
  for (const int which : {1, 2}) {
    const GearInput& gear = *spec.gears[static_cast<std::size_t>(which - 1)];
    if (gear.profile_shift) continue;
    text +=
        fmt::format("{}`{}` = {}", text.empty() ? "" : " and ", gear_field(which, "profile_shift"),
                    format_number(gear.cylindrical.profile_shift));
  }
  return text;
}

}  // namespace

bool shifts_follow(const JobSpec& spec) {
  const auto& [one, two] = spec.gears;
  return one && two && spec.pair.center_distance && !(one->profile_shift && two->profile_shift);
}

std::optional<Error> forbidden_shifts(const JobSpec& spec) {
  if (spec.pair.choose_profile_shifts) return std::nullopt;
  return Error{
      gear_field(spec.gears[0]->profile_shift ? 2 : 1, "profile_shift"), "",
      fmt::format("is missing, and `pair.choose_profile_shifts` = false keeps the program "
                  "from choosing it. At `pair.center_distance` = {} mm it would choose {}; "
                  "give these or others: the backlash follows",
                  format_number(*spec.pair.center_distance), chosen_shifts(spec))};
}

std::optional<Warning> note_shifts(const JobSpec& spec) {
  if (!shifts_follow(spec)) return std::nullopt;
  constexpr double kRounding = 1e-12;  // modules: 0 but for rounding
  double greatest = 0.0;
  for (const auto& gear : spec.gears)
    if (!gear->profile_shift)
      greatest = std::max(greatest, std::abs(gear->cylindrical.profile_shift));
  if (greatest < kRounding) return std::nullopt;
  return Warning{"profile_shifts_chosen",
                 fmt::format("Profile shifts chosen for a = {} mm: {}.",
                             format_number(*spec.pair.center_distance), chosen_shifts(spec)),
                 0};
}

std::optional<Warning> note_inherited(const JobSpec& spec) {
  std::string text;
  for (const std::string& key : spec.inherited) {
    const GearInput& gear = *spec.gears[1];
    const std::string value = key == "quality"     ? fmt::format(" {}", *gear.tolerance.quality)
                              : gear.material.name ? " " + printable(*gear.material.name)
                                                   : "";
    text += fmt::format("{}`{}`{}", text.empty() ? "" : ", ", key, value);
  }
  if (text.empty()) return std::nullopt;
  return Warning{"inherited", fmt::format("Taken from gear 1: {}.", text), 2};
}

}  // namespace gearwright
