#include "gearwright/pair/partners.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "gearwright/base/angle.hpp"
#include "gearwright/base/units.hpp"

namespace gearwright {

namespace {

// Base pitches and base helix angles count as equal if they differ by at most 1e-9. The rounding of
// values in degrees or mm causes smaller differences. A different helix angle causes greater ones.
constexpr double kSamePitch = 1e-9;

// At helix angles above this limit, the radius of the pitch cylinder is hundreds of times the base
// radius, and no tooth reaches the pitch cylinder.
constexpr double kMaxWorkingHelix = 89.9;  // degrees

constexpr double kAtEnd = 1e-9;  // rad, rounding error of an angle at the end of its range

constexpr const char* kReach = "these gears need a shaft angle greater than {}° and less than {}°";

// Parts of messages about the hands of the helices.
struct Hands {
  const char* parallel;     ///< the relation of the hands on parallel axes
  const char* shaft_angle;  ///< the sign rule of the shaft angle
  const char* changes;      ///< the effect of a helix angle on the range
};
constexpr Hands kExternal{
    "opposite",
    "the angle is positive for two right-hand gears and negative for two left-hand gears",
    "widens"};
constexpr Hands kInternal{"of the same hand",
                          "the angle is the helix angle of gear 1 minus the helix angle of the "
                          "internal gear, where right-hand angles are positive",
                          "shifts"};

// Returns the error for a shaft angle outside its range. `rule` contains kReach, and the ends of
// the range replace the two placeholders of kReach.
Error beyond(const ShaftAngleRange<double>& range, double sigma, const std::string& rule) {
  return refused("pair.shaft_angle", deg(sigma),
                 {deg(std::min(range.from, range.to)), deg(std::max(range.from, range.to))}, rule);
}

std::optional<Error> check_shaft_angle(const BasePair<double>& gears, double sigma,
                                       const CylindricalSpec& gear_1) {
  const bool parallel = axes_are_parallel(gears);
  const Hands& hands = side_of(gears) > 0.0 ? kExternal : kInternal;
  if (sigma == 0.0 && parallel) return std::nullopt;
  if (parallel) {
    return refused(
        "pair.shaft_angle", deg(sigma),
        fmt::format(
            "must be 0, because the base helix angles are equal and {}, so that the axes are "
            "parallel at every centre distance; for crossed axes give one gear another helix angle "
            "(bevel gears are not supported)",
            hands.parallel));
  }
  const auto range = shaft_angle_range(gears);
  if (sigma == 0.0) {
    return beyond(
        range, 0.0,
        fmt::format("parallel axes need equal and opposite base helix angles; if gear 2 has the "
                    "same module, its helix angle must be {}°; with the given angles, {}",
                    format_number(0.0 - gear_1.helix_angle.deg()), kReach));
  }
  if (range.contains(sigma)) {
    const RackAngles<double> angles = angles_at_shaft_angle(gears, sigma);
    const int g = limiting_gear(gears);
    const double helix = deg(std::atan2(std::abs(std::sin(gears[g].helix_angle)), angles.u[g]));
    if (helix <= kMaxWorkingHelix && angles.sin_alpha > 0.0) return std::nullopt;
    return beyond(range, sigma,
                  fmt::format("is too close to a limit of these gears, because the working helix "
                              "angle of gear {} would be {:.6g}°, but at most {}° is allowed; {}",
                              g + 1, helix, kMaxWorkingHelix, kReach));
  }
  const double miss = std::min(std::abs(sigma - range.from), std::abs(sigma - range.to));
  const std::string place =
      miss < kAtEnd
          ? "is the end of the possible range, at which a working helix angle would be 90°"
          : fmt::format("is outside the possible range by {:.6g}°", deg(miss));
  // With this helix angle of gear 2, the sum of the reference helix angles is equal to the shaft
  // angle.
  const double helix = side_of(gears) * (deg(sigma) - gear_1.helix_angle.deg());
  const std::string remedy =
      std::abs(helix) < kMaxWorkingHelix
          ? fmt::format("the helix angle {:.6g}° of gear 2 gives this shaft angle", helix)
          : fmt::format("another helix angle on either gear {} this range", hands.changes);
  return beyond(range, sigma,
                fmt::format("{}; {} ({}); {}", place, kReach, hands.shaft_angle, remedy));
}

}  // namespace

BasePair<double> base_pair(const Gear& g1, const Gear& g2) {
  return {base_gear(g1.spec.teeth, g1.reference()), base_gear(g2.spec.teeth, g2.reference())};
}

BasePair<double> nominal_base_pair(const CylindricalSpec& gear_1, const CylindricalSpec& gear_2) {
  const auto nominal = [](const CylindricalSpec& c) {
    return base_gear(c.teeth, reference_geometry<double>(
                                  {c.teeth, c.normal_module, c.normal_pressure_angle.rad(),
                                   c.helix_angle.rad(), c.profile_shift, 0.0}));
  };
  return {nominal(gear_1), nominal(gear_2)};
}

bool axes_are_parallel(const BasePair<double>& gears) {
  return std::abs(gears[0].helix_angle + side_of(gears) * gears[1].helix_angle) <= kSamePitch;
}

Error internal_gear_1(int teeth_1, int teeth_2) {
  return refused(gear_field(1, "teeth"), teeth_1,
                 teeth_2 < 0 ? "both gears are internal, but an internal gear meshes only with an "
                               "external gear; give gear 1 a positive number of teeth"
                             : "the internal gear of a pair is gear 2; exchange the two gears");
}

std::optional<Error> check_partners(const CylindricalSpec& g1, const CylindricalSpec& g2,
                                    const std::optional<Angle>& shaft_angle) {
  const int z1 = g1.teeth;
  const int z2 = g2.teeth;
  if (z1 < 0) return internal_gear_1(z1, z2);
  if (z2 < 0 && -z2 <= z1) {
    return refused(
        gear_field(2, "teeth"), z2,
        fmt::format("an internal gear must have more teeth than its pinion (gear 1 has {})", z1));
  }
  const BasePair<double> gears = nominal_base_pair(g1, g2);
  const double p1 = normal_base_pitch(gears[0]);
  const double p2 = normal_base_pitch(gears[1]);
  if (std::abs(p1 - p2) > kSamePitch * p1) {
    return refused(
        gear_field(2, "normal_module"), g2.normal_module,
        fmt::format(
            "the normal base pitches differ by {:.6g} mm, because gear 1 has {} mm and gear 2 has "
            "{} mm; gears mesh only with equal m_n cos α_n. Gear 2 needs the module {:.9g}\u00a0mm "
            "at its pressure angle (diametral pitch {:.6g}), or the base diameter {:.9g} mm at its "
            "base helix angle",
            p2 - p1, format_number(p1, p2), format_number(p2, p1), g2.normal_module * p1 / p2,
            kMmPerInch * p2 / (g2.normal_module * p1), 2 * gears[1].radius * p1 / p2));
  }
  const bool crossing = shaft_angle && shaft_angle->rad() != 0.0;
  if (z2 < 0 && !crossing && !axes_are_parallel(gears)) {
    // The flanks of a crossed internal pair have clearance only if the leads are crowned. For an
    // internal pair, crossed axes are therefore used only if the user gives a shaft angle.
    return refused(
        gear_field(2, "helix_angle"), g2.helix_angle.deg(),
        fmt::format("the axes of this internal pair would cross at {:.6g}°; for parallel axes, an "
                    "internal gear of the same module needs the helix angle {}° (the same hand); "
                    "for crossed axes give `pair.shaft_angle`",
                    deg(gears[0].helix_angle - gears[1].helix_angle),
                    format_number(g1.helix_angle.deg(), g2.helix_angle.deg())));
  }
  if (!shaft_angle) return std::nullopt;
  return check_shaft_angle(gears, shaft_angle->rad(), g1);
}

Result<PairPlace> complete_place(const BasePair<double>& nominal, std::optional<double> distance,
                                 std::optional<Angle> shaft_angle) {
  PairPlace place;
  const double excess = base_excess(nominal);
  const auto least = transverse_angle_at_min_distance(nominal);
  if (axes_are_parallel(nominal)) {
    const double sum = base_radius_sum(nominal);
    // If there is no backlash-free position, mount() reports the least centre distance and the
    // missing amount.
    place.center_distance = distance.value_or(least ? sum / std::cos(*least) : sum);
    return place;
  }
  if (shaft_angle) {
    place.shaft_angle = *shaft_angle;
  } else if (least) {
    place.shaft_angle =
        Angle::radians(common_rack(nominal, angles_at_transverse(nominal, *least)).shaft_angle);
  } else {
    Error error =
        beyond(shaft_angle_range(nominal), 0.0,
               fmt::format("is missing and cannot be computed, because the pair has no minimum "
                           "centre distance; the teeth are too thin by {:.6g} mm on the base "
                           "cylinders (normal). Give the shaft angle, or more profile shift; {}",
                           -excess, kReach));
    error.value.clear();
    return error;
  }
  if (distance) {
    place.center_distance = *distance;
    return place;
  }
  const auto rack = common_rack(nominal, angles_at_shaft_angle(nominal, place.shaft_angle->rad()));
  place.center_distance = conjugate_center_distance(nominal, rack);
  if (place.center_distance > 0.0) return place;
  return Error{
      "profile_shift", "",
      fmt::format("the teeth are too thin for any backlash-free centre distance at this shaft "
                  "angle (working normal pressure angle {:.4f}°); give either gear more profile "
                  "shift, or give `pair.center_distance` for a pair with backlash",
                  deg(rack.normal_pressure_angle))};
}

}  // namespace gearwright
