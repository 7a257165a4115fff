#include "gearwright/gear/double_helical.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "gearwright/base/contract.hpp"
#include "gearwright/base/number_text.hpp"
#include "gearwright/gear/gear.hpp"

namespace gearwright {

namespace {

constexpr double kSameLength = 1e-9;  // relative rounding error of a length computed in two ways

}  // namespace

std::optional<Error> half_error(const DoubleHelical& given, double face) {
  if (given.gap < face) return std::nullopt;
  return refused("double_helical.gap", given.gap, {face},
                 "must be less than the face width {} mm, which includes both halves and the gap");
}

std::optional<Error> mates_error(const std::array<std::optional<DoubleHelical>, 2>& halves,
                                 const std::array<double, 2>& faces) {
  GW_EXPECTS(halves[0] || halves[1]);
  if (halves[0].has_value() != halves[1].has_value()) {
    const int lacking = halves[0] ? 2 : 1;
    return absent_input(
        gear_field(lacking, "double_helical"),
        "; the mating gear is double-helical, so this gear must be double-helical too");
  }
  const auto& [one, two] = halves;
  if (one->stagger_pitches != two->stagger_pitches) {
    return refused(gear_field(2, "double_helical.stagger_pitches"), two->stagger_pitches,
                   fmt::format("must be {}, as for gear 1, because the halves of both gears must "
                               "have the same stagger",
                               format_number(one->stagger_pitches)));
  }
  const auto& [b_1, b_2] = faces;
  const double common = (std::min(b_1, b_2) - std::max(one->gap, two->gap)) / 2;
  const double narrower = std::min(b_1 - one->gap, b_2 - two->gap) / 2;
  if (common >= narrower * (1 - kSameLength)) return std::nullopt;
  return refused(gear_field(2, "double_helical.gap"), two->gap,
                 fmt::format("the halves are not opposite each other, because only {:.6g} mm of "
                             "the narrower half ({:.6g} mm wide) overlap with the mating half; the "
                             "gear with the narrower halves must have the wider gap between its "
                             "halves",
                             common, narrower));
}

}  // namespace gearwright
