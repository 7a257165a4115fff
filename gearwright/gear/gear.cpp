#include "gearwright/gear/gear.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "gearwright/base/error.hpp"
#include "gearwright/base/overloaded.hpp"
#include "gearwright/gear/finished_gear.hpp"
#include "gearwright/math/root.hpp"

namespace gearwright {

namespace {

// The limits of a spec. They lie far beyond real gears. All formulas are tested within these
// limits.
constexpr int kMaxTeeth = 100'000;
constexpr double kMinModule = 1e-3;   // mm
constexpr double kMaxModule = 1e3;    // mm
constexpr double kMaxHelix = 89.0;    // degrees
constexpr double kMinPressure = 1.0;  // degrees
constexpr double kMaxPressure = 60.0;
constexpr double kMaxShift = 1e4;       // modules
constexpr double kMaxAllowance = 10.0;  // modules
constexpr double kMinFace = 1e-3;       // modules
constexpr double kMaxFace = 1e5;        // modules
constexpr double kMaxTip = 1e3;         // times the reference diameter

}  // namespace

const StraightRack& CylindricalSpec::straight_rack() const {
  const auto* straight = std::get_if<StraightRack>(&rack);
  GW_EXPECTS(straight != nullptr);
  return *straight;
}

StraightRack& CylindricalSpec::straight_rack() {
  return const_cast<StraightRack&>(std::as_const(*this).straight_rack());
}

std::optional<Error> check_limits(const CylindricalSpec& spec) {
  if (spec.teeth == 0)
    return refused("teeth", 0, "must not be 0; the number is negative for an internal gear");
  if (std::abs(spec.teeth) > kMaxTeeth) {
    return refused("teeth", spec.teeth,
                   fmt::format("must be at most {}, or for an internal gear at least -{}",
                               kMaxTeeth, kMaxTeeth));
  }
  struct Limit {
    const char* field;
    double value, lo, hi;
    const char* rule;
  };
  const double m = spec.normal_module;
  for (const Limit& l : {Limit{"normal_module", m, kMinModule, kMaxModule,
                               "must lie between {}\u00a0mm and {}\u00a0mm"},
                         {"normal_pressure_angle", spec.normal_pressure_angle.deg(), kMinPressure,
                          kMaxPressure, "must lie between {}° and {}°, usually 14.5° to 30°"},
                         {"helix_angle", spec.helix_angle.deg(), -kMaxHelix, kMaxHelix,
                          "must lie between {}° (left hand) and {}° (right hand)"},
                         {"profile_shift", spec.profile_shift, -kMaxShift, kMaxShift,
                          "must lie between {} and {} modules"},
                         {"thickness_allowance", spec.thickness_allowance, -kMaxAllowance * m,
                          kMaxAllowance * m, "must lie between {} mm and {} mm (10 modules)"},
                         {"face_width", spec.face_width, kMinFace * m, kMaxFace * m,
                          "must lie between {} mm and {} mm"}}) {
    if (!(l.value >= l.lo && l.value <= l.hi))  // also true for NaN
      return refused(l.field, l.value, {l.lo, l.hi}, l.rule);
  }
  const double d = m / std::cos(spec.helix_angle.rad()) * std::abs(spec.teeth);
  if (spec.tip_diameter && !(*spec.tip_diameter > 0.0 && *spec.tip_diameter <= kMaxTip * d)) {
    return refused("tip_diameter", *spec.tip_diameter, {0.0, kMaxTip * d},
                   "must be greater than {} and at most {} mm");
  }
  return std::nullopt;
}

namespace {

// Removes a tip fillet that begins beyond the blank, and adds a warning.
void forget_fillet_cut_off(Gear& gear, double fillet_begin) {
  GeneratedTooth& tooth = *gear.tooth;
  if (!tooth.tip_fillet || !(gear.tip_diameter / 2 <= fillet_begin)) return;
  tooth.tip_fillet.reset();
  std::get<InvoluteTeeth>(gear.flanks).point_j_l.reset();
  detail::warn(gear, WarningCode::tip_fillet_cut_off,
               fmt::format("The tooth ends at a diameter of {:.4f} mm, before its tip fillet "
                           "begins, so `tip_fillet` has no effect.",
                           2 * tooth.tip_radius));
}

std::optional<Error> cut(Gear& gear, const CutterEdge& edge) {
  const CylindricalSpec& spec = gear.spec;
  auto& flanks = std::get<InvoluteTeeth>(gear.flanks);
  const double x_E = gear.reference().generating_profile_shift;
  const RackMotion motion{gear.reference_diameter / 2, std::cos(spec.helix_angle.rad()),
                          x_E * spec.normal_module};
  const FlankRuler ruler = flank_ruler(edge, motion);
  flanks.undercut_l = ruler.undercut_l();
  flanks.undercut_free_profile_shift = leaf::undercut_limit<double>(  // [T3.14]
      edge.flank_begin_depth / spec.normal_module, spec.teeth,
      std::sin(gear.reference().transverse_pressure_angle), std::cos(spec.helix_angle.rad()));
  gear.undercut = !spec.root_fillet && x_E < flanks.undercut_free_profile_shift;
  const double land = left_by_land(edge, motion);
  const bool corner = spec.tip_fillet && spec.tip_fillet->by == TipFilletSpec::By::corner;
  const std::optional<double> blank = corner ? std::optional(std::min(gear.tip_diameter / 2, land))
                                      : spec.tip_diameter || !spec.tip_fillet
                                          ? std::optional(gear.tip_diameter / 2)
                                          : std::nullopt;
  auto fillets = circular_fillets(ruler, spec.teeth, spec.root_fillet, spec.tip_fillet, blank);
  if (!fillets) return fillets.error();
  if (fillets->root) flanks.point_c_l = ruler.l(fillets->root->roll);
  if (fillets->tip) {
    flanks.point_j_l = ruler.l(fillets->tip->roll);
    // If no blank is given, the tooth ends where its tip fillet ends.
    if (!blank) gear.tip_diameter = 2 * fillets->tip->arc.end;
  }
  auto tooth = cut_by_rack(edge, motion, spec.teeth, gear.tip_diameter / 2, *fillets);
  if (!tooth) return tooth.error();
  gear.tooth = std::move(tooth).take();
  if (fillets->tip)
    forget_fillet_cut_off(gear, ruler.flank.base_radius() * std::hypot(1.0, fillets->tip->roll));
  return std::nullopt;
}

}  // namespace

const StraightRack* Gear::straight_cutter() const {
  return cut_by ? nullptr : std::get_if<StraightRack>(&spec.rack);
}

std::optional<double> Gear::undercut_free_shift() const {
  const InvoluteTeeth* const teeth = involute();
  return teeth ? teeth->undercut_free_profile_shift : std::nullopt;
}

const ReferenceGeometry<double>& Gear::reference() const {
  const InvoluteTeeth* const teeth = involute();
  GW_EXPECTS(teeth != nullptr);
  return teeth->reference;
}

Error Gear::why_not() const {
  GW_EXPECTS(!exists() && !warnings.empty());
  const std::string& why = warnings.back().message;
  if (!involute()) return {"rack", "", why};
  const double allowance = spec.thickness_allowance;
  const auto exists_with = [&](double thinner) {
    CylindricalSpec other = spec;
    other.thickness_allowance = thinner;
    const auto gear = make_gear(other);
    return gear && gear->exists();
  };
  if (!straight_cutter() || !(allowance < 0.0) || !exists_with(0.0))
    return refused("profile_shift", spec.profile_shift, why);
  return refused(
      "thickness_allowance", allowance, {nearest_possible(0.0, allowance, exists_with)},
      "the thickness allowance must be at least {} mm, because the cutter cuts off thinner teeth");
}

std::optional<double> Gear::root_form_radius() const {
  return tooth ? tooth->form_radius : std::nullopt;
}

bool Gear::pointed() const {
  if (tooth) return tooth->pointed;
  return pointed_diameter && *pointed_diameter > tip_diameter;
}

double Gear::tip_form_radius() const {
  if (!tooth) return std::max(tip_diameter / 2, base_radius());
  return tooth->tip_form_radius.value_or(tip_diameter / 2);
}

double Gear::actual_tip_radius() const {
  return tooth && exists() ? tooth->tip_radius : tip_diameter / 2;
}

double Gear::twist() const { return lead == 0.0 ? 0.0 : 2 * std::numbers::pi / lead; }

namespace {

Result<Gear> make_involute_gear(const CylindricalSpec& spec, const StraightRack& rack) {
  Gear gear = detail::described(spec);
  auto rack_edge = make_edge(rack, spec.normal_module, spec.normal_pressure_angle);
  if (!rack_edge) return rack_edge.error();
  const CutterEdge& edge = rack_edge->edge;
  if (rack_edge->became_full_radius) {
    detail::warn(
        gear, WarningCode::full_radius_root,
        fmt::format("The root fillet radius {} of the rack does not fit at this pressure angle. "
                    "The full radius {:.6f} is used instead.",
                    rack.root_fillet_radius, full_radius(rack, spec.normal_pressure_angle)));
  }
  if (gear.internal()) {
    if (!(gear.tip_diameter > 0.0 && gear.tip_diameter < gear.root_diameter)) {
      return refused(
          "tip_diameter", gear.tip_diameter, {0.0, gear.root_diameter},
          "must be greater than {} mm and less than the root diameter of the internal gear, {} mm");
    }
    for (const auto* fillet :
         {spec.root_fillet ? "root_fillet" : nullptr, spec.tip_fillet ? "tip_fillet" : nullptr}) {
      if (!fillet) continue;
      return Error{fillet, "",
                   "is not available for an internal gear, because the cutter determines its root "
                   "and tip; give the fillet of the cutter in `cut_by`"};
    }
  } else if (auto error = cut(gear, edge)) {
    return *error;
  }
  detail::finish(gear);
  return gear;
}

}  // namespace

Result<Gear> make_gear(const CylindricalSpec& spec) {
  if (auto error = check_limits(spec)) return *error;
  return std::visit(
      Overloaded{[&](const StraightRack& rack) { return make_involute_gear(spec, rack); },
                 [&](const auto& rack) { return detail::make_arc_gear(spec, arcs_of(rack)); }},
      spec.rack);
}

}  // namespace gearwright
