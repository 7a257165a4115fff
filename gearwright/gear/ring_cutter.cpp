#include "gearwright/gear/ring_cutter.hpp"

#include <fmt/format.h>

#include <cmath>

#include "gearwright/gear/finished_gear.hpp"
#include "gearwright/gear/pinion_cut.hpp"

namespace gearwright {

namespace {

constexpr double kCutterDedendum = 1.5;  // modules; with a sharp root, so that the cutter clears
                                         // the tip of any internal gear
constexpr double kMinLand = 0.1;         // modules, at the cutter's tip
constexpr double kSameTip = 1e-9;        // relative tolerance for the requested tip

struct Cutter {
  Gear gear;
  double distance;
};

// A cutter of z_0 teeth with this tip rounding, which reaches the root of the internal gear.
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
  // A cutter without a land or with a truncated rounding would not reach the root.
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
  detail::warn(
      with, WarningCode::default_cutter,
      fmt::format(
          "`cut_by` is not given, so a default pinion cutter generates the fillets of the internal "
          "gear. It has {} teeth and no profile shift, and it reaches the root diameter.",
          cutter.gear.spec.teeth));
  return with;
}

}  // namespace

std::optional<Gear> cut_by_default(const Gear& ring) {
  GW_EXPECTS(ring.internal() && !ring.tooth);
  const int z = -ring.spec.teeth;
  for (const double share : {0.5, 0.6, 0.4, 0.7, 0.8, 0.3, 0.2, 0.1}) {
    const int z_0 = static_cast<int>(share * z);
    if (z_0 < 1) continue;
    for (const double rounding : {ring.spec.straight_rack().root_fillet_radius, 0.2, 0.0}) {
      const auto cutter = cutter_of(ring, z_0, rounding);
      if (!cutter) continue;
      // A cutter that removes part of the flank is not suitable.
      auto cut = cut_with(ring, *cutter);
      if (cut && cut->tooth->tip_form_radius == cut->tooth->tip_radius &&
          cut->tooth->tip_radius == ring.tip_diameter / 2) {
        return cut;
      }
    }
  }
  return std::nullopt;
}

}  // namespace gearwright
