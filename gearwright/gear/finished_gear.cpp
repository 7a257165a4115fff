#include "gearwright/gear/finished_gear.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <fmt/format.h>
#include <boost/math/tools/minima.hpp>

#include "gearwright/base/contract.hpp"
#include "gearwright/base/number_text.hpp"
#include "gearwright/math/lowest.hpp"

namespace gearwright::detail {

Gear described(const CylindricalSpec& spec) {
  Gear gear{};
  gear.spec = spec;
  const auto reference = reference_geometry(spec.reference_input());
  gear.flanks = InvoluteTeeth{reference, {}, {}, {}, {}};
  gear.transverse_module = reference.transverse_module;
  gear.reference_diameter = reference.reference_diameter;
  const double m = spec.normal_module;
  const double d = gear.reference_diameter;
  const double x_E = reference.generating_profile_shift;
  const double sigma = gear.side();
  const double beta = spec.helix_angle.rad();
  gear.tip_diameter =
      spec.tip_diameter.value_or(d + sigma * 2 * m * (addendum_of(spec.rack) + spec.profile_shift));
  gear.root_diameter = d - sigma * 2 * m * (dedendum_of(spec.rack) - x_E);
  gear.lead = beta == 0.0 ? 0.0 : std::numbers::pi * d / std::tan(beta);
  const double psi_b = reference.base_tooth_thickness / reference.base_diameter;
  // The tooth of an internal gear becomes thinner inward, and its flanks meet at inv α = −ψ_b if
  // ψ_b is not positive. [T2.13]
  const double y = sigma * psi_b;
  if (y >= 0.0) gear.pointed_diameter = reference.base_diameter / std::cos(inverse_involute(y));
  return gear;
}

void warn(Gear& gear, WarningCode code, std::string message) {
  gear.warnings.push_back({code, std::move(message), 0});
}

namespace {

// Returns the profile shift x that the drawing must give, so that this gear has the given x_E with
// its thickness allowance.
double shift_for(const Gear& gear, double x_E) {
  return x_E - (gear.reference().generating_profile_shift - gear.spec.profile_shift);
}

// Returns the end of a sentence about undercut. It gives the cause of the undercut or a remedy.
std::string without_undercut(const Gear& gear) {
  if (const ArcTeeth* arcs = gear.arcs()) {
    return fmt::format(
        "the cutter's flank begins at a normal angle of {:.4f}°; without undercut it would begin "
        "at {:.4f}°.",
        arcs->flank_begin.deg(), arcs->undercut_limit->deg());
  }
  const auto free_shift = gear.undercut_free_shift();
  if (!free_shift) return "the pinion cutter reaches below the involute.";
  const double E_sn = gear.spec.thickness_allowance;
  if (gear.spec.profile_shift >= *free_shift)
    return fmt::format("the thickness allowance of {:.4f} mm causes the undercut.", E_sn);
  return fmt::format(
      "{}a profile shift of at least {:.4f} avoids undercut.",
      E_sn == 0.0 ? "" : fmt::format("with the thickness allowance of {:.4f} mm, ", E_sn),
      rounded_up(shift_for(gear, *free_shift), 4));
}

void warn_about_tip(Gear& gear) {
  const auto& s_an = gear.tip_tooth_thickness_normal;
  if (gear.pointed()) {
    const double end = gear.tooth ? 2 * gear.tooth->tip_radius : *gear.pointed_diameter;
    warn(gear, WarningCode::pointed,
         fmt::format(
             "The tooth is pointed and ends at a diameter of {:.4f} mm, so it does not reach "
             "the tip diameter of {:.4f} mm.",
             end, gear.tip_diameter));
  } else if (s_an && *s_an < 0.2 * gear.spec.normal_module &&
             !(gear.tooth && gear.tooth->rounded_tip)) {
    warn(gear, WarningCode::thin_tip,
         fmt::format("The tip of the tooth is only {:.4f} mm thick, which is less than 0.2 modules "
                     "({:.4f} mm).",
                     *s_an, 0.2 * gear.spec.normal_module));
  }
}

// Adds the warnings of an internal gear without a tooth. Of the values of its rack, only the
// addendum, the dedendum and the root fillet radius have an effect. The root fillet radius becomes
// the tip rounding of a default cutter.
void warn_about_ring(Gear& gear) {
  const StraightRack& rack = gear.spec.straight_rack();
  if (rack.tip_fillet_radius > 0.0 || rack.tool_addendum || rack.semi_topping_angle ||
      rack.protuberance > 0.0) {
    warn(gear, WarningCode::rack_not_used,
         "An internal gear is not cut by a rack, so `rack.tip_fillet_radius`, "
         "`rack.tool_addendum`, `rack.semi_topping_angle` and `rack.protuberance` have no effect.");
  }
  if (gear.tip_diameter < gear.reference().base_diameter) {
    warn(gear, WarningCode::tip_below_base,
         fmt::format("The tip diameter of the internal gear, {:.4f} mm, lies inside its base "
                     "circle of {:.4f} mm, where the flank has no involute.",
                     gear.tip_diameter, gear.reference().base_diameter));
  }
  warn_about_tip(gear);
}

// Returns the greatest profile shift at which the root fillets of a tooth without undercut do not
// meet. It is found by bisection to 1e-6. Returns none if a straight rack does not cut the tooth,
// if the tooth has a circular fillet, if the present profile shift has undercut, or if a tooth that
// is just without undercut is severed as well.
std::optional<double> greatest_shift(const Gear& gear) {
  const StraightRack* const rack = gear.straight_cutter();
  const auto least = gear.undercut_free_shift();
  if (!rack || !least || gear.spec.root_fillet || gear.spec.tip_fillet) return std::nullopt;
  const double m = gear.spec.normal_module;
  const double given = gear.reference().generating_profile_shift;
  const auto edge = make_edge(*rack, m, gear.spec.normal_pressure_angle);
  const auto leaves_tooth = [&](double x_E) {
    const RackMotion motion{gear.reference_diameter / 2, std::cos(gear.spec.helix_angle.rad()),
                            x_E * m};
    const auto tooth = cut_by_rack(edge.value().edge, motion, gear.spec.teeth,
                                   gear.tip_diameter / 2 + (x_E - given) * m);
    return tooth && !tooth->severed && !tooth->through_axis;
  };
  double below = *least, above = given;
  if (!(below < above) || !leaves_tooth(below)) return std::nullopt;
  while (above - below > 1e-6) {
    const double middle = (below + above) / 2;
    (leaves_tooth(middle) ? below : above) = middle;
  }
  return shift_for(gear, below);
}

// True if a gear without a usable flank would have one if its cutter had no protuberance.
bool protuberance_removes_flank(const Gear& gear) {
  const StraightRack* const rack = gear.straight_cutter();
  if (!rack || rack->protuberance <= 0.0) return false;
  CylindricalSpec plain = gear.spec;
  plain.straight_rack().protuberance = 0.0;
  const auto other = make_gear(plain);
  return other && other->root_form_radius().has_value();
}

void warn_about_tooth(Gear& gear) {
  const GeneratedTooth& tooth = *gear.tooth;
  if (tooth.through_axis) {
    warn(gear, WarningCode::through_axis,
         fmt::format("The cutter passes through the axis of the gear (root diameter {:.4f} mm), so "
                     "nothing is left of the gear.{}",
                     gear.root_diameter,
                     gear.spec.root_fillet ? ""
                                           : " With few teeth, `root_fillet` can replace the root "
                                             "that the cutter cuts. It belongs to a gear that has "
                                             "its own table."));
    return;
  }
  if (tooth.severed) {
    std::string message = "The root fillets of both flanks meet, so the tooth is cut off.";
    if (gear.undercut)
      message += " There is undercut; " + without_undercut(gear);
    else if (const auto most = greatest_shift(gear))
      message +=
          fmt::format(" A profile shift of at most {:.4f} leaves a tooth.", rounded_down(*most, 4));
    warn(gear, WarningCode::severed, message);
    return;
  }
  if (gear.undercut)
    warn(gear, WarningCode::undercut, undercut_message(gear, without_undercut(gear)));
  if (!tooth.form_radius) {
    warn(gear, WarningCode::no_flank,
         fmt::format(
             "No usable {}flank is left between root fillet and tip.{}",
             gear.involute() ? "involute " : "",
             protuberance_removes_flank(gear)
                 ? fmt::format(" The protuberance of the cutter, {:.4f} mm, removes the "
                               "flank; `rack.protuberance` is in modules.",
                               gear.straight_cutter()->protuberance * gear.spec.normal_module)
                 : ""));
  }
  warn_about_tip(gear);
  if (tooth.tip_cut_by_rack) {
    warn(gear, WarningCode::tip_cut_by_rack,
         fmt::format("The bottom land of the cutter ends the tooth at a diameter of {:.4f} mm, "
                     "below the tip diameter of the blank, {:.4f} mm.",
                     2 * tooth.tip_radius, gear.tip_diameter));
  }
}

// A tip that projects beyond the involute of its flank.
//
// A pinion cutter with undercut or protuberance lacks the part of its flank that would cut the tip
// of the gear. The remaining material projects beyond the involute and can collide with a mating
// gear.
//
//   δ = r_b (θ − θ_i)   distance from the involute along the normal of the involute, mm [T2.35]
//   θ, θ_i              polar angles of the outline and of the involute at one radius

constexpr double kNoise = 1e-9;  // modules; a smaller δ is a rounding error
constexpr int kHalfDigits = std::numeric_limits<double>::digits / 2;

double beyond_involute(const Gear& gear, const Vec2& p) {
  const double r_b = gear.base_radius();
  const double rho = std::max(r_b, p.norm());
  const double involute =
      tooth_thickness_transverse(gear.spec.teeth, 2 * r_b, gear.reference().base_tooth_thickness,
                                 2 * rho) /
      (2 * rho);
  return r_b * (std::atan2(p.y(), p.x()) - involute);
}

double greatest(const Gear& gear, const Arc& arc) {
  const auto less = [&](double u) { return -beyond_involute(gear, arc.point(u)); };
  const auto [lo, hi, least] = least_node(less, 16);
  return -std::min(least, boost::math::tools::brent_find_minima(less, lo, hi, kHalfDigits).second);
}

// Returns the greatest δ on the tip fillets beyond the flank. Returns none if it is at most 1e-9
// modules, or if the gear has no usable flank. The result is accurate to rounding if δ has only one
// maximum on each arc.
std::optional<TipBulge> tip_bulge(const Gear& gear) {
  if (!gear.tooth || !gear.tooth->form_radius) return std::nullopt;
  double most = kNoise * gear.spec.normal_module;
  bool any = false;
  bool past_the_flank = false;
  for (const Arc& arc : gear.tooth->outline.arcs) {
    if (arc.name == ArcName::flank) {
      past_the_flank = true;
    } else if (past_the_flank && arc.name == ArcName::tip_fillet) {
      const double d = greatest(gear, arc);
      any = any || d > most;
      most = std::max(most, d);
    }
  }
  if (!any) return std::nullopt;
  return TipBulge{most, 2 * gear.tip_form_radius()};
}

void find_tip_bulge(Gear& gear) {
  if (!gear.involute() || !gear.exists()) return;
  gear.tip_bulge = tip_bulge(gear);
  if (!gear.tip_bulge) return;
  const TipBulge& bulge = *gear.tip_bulge;
  warn(gear, WarningCode::tip_bulge,
       fmt::format(
           "The tip projects by {:.4g} mm beyond the involute above a diameter of {:.4f} mm, where "
           "the flank of the cutter ends. Mating gears other than the cutter may collide with this "
           "projection. A `tip_diameter` of at {} that diameter removes the projection.",
           bulge.amount, bulge.from_diameter, gear.internal() ? "least" : "most"));
}

// Returns the normal thickness of the finished tooth at its tip, which is the width of the
// remaining land. The thickness is 0 if the tip is pointed or rounded. Returns none if the gear
// does not exist, or if a gear without a tooth has its tip inside the base circle.
std::optional<double> tip_thickness(const Gear& gear) {
  if (!gear.exists()) return std::nullopt;
  if (!gear.involute()) {
    const double d_end = 2 * gear.tooth->tip_radius;
    const double s_t = gear.tooth->pointed ? 0.0 : d_end * gear.tooth->outline.arcs.back().begin;
    return s_t * cos_helix_at(gear.reference_diameter, gear.spec.helix_angle.rad(), d_end);
  }
  const double d_b = gear.reference().base_diameter;
  if (gear.tooth) {
    if (gear.tooth->pointed || gear.tooth->rounded_tip) return 0.0;
    const double d_end = 2 * gear.tooth->tip_radius;
    const Arc& land = gear.tooth->outline.arcs.back();
    // A tip on the base circle may lie inside this circle by a rounding error.
    const bool plain = gear.tooth->tip_form_radius == gear.tooth->tip_radius && d_end >= d_b;
    const double s_t = plain
                           ? tooth_thickness_transverse(
                                 gear.spec.teeth, d_b, gear.reference().base_tooth_thickness, d_end)
                           : d_end * land.begin;
    return s_t * cos_helix_at(d_b, gear.reference().base_helix_angle, d_end);
  }
  if (gear.tip_diameter < d_b) return std::nullopt;
  return tooth_thickness_transverse(gear.spec.teeth, d_b, gear.reference().base_tooth_thickness,
                                    gear.tip_diameter) *
         cos_helix_at(d_b, gear.reference().base_helix_angle, gear.tip_diameter);
}

}  // namespace

void finish(Gear& gear) {
  if (gear.tooth) gear.root_diameter = 2 * gear.tooth->root_radius;
  gear.tip_tooth_thickness_normal = tip_thickness(gear);
  if (gear.tooth) {
    warn_about_tooth(gear);
    find_tip_bulge(gear);
  } else {
    warn_about_ring(gear);
  }
}

}  // namespace gearwright::detail

namespace gearwright {

std::string undercut_message(const Gear& gear, std::string_view remedy) {
  const auto& from = gear.tooth->form_radius;
  return fmt::format(
      "There is undercut, so {}; {}",
      from ? fmt::format("the usable flank starts at a diameter of {:.4f} mm", 2 * *from)
           : std::string("no usable flank is left"),
      remedy);
}

}  // namespace gearwright
