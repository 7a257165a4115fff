#include "gearwright/scatter/member_clearances.hpp"

#include <cmath>

#include "gearwright/base/numbers.hpp"
#include "gearwright/math/involute.hpp"
#include "gearwright/pair/clearances.hpp"
#include "gearwright/pair/involute_pair.hpp"

namespace gearwright {

namespace {

// The radii of a gear after a change of its tooth thickness, mm; NaN if there is no closed form.
struct Radii {
  double root, form;
};

// True if the blank determines the tip, so that the tip does not move with the rack.
bool has_plain_tip(const Gear& gear) {
  return gear.actual_tip_radius() == gear.tip_diameter / 2 &&
         gear.tip_form_radius() == gear.tip_diameter / 2;
}

Radii radii_of(const Gear& gear, double thickness) {
  Radii radii{gear.root_diameter / 2, gear.root_form_radius().value_or(kNoNumber)};
  if (thickness == 0.0) return radii;
  const bool by_rack = gear.tooth && !gear.cut_by && !gear.spec.root_fillet;
  if (!by_rack || !has_plain_tip(gear)) return {kNoNumber, kNoNumber};
  const double shift = thickness / (2 * std::tan(gear.spec.normal_pressure_angle.rad()));
  radii.root += shift;
  const ReferenceGeometry<double>& reference = gear.reference();
  const auto least = gear.undercut_free_shift();
  const double x_E = reference.generating_profile_shift + shift / gear.spec.normal_module;
  if (gear.undercut || (least && x_E < *least)) return {radii.root, kNoNumber};
  const double r_b = gear.base_radius();
  const double rho =
      roll_length(radii.form, r_b) + shift / std::sin(reference.transverse_pressure_angle);
  radii.form = rho < 0.0 ? kNoNumber : std::hypot(r_b, rho);
  return radii;
}

}  // namespace

MemberClearances clearances_of(const ContactSetup& setup, const Deviation& deviation) {
  MemberClearances c{{kNoNumber, kNoNumber}, {kNoNumber, kNoNumber}};
  const Gear& g1 = setup.gear(1);
  const Gear& g2 = setup.gear(2);
  if (!g1.involute() || setup.place().axis_angle != Angle()) return c;
  const double a = setup.place().center_distance + deviation.errors.center_distance;
  const double sum = g2.base_radius() + g2.side() * g1.base_radius();
  if (!(a > std::abs(sum))) return c;
  const std::array<Radii, 2> radii{radii_of(g1, deviation.thickness[0]),
                                   radii_of(g2, deviation.thickness[1])};
  c.tip = tip_clearances({g1.actual_tip_radius(), g2.actual_tip_radius()},
                         {radii[0].root, radii[1].root}, a, g2.side());
  const MeshInput<double> input = mesh_input(g1, g2, {.center_distance = a});
  const auto contact_root = contact_root_radii(input, mesh_of(input));
  for (std::size_t i = 0; i < 2; ++i)
    if (contact_root[i])
      c.form[i] = setup.gear(static_cast<int>(i) + 1).side() * (*contact_root[i] - radii[i].form);
  return c;
}

}  // namespace gearwright
