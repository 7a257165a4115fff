#include "gearwright/gear/pinion_cut.hpp"

#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "gearwright/base/error.hpp"
#include "gearwright/base/numbers.hpp"
#include "gearwright/gear/finished_gear.hpp"
#include "gearwright/generation/cut_by_pinion.hpp"
#include "gearwright/math/involute.hpp"
#include "gearwright/math/lowest.hpp"

namespace gearwright {

namespace {

// Returns the profile shift x with which the gear meshes with the cutter at E without backlash.
// x + x_0 = (inv α_w − inv α_t)(z_0 + z)/(2 tan α_n). [T6.12]
double shift_at(const Gear& cutter, int teeth, double roll_w) {
  const ReferenceGeometry<double>& g = cutter.reference();
  const double sum = (involute_of_roll(roll_w) - involute(g.transverse_pressure_angle)) *
                     (cutter.spec.teeth + teeth) /
                     (2.0 * std::tan(cutter.spec.normal_pressure_angle.rad()));
  return sum - g.generating_profile_shift;
}

// Returns ρ_a0, the tip rounding of the cutter. If the cutter has a circular tip fillet, ρ_a0 is
// the radius of this fillet. Otherwise, ρ_a0 is the root rounding of the rack that cut the cutter,
// provided that the tip of the cutter reaches this rounding. For sharp tips, ρ_a0 is 0. It is also
// 0 for a cutter that was cut by a pinion cutter, because the tip of such a cutter has no rounding
// of constant radius.
double tip_rounding(const Gear& cutter) {
  if (const auto& arc = cutter.tooth->tip_fillet) return arc->radius;
  const StraightRack& rack = cutter.spec.straight_rack();
  const double m = cutter.spec.normal_module;
  if (cutter.cut_by || rack.tip_fillet_radius == 0.0) return 0.0;
  const double sin_alpha = std::sin(cutter.spec.normal_pressure_angle.rad());
  const double flank_end =
      rack.tool_addendum.value_or(rack.addendum - rack.tip_fillet_radius * (1 - sin_alpha));
  const double begin =
      cutter.reference_diameter / 2 + m * (cutter.reference().generating_profile_shift + flank_end);
  return cutter.tooth->tip_radius > begin ? rack.tip_fillet_radius * m : 0.0;
}

double base_distance(const Gear& cutter, int teeth) {
  return cutter.base_radius() * std::abs(1.0 + static_cast<double>(teeth) / cutter.spec.teeth);
}

}  // namespace

double shift_of_allowance(const Gear& cutter, double allowance) {
  return allowance /
         (2.0 * cutter.spec.normal_module * std::tan(cutter.spec.normal_pressure_angle.rad()));
}

std::optional<Error> check_cutter(const Gear& cutter, int teeth) {
  const int z_0 = cutter.spec.teeth;
  if (teeth == 0)
    return refused("teeth", 0, "must not be 0; the number is negative for an internal gear");
  if (teeth < 0 && -teeth <= z_0) {
    return refused("teeth", teeth,
                   fmt::format("the cutter with {} teeth does not fit into the internal gear; the "
                               "internal gear needs at least {} teeth, or the cutter may have at "
                               "most {}",
                               z_0, -(z_0 + 1), -teeth - 1));
  }
  return std::nullopt;
}

Result<double> generating_distance(const Gear& cutter, int teeth, double profile_shift) {
  if (auto error = check_cutter(cutter, teeth)) return *error;
  const ReferenceGeometry<double>& g = cutter.reference();
  const double sum = profile_shift + g.generating_profile_shift;
  const double inv_w =
      involute(g.transverse_pressure_angle) +
      2.0 * std::tan(cutter.spec.normal_pressure_angle.rad()) * sum / (cutter.spec.teeth + teeth);
  const double r = base_distance(cutter, teeth);
  if (sum == 0.0) return r / std::cos(g.transverse_pressure_angle);
  if (!(inv_w >= 0.0)) {
    const double least = shift_at(cutter, teeth, 0.0);
    return refused("profile_shift", profile_shift, {least},
                   fmt::format("this cutter cannot generate such a gear, because there is no "
                               "working pressure angle; the profile shift must be {} {{}}",
                               teeth > 0 ? "at least" : "at most"));
  }
  return r / std::cos(inverse_involute(inv_w));
}

std::optional<InfeedCut> infeed_cut(const GeneratedTooth& cutter, const GeneratedTooth& ring,
                                    double distance) {
  GW_EXPECTS(ring.outline.teeth < 0 && !ring.outline.arcs.empty());
  const Arc* const flank = ring.outline.find(ArcName::flank);
  if (!flank) return std::nullopt;
  const Vec2& tip = flank->end_point;
  const double r = tip.norm();
  const double space = kPi / -ring.outline.teeth - std::atan2(tip.y(), tip.x());
  const double q = static_cast<double>(cutter.outline.teeth) / -ring.outline.teeth;
  std::optional<InfeedCut> most;
  // A point of the cutter at the polar angle θ cuts most when the cutter has turned by φ − θ.
  // Its polar angle about the axis of the ring is then ψ. Both φ and ψ are measured from the
  // line of centres.
  const auto cut_by_point = [&](const Vec2& p) -> std::optional<InfeedCut> {
    const double rho = p.norm(), R = q * r / rho;
    if (R >= 1.0) return std::nullopt;
    const double phi = std::asin(std::sqrt((1.0 - R * R) / (1.0 - q * q)));
    const double psi = std::asin(std::min(1.0, rho * std::sin(phi) / r));
    const double e = r * std::cos(psi) - rho * std::cos(phi);
    if (e >= distance) return std::nullopt;
    return InfeedCut{r * (psi - space - q * (phi - std::atan2(p.y(), p.x()))), e};
  };
  for (const Arc& arc : cutter.outline.arcs) {
    if (arc.name != ArcName::flank && arc.name != ArcName::tip_fillet) continue;
    const auto left = [&](double u) {
      const auto cut = cut_by_point(arc.point(u));
      return cut ? -cut->arc : std::numeric_limits<double>::max();
    };
    for (const double u : {place_of_least(left, 0.0, 1.0), 1.0}) {
      const auto cut = cut_by_point(arc.point(u));
      if (cut && (!most || cut->arc > most->arc)) most = cut;
    }
  }
  return most;
}

namespace {

constexpr double kTrimmed = 1e-6;  // modules; less than any shaping machine reproduces

bool trims(const std::optional<InfeedCut>& cut, double module) {
  return cut && cut->arc > kTrimmed * module;
}

// Returns the greatest number of teeth, less than that of `cutter`, with which a similar cutter
// generates the whole flank of `ring` without trimming it. A similar cutter has the same rack,
// profile shift and tip height as `cutter`. Returns none if there is no such number, or if the
// teeth of `cutter` are not cut by a rack alone.
std::optional<int> largest_clear_cutter(const Gear& cutter, const Gear& ring) {
  if (cutter.cut_by || cutter.spec.root_fillet || cutter.spec.tip_fillet) return std::nullopt;
  CylindricalSpec c = cutter.spec;
  for (int z_0 = cutter.spec.teeth - 1; z_0 > 1; --z_0) {
    c.teeth = z_0;
    if (cutter.spec.tip_diameter)
      c.tip_diameter =
          *cutter.spec.tip_diameter - (cutter.spec.teeth - z_0) * cutter.transverse_module;
    const auto smaller = make_gear(c);
    if (!smaller || !smaller->exists() || smaller->pointed()) continue;
    const auto e =
        generating_distance(*smaller, ring.spec.teeth, ring.reference().generating_profile_shift);
    if (!e || trims(infeed_cut(*smaller->tooth, *ring.tooth, *e), c.normal_module)) continue;
    const PinionMotion motion{z_0, ring.spec.teeth, *e};
    const auto tooth = cut_by_pinion(*smaller->tooth, motion, ring.tip_diameter / 2);
    if (tooth && tooth->tip_form_radius && ring.tooth->tip_form_radius &&
        *tooth->tip_form_radius <= *ring.tooth->tip_form_radius + kTrimmed * c.normal_module &&
        !trims(infeed_cut(*smaller->tooth, *tooth, *e), c.normal_module))
      return z_0;
  }
  return std::nullopt;
}

void warn_about_infeed(Gear& ring, const Gear& cutter) {
  if (!ring.exists() || !ring.tooth->form_radius) return;
  const auto cut = infeed_cut(*cutter.tooth, *ring.tooth, ring.cut_by->distance);
  if (!trims(cut, ring.spec.normal_module)) return;
  const auto teeth = largest_clear_cutter(cutter, ring);
  detail::warn(
      ring, WarningCode::trimming,
      fmt::format("In radial infeed, the cutter with {} teeth removes {:.4f} mm from each flank at "
                  "a diameter of {:.4f} mm when it reaches the centre distance {:.4f} mm. {}",
                  cutter.spec.teeth, cut->arc, 2 * ring.tip_form_radius(), cut->distance,
                  teeth ? fmt::format("Give a similar cutter with {} teeth, which removes nothing, "
                                      "or give a greater `tip_diameter`.",
                                      *teeth)
                        : std::string("Give a cutter with fewer teeth or a shorter tip, or give a "
                                      "greater `tip_diameter`.")));
}

}  // namespace

Result<Gear> make_pinion_cut_gear(const Gear& cutter, const PinionCutSpec& wanted) {
  GW_EXPECTS(cutter.involute() && !cutter.internal() && cutter.tooth && cutter.exists());
  if (auto error = check_cutter(cutter, wanted.teeth)) return *error;
  const double r = base_distance(cutter, wanted.teeth);
  const double e = wanted.distance;
  if (!(e > r)) {
    return refused("cut_by", e, {r},
                   "the generating centre distance is too small for a working pressure angle; the "
                   "distance must be greater than {} mm");
  }
  CylindricalSpec spec = cutter.spec;
  spec.teeth = wanted.teeth;
  if (wanted.teeth > 0) spec.helix_angle = Angle::degrees(0.0 - cutter.spec.helix_angle.deg());
  spec.thickness_allowance = wanted.thickness_allowance;
  const double x_E = shift_at(cutter, wanted.teeth, std::sqrt((e - r) * (e + r)) / r);
  spec.profile_shift = wanted.profile_shift.value_or(x_E);
  spec.face_width = wanted.face_width;
  spec.root_fillet.reset();
  spec.tip_fillet.reset();
  const PinionMotion motion{cutter.spec.teeth, wanted.teeth, e};
  // By default, the tip radius of the gear is the radius to which the root of the cutter cuts. It
  // is computed exactly as in cut_by_pinion(), so that no rounding error determines whether the
  // blank or the cutter limits the tip.
  spec.tip_diameter = wanted.tip_diameter.value_or(2 * left_by_root(*cutter.tooth, motion));
  if (auto error = check_limits(spec)) return *error;
  Gear gear = detail::described(spec);
  gear.cut_by = PinionCutting{cutter.spec.teeth, e, tip_rounding(cutter)};
  auto tooth = cut_by_pinion(*cutter.tooth, motion, gear.tip_diameter / 2);
  if (!tooth) return tooth.error();
  gear.tooth = std::move(tooth).take();
  if (const auto flank = cutter.tooth->outline.find(ArcName::flank)) {
    const auto cut = pinion_involute(motion, curve_as<Involute>(*flank->curve));
    gear.undercut = wanted.teeth > 0 && cut && cut->roll(flank->end) < 0.0;
  }
  detail::finish(gear);
  if (gear.internal()) warn_about_infeed(gear, cutter);
  return gear;
}

namespace {

constexpr double kCutterDedendum = 1.5;  // modules; the root is sharp, so that the cutter clears
                                         // the tip of any internal gear
constexpr double kMinLand = 0.1;         // modules, at the cutter's tip
constexpr double kSameTip = 1e-9;        // relative tolerance for the requested tip

struct Cutter {
  Gear gear;
  double distance;
};

// Returns a cutter of z_0 teeth with this tip rounding, whose tip reaches the root of the internal
// gear, or none if it cannot be made.
std::optional<Cutter> cutter_of(const Gear& ring, int z_0, double rounding) {
  CylindricalSpec c;
  c.teeth = z_0;
  c.normal_module = ring.spec.normal_module;
  c.normal_pressure_angle = ring.spec.normal_pressure_angle;
  c.helix_angle = ring.spec.helix_angle;
  c.face_width = ring.spec.face_width;
  c.straight_rack().dedendum = kCutterDedendum;
  c.straight_rack().root_fillet_radius = 0.0;
  auto bare = make_gear(c);
  if (!bare || !bare->exists()) return std::nullopt;
  const auto e =
      generating_distance(*bare, ring.spec.teeth, ring.reference().generating_profile_shift);
  if (!e) return std::nullopt;
  const double r_a = ring.root_diameter / 2 - *e;
  c.straight_rack().addendum = (r_a - bare->reference_diameter / 2) / c.normal_module;
  if (!(c.straight_rack().addendum > 0.0)) return std::nullopt;
  c.straight_rack().tip_fillet_radius = rounding;
  c.tip_diameter = 2 * r_a;
  auto cutter = make_gear(c);
  if (!cutter || !cutter->exists() || cutter->pointed()) return std::nullopt;
  const auto& land = cutter->tip_tooth_thickness_normal;
  if (!land || *land < kMinLand * c.normal_module) return std::nullopt;
  if (std::abs(cutter->tooth->tip_radius - r_a) > kSameTip * r_a) return std::nullopt;
  return Cutter{std::move(cutter).take(), *e};
}

std::optional<Gear> cut_with(const Gear& ring, const Cutter& cutter) {
  auto cut = make_pinion_cut_gear(
      cutter.gear, {ring.spec.teeth, cutter.distance, ring.spec.face_width, ring.tip_diameter});
  if (!cut || !cut->exists() || cut->pointed() || !cut->tooth->form_radius) return std::nullopt;
  Gear with = ring;
  with.tooth = std::move(cut->tooth);
  with.cut_by = cut->cut_by;
  with.cut_by->by_default = true;
  with.warnings.clear();
  detail::finish(with);
  detail::warn(with, WarningCode::default_cutter,
               fmt::format("`cut_by` is not given, so a default pinion cutter generates the "
                           "fillets of the internal gear. This cutter has {} teeth and no profile "
                           "shift, and its tip reaches the root diameter.",
                           cutter.gear.spec.teeth));
  return with;
}

}  // namespace

std::optional<Gear> cut_by_default(const Gear& ring) {
  GW_EXPECTS(!ring.tooth);
  const int z = -ring.spec.teeth;
  for (const double share : {0.5, 0.6, 0.4, 0.7, 0.8, 0.3, 0.2, 0.1}) {
    const int z_0 = static_cast<int>(share * z);
    if (z_0 < 1) continue;
    for (const double rounding : {ring.spec.straight_rack().root_fillet_radius, 0.2, 0.0}) {
      const auto cutter = cutter_of(ring, z_0, rounding);
      if (!cutter) continue;
      // A cutter is suitable if it leaves the whole flank up to the tip.
      auto cut = cut_with(ring, *cutter);
      if (cut && cut->tooth->tip_form_radius == cut->tooth->tip_radius &&
          cut->tooth->tip_radius == ring.tip_diameter / 2) {
        return cut;
      }
    }
  }
  return std::nullopt;
}

Result<Gear> make_gear_with_default_cutter(const CylindricalSpec& spec) {
  auto gear = make_gear(spec);
  if (!gear || gear->tooth) return gear;
  auto cut = cut_by_default(*gear);
  return cut ? *std::move(cut) : std::move(gear).take();
}

}  // namespace gearwright
