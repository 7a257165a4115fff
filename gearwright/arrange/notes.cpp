#include "gearwright/arrange/notes.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "gearwright/base/lists.hpp"
#include "gearwright/base/number_text.hpp"
#include "gearwright/base/subject.hpp"
#include "gearwright/base/units.hpp"
#include "gearwright/pair/saddle_gap.hpp"
#include "gearwright/rating/root.hpp"

namespace gearwright {

namespace {

// Lists the computed shifts, for example "`gear1.profile_shift` = 0.433 and `gear2.profile_shift` =
// 0.14".
std::string chosen_shifts(const GivenPair& given) {
  std::string text;
  for (const int which : {1, 2}) {
    const GearInput& gear = given.gear(which);
    if (gear.shift_given) continue;
    text +=
        fmt::format("{}`{}` = {}", text.empty() ? "" : " and ", gear_field(which, "profile_shift"),
                    format_number(gear.cylindrical.profile_shift));
  }
  return text;
}

}  // namespace

bool shifts_follow(const GivenPair& given) {
  const auto& [one, two] = given.gears;
  return one && two && given.pair.center_distance && !(one->shift_given && two->shift_given);
}

std::optional<Error> forbidden_shifts(const GivenPair& given) {
  if (given.pair.choose_profile_shifts) return std::nullopt;
  return absent_input(
      gear_field(given.gears[0]->shift_given ? 2 : 1, "profile_shift"),
      fmt::format(" and is not computed, because `pair.choose_profile_shifts` = false. For "
                  "`pair.center_distance` = {} mm, the default would be {}. Give the profile "
                  "shifts, which determine the backlash",
                  format_number(*given.pair.center_distance), chosen_shifts(given)));
}

std::optional<Warning> note_shifts(const GivenPair& given) {
  if (!shifts_follow(given)) return std::nullopt;
  constexpr double kRounding = 1e-12;  // modules; a smaller shift is a rounding error
  constexpr double kNoSum = 1e-6;      // modules; a smaller sum of the shifts counts as 0
  double greatest = 0.0;
  for (const auto& gear : given.gears)
    if (!gear->shift_given)
      greatest = std::max(greatest, std::abs(gear->cylindrical.profile_shift));
  if (greatest < kRounding) return std::nullopt;
  // If the sum is 0, gears without profile shift have the same centre distance. The user may
  // have meant such gears, because old and interchangeable gears are cut without profile shift.
  const double sum =
      given.gears[0]->cylindrical.profile_shift + given.gears[1]->cylindrical.profile_shift;
  const bool standard =
      !given.gears[0]->shift_given && !given.gears[1]->shift_given && std::abs(sum) < kNoSum;
  return Warning{
      WarningCode::profile_shifts_chosen,
      fmt::format("For the centre distance a = {} mm these profile shifts were chosen: {}.{}",
                  format_number(*given.pair.center_distance), chosen_shifts(given),
                  standard ? " Gears without profile shift have this centre distance, too; for "
                             "such gears, give `gear1.profile_shift` = 0."
                           : ""),
      0};
}

std::optional<Warning> note_rack(const GearInput& gear, int which) {
  constexpr const char* kStandard = "AGMA-14.5";
  const AgmaRack& standard = *agma_rack(kStandard);
  const Angle difference = gear.cylindrical.normal_pressure_angle - standard.normal_pressure_angle;
  if (gear.rack_given || gear.cut_by || gear.basic || std::abs(difference.deg()) > 1e-6)
    return std::nullopt;
  return Warning{
      WarningCode::default_rack,
      fmt::format("`rack` is not given; ISO53-A with a dedendum of {:g} modules is used. "
                  "For standard gears with a pressure angle of {:g}°, give `rack` = \"{}\", which "
                  "has a dedendum of {:g} modules.",
                  dedendum_of(gear.cylindrical.rack), standard.normal_pressure_angle.deg(),
                  kStandard, standard.rack.dedendum),
      which};
}

std::optional<Warning> note_saddle(const GivenPair& given, const Pair& pair) {
  if (!pair.mounted().crossed_inside()) return std::nullopt;
  const CrossedPair* p = pair.as<CrossedPair>();
  if (!p->flanks_meet()) return std::nullopt;
  const auto clears = [&](std::size_t right_or_left) {
    // The right flanks of the pinion touch the left flanks of the internal gear.
    return clears_beside_line(p->input, p->mesh,
                              {given.gear(1).modifications[right_or_left].lead_crowning,
                               given.gear(2).modifications[1 - right_or_left].lead_crowning});
  };
  if (clears(0) && clears(1)) return std::nullopt;
  std::string means;
  for (const int which : {1, 2}) {
    const auto& needed = p->needed_crowning[which - 1];
    if (!needed) continue;
    means += fmt::format("{}more than {:.2f} µm on gear {}", means.empty() ? "" : ", or ",
                         rounded_up(kUmPerMm * *needed, 2), which);
  }
  return Warning{
      WarningCode::saddle_gap,
      fmt::format("The flanks are tangent on the line of action and overlap beside it, so edges "
                  "touch and the ratio is not constant. Lead crowning prevents the overlap: {}.",
                  means),
      0};
}

Warning not_read(const std::string& what) {
  return {WarningCode::not_read, what + " is not supported in this version and was ignored.", 0};
}

void add_new(std::vector<Warning> found, std::vector<Warning>& warnings, std::string_view before) {
  for (Warning& w : found) {
    if (is_in(w, warnings)) continue;
    w.message.insert(0, before);
    warnings.push_back(std::move(w));
  }
}

namespace {

// Returns a warning if the rim between roots and bore is thinner than Y_B of a rating allows.
std::optional<Warning> thin_rim(const Gear& gear, int which) {
  const double root = gear.root_diameter / 2;
  const double module = gear.spec.normal_module;
  const double height = std::abs(gear.tip_diameter / 2 - root);
  const LeastRim least = least_rim(gear.side(), module, height);
  const double rim = gear.side() * (root - bore_reach(*gear.bore));
  if (rim > least.thickness) return std::nullopt;
  return Warning{
      WarningCode::thin_rim,
      fmt::format(
          "The rim between the roots and the {} is {:.4f} mm thick, but ISO 6336-3 defines the rim "
          "thickness factor only above {:.4f} mm, {}. A rating uses only a rim thickness that is "
          "given in [rating].",
          gear.internal()           ? "outside diameter"
          : gear.bore->has_keyway() ? "keyway"
                                    : "bore",
          rim, least.thickness, least.words),
      which};
}

}  // namespace

std::optional<Error> body_error(const Gear& gear, const std::optional<Bore>& bore,
                                std::optional<double> groove) {
  return hole_error(bore, {gear.internal(), gear.root_diameter / 2, groove});
}

std::optional<Warning> body_warning(const Gear& gear, std::optional<double> groove, int which) {
  const std::optional<Bore>& bore = gear.bore;
  if (!bore || !gear.exists()) return std::nullopt;
  if (groove) *groove /= 2;
  const auto error = body_error(gear, bore, groove);
  if (!error) return thin_rim(gear, which);
  const bool keyway = subject_of(error->field).member == GearMember::keyway;
  return Warning{
      WarningCode::no_body,
      fmt::format("A {} of {} mm {}: {}.", keyway ? "keyway" : "bore", error->value,
                  keyway ? "is not possible" : "leaves no material for the body of the gear",
                  error->rule),
      which};
}

}  // namespace gearwright
