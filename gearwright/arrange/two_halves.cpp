#include "gearwright/arrange/two_halves.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "gearwright/gear/gear_field.hpp"

namespace gearwright {

namespace {

constexpr double kSameLength = 1e-9;  // relative, for two ways to compute one length

std::optional<Error> check_half(const GivenPair& given, int which, const DoubleHelical& halves) {
  const GearInput& gear = given.gear(which);
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
std::optional<Error> check_mates(const GivenPair& given, const DoubleHelicals& halves) {
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

std::optional<Error> halve(GivenPair& given, const DoubleHelicals& halves) {
  if (!halves[0] && !halves[1]) return std::nullopt;
  for (const int which : {1, 2}) {
    const auto& half = halves[static_cast<std::size_t>(which - 1)];
    if (!half || !given.has(which)) continue;
    if (auto error = check_half(given, which, *half)) return error;
  }
  if (given.has(1) && given.has(2)) {
    if (auto error = check_mates(given, halves)) return error;
  }
  for (const int which : {1, 2}) {
    const auto& half = halves[static_cast<std::size_t>(which - 1)];
    if (!half || !given.has(which)) continue;
    double& face = given.gear(which).cylindrical.face_width;
    face = (face - half->gap) / 2;
  }
  return std::nullopt;
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
  if (given.gap > 0.0) {
    const bool ring = half.internal();
    const double root = half.root_diameter;
    made.groove_diameter =
        given.groove_diameter.value_or(root + (ring ? 0.5 : -0.5) * half.spec.normal_module);
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

std::optional<Warning> run_out_warning(const Halves& halves, int which) {
  if (!halves.hob_run_out || *halves.hob_run_out <= halves.given.gap) return std::nullopt;
  return Warning{WarningCode::hob_run_out,
                 fmt::format("The run-out of the hob needs a gap of at least {:.4f} mm; the gap is "
                             "{:.4f} mm. A smaller hob, a wider gap or shaping would help.",
                             *halves.hob_run_out, halves.given.gap),
                 which};
}

}  // namespace gearwright
