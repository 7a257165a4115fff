#include "gearwright/arrange/two_halves.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "gearwright/gear/gear_field.hpp"

namespace gearwright {

namespace {

constexpr double kSameLength = 1e-9;  // relative, for two ways to compute one length

std::optional<Error> check_half(const GearInput& gear, int which) {
  const DoubleHelical& halves = *gear.double_helical;
  const CylindricalSpec& c = gear.cylindrical;
  if (!gear.face_width_given) {
    return absent_input(gear_field(which, "face_width"),
                        "; for a double-helical gear it includes both halves and the gap");
  }
  if (!(halves.gap < c.face_width)) {
    return refused(
        gear_field(which, "double_helical.gap"), halves.gap, {c.face_width},
        "must be less than the face width {} mm, which includes both halves and the gap");
  }
  return std::nullopt;
}

// The halves of a pair must have equal faces up to the width of the narrower one.
std::optional<Error> check_mates(const GivenPair& given) {
  const std::array halves{given.gear(1).double_helical, given.gear(2).double_helical};
  if (halves[0].has_value() != halves[1].has_value()) {
    const int lacking = halves[0] ? 2 : 1;
    return absent_input(
        gear_field(lacking, "double_helical"),
        fmt::format("; gear {} is double-helical, so its mating gear must be double-helical too",
                    3 - lacking));
  }
  const auto& [one, two] = halves;
  if (one->stagger_pitches != two->stagger_pitches) {
    return refused(
        gear_field(2, "double_helical.stagger_pitches"), two->stagger_pitches,
        fmt::format("must be {}, as for gear 1, because both gears have the same stagger",
                    format_number(one->stagger_pitches)));
  }
  const double b_1 = given.gear(1).cylindrical.face_width;
  const double b_2 = given.gear(2).cylindrical.face_width;
  const double common = (std::min(b_1, b_2) - std::max(one->gap, two->gap)) / 2;
  const double narrower = std::min(b_1 - one->gap, b_2 - two->gap) / 2;
  if (common >= narrower * (1 - kSameLength)) return std::nullopt;
  return refused(
      gear_field(2, "double_helical.gap"), two->gap,
      fmt::format("the halves are not opposite each other, because only {:.6g} mm of the {:.6g} mm "
                  "of the narrower half touch; the wider gap must be on the narrower gear",
                  common, narrower));
}

}  // namespace

std::optional<Error> halve(GivenPair& given) {
  bool any = false;
  for (const int which : {1, 2}) {
    if (!given.has(which) || !given.gear(which).double_helical) continue;
    if (auto error = check_half(given.gear(which), which)) return error;
    any = true;
  }
  if (any && given.has(1) && given.has(2)) {
    if (auto error = check_mates(given)) return error;
  }
  for (auto& gear : given.gears) {
    if (!gear || !gear->double_helical) continue;
    double& face = gear->cylindrical.face_width;
    face = (face - gear->double_helical->gap) / 2;
  }
  return std::nullopt;
}

std::optional<double> groove_diameter(const Gear& half, const DoubleHelical& given) {
  if (!(given.gap > 0.0)) return std::nullopt;
  const double deeper = (half.internal() ? 0.5 : -0.5) * half.spec.normal_module;
  return given.groove_diameter.value_or(half.root_diameter + deeper);
}

Result<Halves> halves_of(const Gear& half, const DoubleHelical& given) {
  const double beta = std::abs(half.spec.helix_angle.rad());
  if (beta == 0.0) {
    return refused("helix_angle", 0,
                   "must not be 0, because the halves of a double-helical gear have helix angles "
                   "of opposite hands, and this is the angle of the half at z > 0");
  }
  Halves made{};
  made.given = given;
  made.half_face_width = half.spec.face_width;
  made.face_width = 2 * half.spec.face_width + given.gap;
  made.axial_shift_per_index_error = 1 / (2 * std::tan(beta));
  made.groove_diameter = groove_diameter(half, given);
  if (made.groove_diameter) {
    const bool ring = half.internal();
    const double root = half.root_diameter;
    if (ring ? !(*made.groove_diameter > root) : !(*made.groove_diameter < root)) {
      return refused(
          "double_helical.groove_diameter", *made.groove_diameter, {root},
          ring ? "must be greater than the root diameter {} mm, because the groove of an "
                 "internal gear is deeper than its teeth"
               : "must be less than the root diameter {} mm, because the groove is deeper "
                 "than the teeth");
    }
  }
  if (!given.hob_diameter) return made;
  const double h = std::abs(half.tip_diameter - half.root_diameter) / 2;
  const double d = *given.hob_diameter;
  if (!(d > 2 * h)) {
    return refused("double_helical.hob_diameter", d, {2 * h},
                   "must be greater than {} mm, twice the depth of the teeth");
  }
  // One hob cuts both hands: it is swivelled by |β| − γ_0 for the half of its own hand, and by |β|
  // + γ_0 for the other one. The gap must suffice for both.
  double run_out = 0.0;
  for (const double side : {-1.0, 1.0}) {
    const double eta = beta + side * given.hob_lead_angle.rad();
    run_out = std::max(run_out, std::sqrt(h * (d - h)) * std::cos(eta) +
                                    given.hob_half_length * std::sin(std::abs(eta)));
  }
  made.hob_run_out = run_out;
  return made;
}

std::optional<Warning> stagger_warning(const Halves& halves, int which) {
  if (halves.given.stagger_pitches == 0.0 || halves.given.gap > 0.0) return std::nullopt;
  return Warning{WarningCode::stagger_without_gap,
                 fmt::format("The halves are staggered by {} pitches without a gap, so their teeth "
                             "do not meet in the middle plane, and there are no files of the gear. "
                             "A `double_helical.gap` greater than 0 separates the halves.",
                             format_number(halves.given.stagger_pitches)),
                 which};
}

std::optional<Warning> run_out_warning(const Halves& halves, int which) {
  if (!halves.hob_run_out || *halves.hob_run_out <= halves.given.gap) return std::nullopt;
  return Warning{WarningCode::hob_run_out,
                 fmt::format("The run-out of the hob needs a gap of at least {:.4f} mm; the gap is "
                             "{:.4f} mm. A smaller hob, a wider gap or shaping would help.",
                             *halves.hob_run_out, halves.given.gap),
                 which};
}

}  // namespace gearwright
