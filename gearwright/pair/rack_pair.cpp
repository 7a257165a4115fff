#include "gearwright/pair/rack_pair.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

#include <fmt/format.h>

#include "gearwright/curve/basic_curves.hpp"
#include "gearwright/math/involute.hpp"
#include "gearwright/pair/mounted_gears.hpp"

namespace gearwright {

namespace {

constexpr double kNoLength = 1e-9;  // modules; shorter lengths are rounding errors
// The tip of the rack may extend below the start of the pinion's usable flank by this distance, in
// modules, without a warning. The limit allows for the fillet radii of ISO 53, which are rounded to
// two digits (0.38 for 0.37993).
constexpr double kRoundedFillet = 1e-4;

constexpr double kNoArc = 1e-6;  // modules; shorter arcs are below the resolution of any machine

// Least default number of teeth of a rack, for pictures and files.
constexpr int kFewestTeeth = 15;
// The default thickness of the body below the roots of a rack, modules. ISO 6336-3 reduces the
// bending strength if the rim is thinner than 1.2 tooth depths, which are 2.7 modules for the basic
// rack of ISO 53.
constexpr double kRimModules = 3.0;

// The smallest thickness between the roots and the back, mm.
constexpr double kLeastBack = 1e-3;
// Limits of the face width, which are those of a gear, and of the height, modules.
constexpr double kLeastWidth = 1e-3, kMostWidth = 1e5;

double alpha_t(const Gear& g) { return g.reference().transverse_pressure_angle; }
double alpha_n(const Gear& g) { return g.spec.normal_pressure_angle.rad(); }

// Returns the fillet radius of the basic rack. If this radius does not fit, returns the greatest
// radius that fits into the space of the rack. [T2.45]
double fillet_that_fits(const Gear& pinion, const RackGeometry& r) {
  const double space = (r.normal_pitch - r.thickness) / 2 - r.dedendum * std::tan(alpha_n(pinion));
  const double full = space * std::cos(alpha_n(pinion)) / (1 - std::sin(alpha_n(pinion)));
  const double given = pinion.spec.straight_rack().root_fillet_radius * r.normal_module;
  return std::clamp(given, 0.0, std::max(0.0, full));
}

RackGeometry geometry(const Gear& pinion, const RackBar& bar) {
  const double m = pinion.spec.normal_module;
  const StraightRack& profile = pinion.spec.straight_rack();
  RackGeometry r;
  r.bar = bar;
  r.teeth = bar.teeth.value_or(std::max(pinion.spec.teeth, kFewestTeeth) | 1);
  r.normal_module = m;
  r.helix_angle = Angle::radians(-pinion.spec.helix_angle.rad());
  r.normal_pressure_angle = pinion.spec.normal_pressure_angle;
  r.face_width = bar.face_width.value_or(pinion.spec.face_width);
  r.normal_pitch = std::numbers::pi * m;
  r.transverse_pitch = std::numbers::pi * pinion.transverse_module;
  r.addendum = profile.addendum * m;
  r.dedendum = profile.dedendum * m;
  r.height = bar.height.value_or(r.dedendum + kRimModules * m);
  r.thickness = r.normal_pitch / 2 + bar.thickness_allowance;
  r.fillet_radius = fillet_that_fits(pinion, r);
  return r;
}

// Clips approach and recess to the usable flanks. The pinion's flank begins at its form circle or
// base tangent point, and the rack's flank ends with its straight part. [T2.39]
void clip(RackPair& p) {
  const double r_b = p.pinion.base_radius();
  const double reach = p.pinion.reference_diameter / 2 * std::sin(alpha_t(p.pinion));
  const double r_Ff = p.pinion.root_form_radius().value_or(r_b);
  const double flank = reach - roll_length(r_Ff, r_b);
  p.true_approach = std::min({p.approach, reach, flank});
  const double below = p.center_distance - p.pinion.reference_diameter / 2 + p.rack.form_depth();
  p.true_recess = std::min(p.recess, below / std::sin(alpha_t(p.pinion)));
}

// Per radian of rotation of the pinion, the contact moves by ρ_1 over the flank of the pinion, and
// by the constant length r sin α_t over the flank of the rack. [T2.46]
SlidingPath sliding_path(const RackPair& p) {
  const double reach = p.pinion.reference_diameter / 2 * std::sin(alpha_t(p.pinion));
  const double begin = reach - p.true_approach, end = reach + p.true_recess;
  const double r_b = p.pinion.base_radius();
  return {begin,
          end,
          p.base_pitch,
          {{begin, reach}, {}},
          {{end, reach}, {}},
          r_b / std::hypot(1.0, r_b * p.pinion.twist())};
}

void warn(RackPair& p, WarningCode code, int gear, std::string message) {
  p.warnings.push_back({code, std::move(message), gear});
}

void note_defaults(RackPair& p) {
  const RackGeometry& rack = p.rack;
  if (!rack.bar.teeth)
    warn(p, WarningCode::default_rack_body, 2,
         fmt::format(
             "The number of teeth of the rack is not given; pictures and files contain {} teeth.",
             rack.teeth));
  if (rack.bar.space && *rack.bar.space - *rack.length() > kNoLength * rack.normal_module)
    warn(p, WarningCode::default_rack_body, 2,
         fmt::format("The rack has {} whole teeth and is {} mm long, which is {} mm less than the "
                     "given length.",
                     rack.teeth, format_number(*rack.length()),
                     format_number(*rack.bar.space - *rack.length())));
  if (!rack.bar.height)
    warn(p, WarningCode::default_rack_body, 2,
         fmt::format(
             "The height of the rack is not given; {} mm ({:g} modules below the roots) is used.",
             format_number(rack.height), kRimModules));
}

void find_faults(RackPair& p) {
  const double least = kNoLength * p.rack.normal_module;
  if (p.approach + p.recess <= least) {
    warn(p, WarningCode::no_contact, 0,
         "The teeth of pinion and rack do not reach each other. A smaller centre distance or "
         "longer teeth would help.");
    return;
  }
  const bool jams = p.stated_backlash().negative();
  if (jams) {
    warn(p, WarningCode::negative_backlash, 0,
         fmt::format("Pinion and rack jam, because the normal backlash is {:.4f} mm. At a centre "
                     "distance of {} mm, there is no backlash.",
                     p.normal_backlash(), format_number(p.backlash_free_center_distance)));
  }
  if (!(p.true_contact_ratio() > 0.0)) {
    // The teeth reach each other, so the rack is too close for its usable flank. If pinion and rack
    // jam, more profile shift would reduce the backlash further.
    warn(p, WarningCode::no_contact, 0,
         fmt::format("No part of the path of contact lies on the usable flanks of pinion and rack. "
                     "{} greater centre distance would help.",
                     jams ? "A" : "More profile shift or a"));
    return;
  }
  for (const int tip : {1, 2}) {
    const double c = p.tip_clearance[tip - 1];
    if (c >= -least) continue;
    warn(p, WarningCode::root, tip == 1 ? 2 : 1,
         fmt::format("The tip of the {} cuts {:.4f} mm into the root of the {}.",
                     tip == 1 ? "pinion" : "rack", -c, tip == 1 ? "rack" : "pinion"));
  }
  if (!p.contact_root_diameter && p.pinion.undercut) {
    const double reach = p.pinion.reference_diameter / 2 * std::sin(alpha_t(p.pinion));
    warn(p, WarningCode::contact_lost_to_undercut, 1,
         fmt::format("The tip of the rack reaches {:.4f} mm past the base tangent point of the "
                     "pinion, where undercut has removed the flank and contact is lost.",
                     p.approach - reach));
  } else if (!p.contact_root_diameter) {
    warn(p, WarningCode::base_tangent, 1,
         "The tip of the rack reaches past the base tangent point of the pinion. More profile "
         "shift or a greater centre distance would help.");
  } else if (p.form_clearance && *p.form_clearance < -kRoundedFillet * p.rack.normal_module) {
    warn(p, WarningCode::form_circle, 1,
         fmt::format("The tip of the rack reaches {:.4f} mm below the start of the usable flank of "
                     "gear 1 (d_Ff = {:.4f} mm).",
                     -*p.form_clearance, 2 * p.pinion.root_form_radius().value()));
  }
  if (p.true_contact_ratio() + p.overlap_ratio < 1.0) {
    warn(p, WarningCode::contact_ratio, 0,
         fmt::format("The contact ratio on the usable flanks is {:.3f}, which is less than 1.",
                     p.true_contact_ratio() + p.overlap_ratio));
  }
}

// Returns the error for a body that is too thin, or too large for any machine.
std::optional<Error> size_error(const RackGeometry& rack) {
  const double m = rack.normal_module, most = kMostWidth * m, b = rack.face_width;
  if (!(b >= kLeastWidth * m && b <= most))
    return refused(gear_field(2, "face_width"), b, {kLeastWidth * m, most},
                   "must lie between {} mm and {} mm");
  if (const double least = rack.dedendum + kLeastBack; !(rack.height >= least))
    return refused(
        gear_field(2, "height"), rack.height, {least},
        fmt::format("must be at least {{}} mm, because the back must lie below the roots "
                    "of the teeth, which are {} mm below the datum line",
                    format_number(rack.dedendum)));
  if (rack.height > most)
    return refused(gear_field(2, "height"), rack.height, {most},
                   "must be at most {} mm (100 000 modules)");
  return std::nullopt;
}

// Returns the error for a thickness allowance with which the land of a tooth or of a space would
// have a negative length.
std::optional<Error> land_error(const RackGeometry& rack) {
  const double slope = 2 * std::tan(rack.normal_pressure_angle.rad());
  const double least = rack.addendum * slope - rack.normal_pitch / 2;
  const double greatest = rack.normal_pitch / 2 - rack.dedendum * slope;
  const double allowance = rack.bar.thickness_allowance, none = kNoArc * rack.normal_module;
  if (allowance >= least - none && allowance <= greatest + none) return std::nullopt;
  return refused(gear_field(2, "thickness_allowance"), allowance, {least, greatest},
                 "must lie between {} mm, at which the tooth is pointed, and {} mm, at which the "
                 "tooth space closes at the root");
}

}  // namespace

std::optional<double> RackGeometry::length() const {
  return bar.teeth ? std::optional(*bar.teeth * transverse_pitch) : std::nullopt;
}

double RackGeometry::form_depth() const {
  return dedendum - fillet_radius * (1 - std::sin(normal_pressure_angle.rad()));
}

Pose<Housing, Gear2> RackPair::pose_2() const {
  // A half turn about z makes the teeth of the rack point towards axis 1. If the number of teeth is
  // odd, a tooth is in the middle of the rack. The rack is then displaced by half a pitch, so that
  // a space moves to this position.
  const bool odd = rack.teeth % 2 == 1;
  return {Vec3(center_distance, odd ? rack.transverse_pitch / 2 : 0.0, 0.0),
          Mat3(Vec3(-1.0, -1.0, 1.0).asDiagonal())};
}

double RackPair::transverse_contact_ratio() const {
  return std::max(0.0, (approach + recess) / base_pitch);
}

double RackPair::true_contact_ratio() const {
  return std::max(0.0, (true_approach + true_recess) / base_pitch);
}

std::array<double, 2> RackPair::approach_and_recess() const {
  if (!(true_contact_ratio() > 0.0)) return {0.0, 0.0};
  const double c = std::clamp(0.0, -true_approach, true_recess);
  return {(c + true_approach) / base_pitch, (true_recess - c) / base_pitch};
}

double RackPair::contact_start() const {
  return pinion.undercut && true_contact_ratio() > 0.0 ? -true_approach : -approach;
}

double RackPair::base_backlash() const {
  return 2 * (center_distance - backlash_free_center_distance) * std::sin(alpha_n(pinion));
}

double RackPair::normal_backlash() const { return base_backlash() / std::cos(alpha_n(pinion)); }

StatedBacklash RackPair::stated_backlash() const {
  return {normal_backlash(), std::cos(alpha_n(pinion)), center_distance, rack.normal_module};
}

double RackPair::circumferential_backlash() const {
  return 2 * (center_distance - backlash_free_center_distance) * std::tan(alpha_t(pinion));
}

std::array<std::optional<double>, 2> RackPair::specific_sliding(double g) const {
  const double reach = pinion.reference_diameter / 2 * std::sin(alpha_t(pinion));
  const bool on_involute = reach + g > kNoLength * rack.normal_module;
  return {on_involute ? std::optional(g / (reach + g)) : std::nullopt, -g / reach};
}

Result<RackPair> mount_rack(Gear pinion, const RackBar& bar, std::optional<double> center_distance,
                            std::optional<double> speed_rpm, std::optional<double> friction) {
  GW_EXPECTS(!center_distance || *center_distance > 0.0);
  if (pinion.internal())
    return refused(gear_field(1, "teeth"), pinion.spec.teeth,
                   "the pinion of a rack must be an external gear");
  if (!pinion.involute())
    return Error{gear_field(1, "rack"), "",
                 "cuts circular arcs, but a rack as gear 2 has straight flanks"};
  if (!pinion.exists()) return within(gear_field(1), pinion.why_not());
  RackPair p;
  p.rack = geometry(pinion, bar);
  if (auto error = size_error(p.rack)) return *error;
  if (auto error = land_error(p.rack)) return *error;
  p.pinion = std::move(pinion);
  p.speed_rpm = speed_rpm;
  const Gear& g = p.pinion;
  const auto& reference = g.reference();
  const double m = g.spec.normal_module, r = g.reference_diameter / 2;
  const double sin_t = std::sin(alpha_t(g));
  p.center_distance = center_distance.value_or(r + g.spec.profile_shift * m);
  p.backlash_free_center_distance = r + reference.generating_profile_shift * m +
                                    bar.thickness_allowance / (2 * std::tan(alpha_n(g)));
  p.travel_per_turn = g.spec.teeth * p.rack.transverse_pitch;
  p.base_pitch = reference.base_pitch_transverse;
  const double shifted = p.center_distance - r;  // distance from the pitch line to the datum line
  const double r_a = g.tip_form_radius(), r_b = g.base_radius();
  p.recess = roll_length(r_a, r_b) - r * sin_t;
  p.approach = (p.rack.addendum - shifted) / sin_t;
  clip(p);
  const double face = std::min(g.spec.face_width, p.rack.face_width);
  p.overlap_ratio = face * std::abs(std::sin(g.spec.helix_angle.rad())) / (std::numbers::pi * m);
  const double total = p.true_contact_ratio() + p.overlap_ratio;
  if (friction && total >= 1.0 && p.true_contact_ratio() > 0.0)
    p.efficiency = efficiency(sliding_shares(sliding_path(p)), *friction);
  p.tip_clearance = {p.center_distance + p.rack.dedendum - g.actual_tip_radius(),
                     p.center_distance - p.rack.addendum - g.root_diameter / 2};
  if (const double start = r * sin_t - p.approach; start >= 0.0)
    p.contact_root_diameter = 2 * std::hypot(start, r_b);
  if (const auto r_Ff = g.root_form_radius(); r_Ff && p.contact_root_diameter)
    p.form_clearance = *p.contact_root_diameter / 2 - *r_Ff;
  note_defaults(p);
  find_faults(p);
  return p;
}

namespace {

// Builds an outline. Each arc begins at the end of the preceding arc.
class OutlineOfArcs {
 public:
  OutlineOfArcs(int teeth, const Vec2& begin) : end_(begin) { outline_.teeth = teeth; }
  void line(ArcName name, const Vec2& to) {
    outline_.arcs.push_back({name, std::make_shared<StraightLine>(end_, to), 0.0, 1.0, end_, to});
    end_ = to;
  }
  void curve(ArcName name, CurvePtr curve, double begin, double end) {
    const Vec2 to = curve->point(end);
    outline_.arcs.push_back({name, std::move(curve), begin, end, end_, to});
    end_ = to;
  }
  Outline take() { return std::move(outline_); }

 private:
  Outline outline_;
  Vec2 end_;
};

}  // namespace

Result<Outline> rack_outline(const RackGeometry& rack) {
  using std::numbers::pi;
  const double alpha = rack.normal_pressure_angle.rad();
  const double tan_n = std::tan(alpha), half = rack.thickness / 2;
  const double k = 1 / std::cos(rack.helix_angle.rad());
  const double none = kNoArc * rack.normal_module;
  if (auto error = land_error(rack)) return *error;
  const double rho = rack.fillet_radius, middle = rack.normal_pitch / 2;
  const double x_c = rho - rack.dedendum;
  const double n_c = half + (rho - x_c * std::sin(alpha)) / std::cos(alpha);
  const double tip = half - rack.addendum * tan_n;
  OutlineOfArcs arcs(rack.teeth, {-rack.dedendum, k * middle});
  // With a full fillet radius there is no root land, and with a pointed tooth there is no tip land.
  if (middle - n_c > none) arcs.line(ArcName::root_land, {-rack.dedendum, k * n_c});
  if (rho > none)
    arcs.curve(ArcName::root_fillet, std::make_shared<StretchedCircle>(Vec2(x_c, k * n_c), rho, k),
               pi, 1.5 * pi - alpha);
  arcs.line(ArcName::flank, {rack.addendum, tip > none ? k * tip : 0.0});
  if (tip > none) arcs.line(ArcName::tip_land, {rack.addendum, 0.0});
  return arcs.take();
}

}  // namespace gearwright
