#include "gearwright/arrange/two_halves.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "gearwright/base/number_text.hpp"
#include "gearwright/base/subject.hpp"
#include "gearwright/gear/gear.hpp"

namespace gearwright {

namespace {

// Returns the error of a gap that leaves the halves less than the least face width. `half` is one
// half of a gear with the given face width.
std::optional<Error> rest_error(const CylindricalSpec& half, double gap, double face_width) {
  const auto error = check_limits(half);
  if (!error || subject_of(error->field).member != GearMember::face_width) return std::nullopt;
  CylindricalSpec whole = half;
  whole.face_width = face_width;
  if (auto of_whole = check_limits(whole)) return of_whole;
  return refused("double_helical.gap", gap, {face_width},
                 fmt::format("leaves each half {} mm of the face width of {{}} mm, but the face "
                             "width of a half {}; a smaller gap would help",
                             format_number(half.face_width), error->rule));
}

}  // namespace

std::optional<Error> halve(GivenPair& given) {
  bool any = false;
  for (const int which : {1, 2}) {
    if (!given.has(which) || !given.gear(which).double_helical) continue;
    const GearInput& gear = given.gear(which);
    if (!gear.face_width_given) return absent_input(gear_field(which, "face_width"), kWholeFace);
    if (auto error = half_error(*gear.double_helical, gear.cylindrical.face_width))
      return of_gear(which, *error);
    any = true;
  }
  if (any && given.has(1) && given.has(2)) {
    const auto& [one, two] = given.gears;
    if (auto error = mates_error({one->double_helical, two->double_helical},
                                 {one->cylindrical.face_width, two->cylindrical.face_width}))
      return error;
  }
  for (const int which : {1, 2}) {
    GearInput* const gear = given.find(which);
    if (!gear || !gear->double_helical) continue;
    const double gap = gear->double_helical->gap, whole = gear->cylindrical.face_width;
    gear->cylindrical.face_width = (whole - gap) / 2;
    if (auto error = rest_error(gear->cylindrical, gap, whole)) return of_gear(which, *error);
  }
  return std::nullopt;
}

std::optional<double> groove_diameter(const Gear& half, const DoubleHelical& given) {
  if (!(given.gap > 0.0)) return std::nullopt;
  const double deeper = -0.5 * half.side() * half.spec.normal_module;
  return given.groove_diameter.value_or(half.root_diameter + deeper);
}

Result<Halves> halves_of(const Gear& half, const DoubleHelical& given) {
  const double beta = std::abs(half.spec.helix_angle.rad());
  if (beta == 0.0) {
    return refused("helix_angle", 0,
                   "must not be 0; this angle is the helix angle of the half at z > 0, and the "
                   "other half has the opposite hand");
  }
  Halves made{};
  made.given = given;
  made.half_face_width = half.spec.face_width;
  made.face_width = 2 * half.spec.face_width + given.gap;
  made.axial_shift_per_index_error = 1 / (2 * std::tan(beta));
  made.groove_diameter = groove_diameter(half, given);
  if (made.groove_diameter) {
    const double root = half.root_diameter;
    if (!(half.side() * *made.groove_diameter < half.side() * root)) {
      return refused("double_helical.groove_diameter", *made.groove_diameter, {root},
                     half.internal()
                         ? "must be greater than the root diameter {} mm, because the groove of "
                           "an internal gear is deeper than its teeth"
                         : "must be less than the root diameter {} mm, because the groove is "
                           "deeper than the teeth");
    }
  }
  if (!given.hob_diameter) return made;
  const double h = std::abs(half.tip_diameter - half.root_diameter) / 2;
  const double d = *given.hob_diameter;
  if (!(d > 2 * h)) {
    return refused("double_helical.hob_diameter", d, {2 * h},
                   "must be greater than {} mm, twice the depth of the teeth");
  }
  // One hob cuts both halves. For the half that has the hand of the hob, the hob is swivelled by
  // |β| − γ_0, and for the other half by |β| + γ_0. The gap must be wide enough at both swivel
  // angles.
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
                             "do not meet in the middle plane, and files of the gear cannot be "
                             "written. A `double_helical.gap` greater than 0 separates the halves.",
                             format_number(halves.given.stagger_pitches)),
                 which};
}

std::optional<Warning> run_out_warning(const Halves& halves, int which) {
  if (!halves.hob_run_out || *halves.hob_run_out <= halves.given.gap) return std::nullopt;
  return Warning{WarningCode::hob_run_out,
                 fmt::format("The run-out of the hob needs a gap of at least {:.4f} mm, but the "
                             "gap is {:.4f} mm. A smaller hob, a wider gap or shaping would help.",
                             rounded_up(*halves.hob_run_out, 4), halves.given.gap),
                 which};
}

}  // namespace gearwright
