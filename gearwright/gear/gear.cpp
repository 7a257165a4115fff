#include "gearwright/gear/gear.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "gearwright/base/refusal.hpp"

namespace gearwright {

namespace {

// What a spec may say. The limits lie far beyond every gear that was ever cut and keep each formula
// inside the domain it was measured in.
constexpr int kMostTeeth = 100'000;
constexpr double kLeastModule = 1e-3;    // mm
constexpr double kGreatestModule = 1e3;  // mm
constexpr double kGreatestHelix = 89.0;  // degrees
constexpr double kLeastPressure = 1.0;   // degrees
constexpr double kGreatestPressure = 60.0;
constexpr double kGreatestShift = 1e4;       // modules
constexpr double kGreatestAllowance = 10.0;  // modules
constexpr double kLeastFace = 1e-3;          // modules
constexpr double kGreatestFace = 1e5;        // modules
constexpr double kGreatestTip = 1e3;         // times the reference diameter

}  // namespace

std::optional<Error> check_limits(const CylindricalSpec& spec) {
  const auto within = [](double v, double lo, double hi) {
    return v >= lo && v <= hi;
  };  // false for NaN
  if (spec.teeth == 0)
    return refused("teeth", 0, "must not be 0; negative for an internal gear (ring)");
  if (std::abs(spec.teeth) > kMostTeeth) {
    return refused(
        "teeth", spec.teeth,
        fmt::format("must be at most {} (a ring: at least -{})", kMostTeeth, kMostTeeth));
  }
  const double m = spec.normal_module;
  if (!within(m, kLeastModule, kGreatestModule)) {
    return refused("normal_module_mm", m,
                   fmt::format("must lie between {} and {} mm", kLeastModule, kGreatestModule));
  }
  const double alpha = spec.normal_pressure_angle.deg();
  if (!within(alpha, kLeastPressure, kGreatestPressure)) {
    return refused("normal_pressure_angle_deg", alpha,
                   fmt::format("must lie between {} and {}, usually 14.5 to 30", kLeastPressure,
                               kGreatestPressure));
  }
  const double beta = spec.helix_angle.deg();
  if (!within(beta, -kGreatestHelix, kGreatestHelix)) {
    return refused("helix_angle_deg", beta,
                   fmt::format("must lie between -{} (left hand) and {} (right hand)",
                               kGreatestHelix, kGreatestHelix));
  }
  if (!within(spec.profile_shift, -kGreatestShift, kGreatestShift)) {
    return refused(
        "profile_shift", spec.profile_shift,
        fmt::format("must lie between -{} and {} modules", kGreatestShift, kGreatestShift));
  }
  const double allowance = kGreatestAllowance * m;
  if (!within(spec.thickness_allowance, -allowance, allowance)) {
    return refused(
        "thickness_allowance_mm", spec.thickness_allowance,
        fmt::format("must lie between -{} and {} mm (10 modules)", allowance, allowance));
  }
  if (!within(spec.face_width, kLeastFace * m, kGreatestFace * m)) {
    return refused("face_width_mm", spec.face_width,
                   fmt::format("must lie between {} and {} mm", kLeastFace * m, kGreatestFace * m));
  }
  const double d = m / std::cos(spec.helix_angle.rad()) * std::abs(spec.teeth);
  if (spec.tip_diameter && !(*spec.tip_diameter > 0.0 && *spec.tip_diameter <= kGreatestTip * d)) {
    return refused("tip_diameter_mm", *spec.tip_diameter,
                   fmt::format("must be greater than 0 and at most {} mm", kGreatestTip * d));
  }
  return std::nullopt;
}

namespace {

void warn(Gear& gear, const char* code, std::string message) {
  gear.warnings.push_back({code, std::move(message), 0});
}

// The shift that a drawing would need for x_E to reach the limit: the allowance is on top.
double shift_for(const Gear& gear, double x_E) {
  return x_E - (gear.reference.generating_profile_shift - gear.spec.profile_shift);
}

void warn_about_tip(Gear& gear) {
  const auto& s_an = gear.tip_tooth_thickness_normal;
  if (gear.pointed()) {
    const double end = gear.tooth ? 2 * gear.tooth->tip_radius : *gear.pointed_diameter;
    warn(gear, "pointed",
         fmt::format(
             "Pointed: the tooth ends at {:.4f} mm diameter, before the tip diameter {:.4f} mm.",
             end, gear.tip_diameter));
  } else if (s_an && *s_an < 0.2 * gear.spec.normal_module) {
    warn(gear, "thin_tip",
         fmt::format("Thin tip: {:.4f} mm, less than 0.2 modules ({:.4f} mm).", *s_an,
                     0.2 * gear.spec.normal_module));
  }
}

// What the numbers of a rack say of a ring: nothing beyond addendum and dedendum.
void warn_about_ring(Gear& gear) {
  const StraightRack& rack = gear.spec.rack;
  if (rack.tip_fillet_radius > 0.0 || rack.tool_addendum || rack.semi_topping_angle ||
      rack.protuberance > 0.0) {
    warn(gear, "rack_not_used",
         "A ring is not cut by a rack: tip_fillet_radius, tool_addendum, semi_topping_angle_deg "
         "and protuberance "
         "have no effect on it.");
  }
  if (gear.tip_diameter < gear.reference.base_diameter) {
    warn(gear, "tip_below_base",
         fmt::format(
             "The ring's tip {:.4f} mm lies inside its base circle {:.4f} mm: the flank has no "
             "involute there.",
             gear.tip_diameter, gear.reference.base_diameter));
  }
  warn_about_tip(gear);
}

void warn_about_tooth(Gear& gear) {
  const GeneratedTooth& tooth = *gear.tooth;
  if (tooth.through_axis) {
    warn(gear, "through_axis",
         fmt::format(
             "The cutter passes the gear's axis (root diameter {:.4f} mm): there is no gear. More "
             "teeth, more profile shift or a smaller dedendum would help.",
             gear.root_diameter));
    return;
  }
  if (tooth.severed) {
    warn(gear, "severed",
         fmt::format("The root fillets of both sides meet: the tooth is cut off. {}",
                     gear.undercut
                         ? fmt::format("More profile shift helps; without undercut it is {:.4f}.",
                                       shift_for(gear, gear.undercut_free_profile_shift))
                         : std::string("Less profile shift or a thicker tooth would help.")));
    return;
  }
  if (gear.undercut) {
    warn(gear, "undercut",
         fmt::format("Undercut: the usable flank starts at {}; a profile shift of at least {:.4f} "
                     "avoids it.",
                     tooth.form_radius ? fmt::format("{:.4f} mm diameter", 2 * *tooth.form_radius)
                                       : std::string("no diameter"),
                     shift_for(gear, gear.undercut_free_profile_shift)));
  }
  if (!tooth.form_radius) {
    warn(gear, "no_flank", "No usable involute flank is left between root fillet and tip.");
  }
  warn_about_tip(gear);
  if (tooth.tip_cut_by_rack) {
    warn(gear, "tip_cut_by_rack",
         fmt::format(
             "The cutter's bottom land tops the tooth at {:.4f} mm diameter, below the blank's "
             "{:.4f} mm.",
             2 * tooth.tip_radius, gear.tip_diameter));
  }
}

// Normal thickness of the finished tooth at its tip: the land that is left, 0 at a point.
std::optional<double> tip_thickness(const Gear& gear) {
  if (!gear.exists()) return std::nullopt;
  const double d_b = gear.reference.base_diameter;
  if (gear.tooth) {
    if (gear.tooth->pointed) return 0.0;
    const double d_end = 2 * gear.tooth->tip_radius;
    const Arc& land = gear.tooth->outline.arcs.back();
    // A tip on the base circle itself may lie an ulp inside it.
    const bool plain = gear.tooth->tip_form_radius == gear.tooth->tip_radius && d_end >= d_b;
    const double s_t = plain ? tooth_thickness_transverse(
                                   gear.spec.teeth, d_b, gear.reference.base_tooth_thickness, d_end)
                             : d_end * land.begin;
    return s_t * cos_helix_at(d_b, gear.reference.base_helix_angle, d_end);
  }
  if (gear.tip_diameter < d_b) return std::nullopt;
  return tooth_thickness_transverse(gear.spec.teeth, d_b, gear.reference.base_tooth_thickness,
                                    gear.tip_diameter) *
         cos_helix_at(d_b, gear.reference.base_helix_angle, gear.tip_diameter);
}

}  // namespace

std::optional<double> Gear::root_form_radius() const {
  return tooth ? tooth->form_radius : std::nullopt;
}

bool Gear::pointed() const {
  if (tooth) return tooth->pointed;
  return pointed_diameter && *pointed_diameter > tip_diameter;
}

double Gear::tip_form_radius() const {
  if (tooth && tooth->tip_form_radius) return *tooth->tip_form_radius;
  return internal() ? std::max(tip_diameter / 2, base_radius()) : tip_diameter / 2;
}

double Gear::actual_tip_radius() const {
  return tooth && exists() ? tooth->tip_radius : tip_diameter / 2;
}

double Gear::twist() const { return lead == 0.0 ? 0.0 : 2 * std::numbers::pi / lead; }

Result<Gear> make_gear(const CylindricalSpec& spec) {
  if (auto error = check_limits(spec)) return *error;
  Gear gear{};
  gear.spec = spec;
  gear.reference = reference_geometry<double>(
      {spec.teeth, spec.normal_module, spec.normal_pressure_angle.rad(), spec.helix_angle.rad(),
       spec.profile_shift, spec.thickness_allowance});
  auto rack_edge = make_edge(spec.rack, spec.normal_module, spec.normal_pressure_angle);
  if (!rack_edge) return rack_edge.error();
  const CutterEdge& edge = rack_edge->edge;

  const double m = spec.normal_module;
  const double d = gear.reference.reference_diameter;
  const double x_E = gear.reference.generating_profile_shift;
  const double sign = gear.internal() ? -1.0 : 1.0;
  const double beta = spec.helix_angle.rad();
  gear.tip_diameter =
      spec.tip_diameter.value_or(d + sign * 2 * m * (spec.rack.addendum + spec.profile_shift));
  gear.root_diameter = d - sign * 2 * m * (spec.rack.dedendum - x_E);
  gear.lead = beta == 0.0 ? 0.0 : std::numbers::pi * d / std::tan(beta);
  const double sin_alpha_t = std::sin(gear.reference.transverse_pressure_angle);
  gear.undercut_free_profile_shift = edge.flank_begin_depth / m - std::abs(spec.teeth) *
                                                                      sin_alpha_t * sin_alpha_t /
                                                                      (2 * std::cos(beta));
  const double psi_b = gear.reference.base_tooth_thickness / gear.reference.base_diameter;
  // A ring's tooth thins inward: its flanks meet at inv α = −ψ_b, if they do.
  const double y = sign * psi_b;
  if (y >= 0.0)
    gear.pointed_diameter = gear.reference.base_diameter / std::cos(inverse_involute(y));

  if (rack_edge->became_full_radius) {
    warn(gear, "full_radius_root",
         fmt::format(
             "The rack's root fillet radius {} does not fit at this pressure angle; the full "
             "radius {:.6f} is used.",
             spec.rack.root_fillet_radius, full_radius(spec.rack, spec.normal_pressure_angle)));
  }
  if (gear.internal()) {
    if (!(gear.tip_diameter > 0.0 && gear.tip_diameter < gear.root_diameter)) {
      return refused(
          "tip_diameter_mm", gear.tip_diameter,
          fmt::format("must be greater than 0 and less than the ring's root diameter {} mm",
                      gear.root_diameter));
    }
    gear.undercut = false;
    gear.tip_tooth_thickness_normal = tip_thickness(gear);
    warn_about_ring(gear);
    return gear;
  }
  gear.undercut = x_E < gear.undercut_free_profile_shift;
  const RackMotion motion{d / 2, std::cos(beta), x_E * m};
  auto tooth = cut_by_rack(edge, motion, spec.teeth, gear.tip_diameter / 2);
  if (!tooth) return tooth.error();
  gear.tooth = std::move(tooth).take();
  gear.root_diameter = 2 * gear.tooth->root_radius;
  gear.tip_tooth_thickness_normal = tip_thickness(gear);
  warn_about_tooth(gear);
  return gear;
}

}  // namespace gearwright
