#include "gearwright/pair/involute_pair.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "gearwright/base/angle.hpp"
#include "gearwright/base/number_text.hpp"
#include "gearwright/gear/gear.hpp"
#include "gearwright/pair/clearances.hpp"
#include "gearwright/pair/drive.hpp"
#include "gearwright/pair/interference.hpp"
#include "gearwright/pair/saddle_gap.hpp"

namespace gearwright {

namespace {

void warn(InvolutePair& p, WarningCode code, std::string message, int gear = 0) {
  p.warnings.push_back({code, std::move(message), gear});
}

// If the shaft angle is smaller than this, the user most likely intended parallel axes.
constexpr double kNearlyParallel = 1.0;  // degrees

void warn_about_axes(CrossedPair& p) {
  if (std::abs(p.shaft_angle.deg()) < kNearlyParallel) {
    const double wanted = -p.side() * p.gears[0].spec.helix_angle.deg();
    warn(p, WarningCode::nearly_parallel,
         fmt::format(
             "The axes cross at {:.4g}°, so the teeth touch in points. Parallel axes need the "
             "helix angle {:.6f}° on gear 2 (with the module and pressure angle of gear 1).",
             p.shaft_angle.deg(), wanted));
  }
  for (int i : {0, 1}) {
    const double b = p.gears[i].spec.face_width;
    const double wanted = p.face_widths.both_flanks[i];
    if (p.flanks_meet() && wanted > b) {
      warn(p, WarningCode::face_width,
           fmt::format(
               "The line of action runs beyond the face of gear {}. Both flanks need "
               "a face width of {:.2f} mm about the centre line, but the face is {:.2f} mm wide.",
               i + 1, rounded_up(wanted, 2), b),
           i + 1);
    }
  }
}

void warn_about_contact(InvolutePair& p, const char* lacks, const char* ratio_of_all) {
  const double ratio = p.contact_ratio_true();
  if (ratio == 0.0) {
    warn(p, WarningCode::no_contact,
         p.flanks_meet() ? lacks
                         : "The teeth do not touch, because they do not reach each other at this "
                           "centre distance.");
  } else if (ratio < 1.0) {
    warn(p, WarningCode::contact_ratio,
         fmt::format("The {} is {:.3f}, but must be at least 1 for continuous contact.",
                     ratio_of_all, ratio));
  }
}

void warn_about_line(ParallelPair& p) {
  warn_about_contact(p,
                     "The teeth do not touch, because the part of the line of action within the "
                     "tips lies outside the usable flanks.",
                     "total contact ratio");
  if (p.contact_ratio_true() >= 1.0 && p.mesh.true_ratio < 1.0) {
    warn(
        p, WarningCode::transverse_contact_ratio,
        fmt::format("The transverse contact ratio is {:.3f}, so contact is continuous only through "
                    "the overlap of helical teeth. A face width of at least {:.2f} mm is needed.",
                    p.mesh.true_ratio, *face_width_needed(p)));
  }
}

void warn_about_line(CrossedPair& p) {
  warn_about_contact(p,
                     "The flanks have no conjugate contact, because the part of the line of action "
                     "within the tips lies outside the usable flanks or the faces. Only edges or "
                     "crowned flanks can touch.",
                     "contact ratio");
  warn_about_axes(p);
}

void warn_about_backlash(InvolutePair& p) {
  if (p.stated_backlash().negative()) {
    const std::string distance =
        p.backlash_free_center_distance
            ? fmt::format("The backlash-free centre distance is {:.4f} mm.",
                          *p.backlash_free_center_distance)
            : "There is no backlash-free centre distance.";
    warn(p, WarningCode::negative_backlash,
         fmt::format("The backlash is negative, because the teeth are too thick by {:.4f} mm "
                     "(normal) at this centre distance. {}",
                     -p.mesh.backlash.normal, distance));
  }
}

void warn_about_friction(InvolutePair& p) {
  if (p.efficiency && !(p.efficiency->gear1_drives && p.efficiency->gear2_drives)) {
    const int gear = p.efficiency->gear1_drives ? 2 : 1;
    warn(p, WarningCode::self_locking,
         fmt::format("With this friction, the pair is self-locking, and gear {} cannot drive.",
                     gear),
         gear);
  }
}

void warn_about_collisions(InvolutePair& p) {
  for (const Interference& i : p.interference) warn(p, i.code, i.message, i.gear);
  for (const Collision& s : p.beyond_flank) warn(p, WarningCode::beyond_flank, s.message, s.gear);
}

// Least plausible centre distance, relative to the sum of the base radii. Without backlash, the
// centre distance exceeds this sum.
constexpr double kMinCrossedDistance = 0.5;

// Checks that the pinion lies inside the internal gear, and that the distance L of the base tangent
// points is positive. If L > 0, the flanks of the pinion are more curved than the flanks of the
// internal gear. [T4.34]
std::optional<Error> check_place_inside(const CrossedPair& p, const CommonRack<double>& rack) {
  const BasePair<double>& gears = p.input.gears;
  const auto& sides = rack.sides;
  const auto to_pitch_point = [&](int i) {
    return sides[i].pitch_point_curvature / std::cos(gears[i].helix_angle);
  };
  const double least =
      std::max(0.0, sides[1].pitch_radius - sides[0].pitch_radius -
                        (to_pitch_point(1) - to_pitch_point(0)) * rack.angles.sin_alpha);
  const double most = sides[1].pitch_radius;
  const double a = p.center_distance;
  if (!(least < most)) {
    return refused("pair.shaft_angle", Angle::radians(*p.input.shaft_angle).deg(),
                   "at this shaft angle the flanks of the pinion are nowhere more curved than the "
                   "flanks of the internal gear; a smaller helix angle of the pinion, or more "
                   "teeth on the internal gear, would help");
  }
  if (a > least && a < most) return std::nullopt;
  return refused("pair.center_distance", a, {least, most},
                 "must be greater than {} mm, so that the flanks of the pinion are more curved "
                 "than the flanks of the internal gear, and less than {} mm, the working pitch "
                 "radius of the internal gear");
}

std::optional<Error> check_place(const CrossedPair& p) {
  const double a = p.center_distance;
  const auto rack = common_rack(p.input.gears, working_angles(p.input));
  if (side_of(p.input.gears) < 0.0) return check_place_inside(p, rack);
  const double most = kMaxDistance * (rack.sides[0].pitch_radius + rack.sides[1].pitch_radius);
  const double least = kMinCrossedDistance * base_radius_sum(p.input.gears);
  if (a >= least && a <= most) return std::nullopt;
  return refused("pair.center_distance", a, {least, most},
                 "must be at least {} mm (half the sum of the base radii) and at most {} mm");
}

std::optional<Error> check_place(const ParallelPair& p) {
  const double a = p.center_distance;
  const double least = base_radius_sum(p.input.gears);
  if (a > least && a <= kMaxDistance * least) return std::nullopt;
  return refused(
      "pair.center_distance", a, {least, kMaxDistance * least},
      fmt::format(
          "at this centre distance there is no working pressure angle; the centre distance must be "
          "greater than {{}} mm and at most {{}} mm, which is {} times the lower limit",
          kMaxDistance));
}

std::optional<double> backlash_free_distance(const ParallelPair& p) {
  const BasePair<double>& gears = p.input.gears;
  const auto alpha = transverse_angle_at_min_distance(gears);
  return alpha ? std::optional(base_radius_sum(gears) / std::cos(*alpha)) : std::nullopt;
}

std::optional<double> backlash_free_distance(const CrossedPair& p) {
  const double a = conjugate_center_distance(p.input.gears, p.mesh.rack);
  return a > 0.0 ? std::optional(a) : std::nullopt;
}

// The pitch point is at x = +r_w1 for an external pair and at −r_w1 for an internal pair. Gear 1
// turns clockwise, so the normal of the leading flanks is (sin α, −cos α). For an internal pair, it
// has the opposite direction.
LineOfAction line_of(const ParallelPair& p) {
  const double alpha = p.mesh.rack.sides[0].transverse_angle;
  return {std::sin(alpha), std::cos(alpha), 0.0, 0.0, p.side()};
}

LineOfAction line_of(const CrossedPair& p) {
  const CommonRack<double>& rack = p.mesh.rack;
  return {rack.angles.sin_alpha, rack.angles.u[0], p.mesh.line_offset / rack.sides[0].cos_helix,
          p.mesh.tan_base_helix[0], 1.0};
}

// Sets the quantities that only pairs on parallel axes have.
void find_own(ParallelPair& p) {
  if (p.gears[1].internal()) detail::find_internal_margins(p);
  detail::find_fillet_clearance(p);
}

void find_own(CrossedPair& p) {
  if (const auto alpha = transverse_angle_at_min_distance(p.input.gears))
    p.min_distance = crossed_place(p.input.gears, *alpha);
  p.contact_ratio_range = contact_ratio_range(p.input);
  if (p.crossed_inside()) p.needed_crowning = needed_crowning(p.input, p.mesh);
  p.face_widths = face_widths(p.mesh);
}

// Computes the reference and the extended centre distance, and the tip shortening.
void find_distances(InvolutePair& p) {
  const Gear& g1 = p.gears[0];
  const Gear& g2 = p.gears[1];
  const double sigma = p.side();
  p.reference_center_distance = (g2.reference_diameter + sigma * g1.reference_diameter) / 2;
  p.extended_center_distance = extended_center_distance(g1, g2);
  p.tip_shortening = sigma * (p.center_distance - p.extended_center_distance);
}

template <class Kind>
Result<Kind> mounted(Gear gear_1, Gear gear_2, const PairPlace& place,
                     std::optional<double> friction) {
  Kind p{};
  p.center_distance = place.center_distance;
  p.shaft_angle = place.shaft_angle.value_or(Angle());
  p.input = mesh_input(gear_1, gear_2, place);
  if (auto error = check_place(p)) return *error;
  p.gears = {std::move(gear_1), std::move(gear_2)};
  p.mesh = mesh_of(p.input);
  p.line = line_of(p);
  find_distances(p);
  p.backlash_free_center_distance = backlash_free_distance(p);
  const auto [start, end] = contact_ends(p);
  p.sliding_A = specific_sliding(p.input, p.mesh, start);
  p.sliding_E = specific_sliding(p.input, p.mesh, end);
  if (friction && p.contact_ratio_true() >= 1.0 && p.mesh.true_ratio > 0.0)
    p.efficiency = efficiency(sliding_shares(p.input, p.mesh), *friction);
  detail::find_form_clearance(p);
  detail::find_tip_clearance(p);
  find_own(p);
  detail::find_overlap(p);
  warn_about_backlash(p);
  warn_about_line(p);
  warn_about_friction(p);
  warn_about_collisions(p);
  return p;
}

}  // namespace

MeshInput<double> mesh_input(const Gear& g1, const Gear& g2, const PairPlace& place) {
  MeshInput<double> in;
  in.gears = base_pair(g1, g2);
  in.tip_form_radius = {g1.tip_form_radius(), g2.tip_form_radius()};
  in.root_form_radius = {g1.root_form_radius(), g2.root_form_radius()};
  in.face_width = {g1.spec.face_width, g2.spec.face_width};
  in.center_distance = place.center_distance;
  if (place.shaft_angle) in.shaft_angle = place.shaft_angle->rad();
  return in;
}

CrossedPlace crossed_place(const BasePair<double>& gears, double alpha) {
  const auto d = detail::distance_and_line(gears, alpha);
  const auto angles = angles_at_transverse(gears, alpha);
  const auto beta = adding_helix_angles(gears);
  double sigma = 0.0;
  for (int i : {0, 1}) sigma += std::atan2(std::sin(beta[i]), angles.u[i]);
  return {d.a.value, Angle::radians(sigma),
          Angle::radians(std::atan2(angles.sin_alpha, angles.cos_alpha))};
}

std::optional<CrossedPlaces> contact_ratio_range(const MeshInput<double>& in) {
  if (side_of(in.gears) < 0.0) return std::nullopt;
  double reach = -normal_base_pitch(in.gears[0]);
  for (int i : {0, 1}) {
    reach += leaf::curvature_at(in.tip_form_radius[i], in.gears[i].radius) /
             std::cos(in.gears[i].helix_angle);
  }
  const auto interval = transverse_angles_with_line_within(in.gears, reach);
  if (!interval) return std::nullopt;
  return CrossedPlaces{crossed_place(in.gears, interval->lo), crossed_place(in.gears, interval->hi),
                       interval->limit};
}

bool InvolutePair::flanks_meet() const {
  const auto has_flank = [](const Gear& g) { return !g.tooth || g.tooth->form_radius.has_value(); };
  return mesh.path_length > 0.0 && has_flank(gears[0]) && has_flank(gears[1]);
}

double InvolutePair::path_length() const {
  return flanks_meet() ? mesh.path_length / mesh.line_cosine : 0.0;
}

double InvolutePair::contact_ratio() const {
  return flanks_meet() ? mesh.path_ratio + mesh.overlap_ratio : 0.0;
}

double InvolutePair::contact_ratio_true() const {
  const bool any = flanks_meet() && mesh.true_ratio > 0.0;
  return any ? mesh.true_ratio + mesh.overlap_ratio : 0.0;
}

Point<Housing> InvolutePair::on_line_of_action(double rho1) const {
  const double from_pitch_point = rho1 - mesh.rho1_C;
  const double lambda = from_pitch_point / mesh.line_cosine;
  const double r_w1 = mesh.rack.sides[0].pitch_radius;
  return {Vec3(mesh.sigma * (r_w1 + lambda * line.across), -mesh.sigma * lambda * line.along,
               line.z_side * (line.height + from_pitch_point * line.rise))};
}

Point<Housing> InvolutePair::on_trailing_line(double rho1) const {
  Point<Housing> p = on_line_of_action(rho1);
  p.r.y() = 0.0 - p.r.y();
  p.r.z() = 0.0 - p.r.z();
  return p;
}

Result<PairPlace> involute_place(const Gear& gear_1, const Gear& gear_2, const PairSpec& spec) {
  GW_EXPECTS(gear_1.involute() && gear_2.involute());
  const std::optional<Angle> angle =
      spec.center_distance ? spec.shaft_angle.value_or(Angle()) : spec.shaft_angle;
  if (auto error = check_partners(gear_1.spec, gear_2.spec, angle)) return *error;
  if (!gear_1.exists()) return of_gear(1, gear_1.why_not());
  if (!gear_2.exists()) return of_gear(2, gear_2.why_not());
  PairPlace place{spec.center_distance.value_or(0.0), spec.shaft_angle};
  if (!spec.center_distance) {
    auto free = complete_place(nominal_base_pair(gear_1.spec, gear_2.spec), std::nullopt, angle);
    if (!free) return free.error();
    place = *free;
  }
  if (place.shaft_angle && place.shaft_angle->rad() == 0.0) place.shaft_angle.reset();
  return place;
}

Result<ParallelPair> mount_parallel(Gear gear_1, Gear gear_2, const PairPlace& place,
                                    std::optional<double> friction) {
  GW_EXPECTS(!place.shaft_angle);
  return mounted<ParallelPair>(std::move(gear_1), std::move(gear_2), place, friction);
}

Result<CrossedPair> mount_crossed(Gear gear_1, Gear gear_2, const PairPlace& place,
                                  std::optional<double> friction) {
  GW_EXPECTS(place.shaft_angle.has_value());
  return mounted<CrossedPair>(std::move(gear_1), std::move(gear_2), place, friction);
}

}  // namespace gearwright
