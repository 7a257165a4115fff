#include "gearwright/scatter/member_clearances.hpp"

#include <cmath>

#include "gearwright/math/involute.hpp"
#include "gearwright/pair/clearances.hpp"
#include "gearwright/pair/involute_pair.hpp"

namespace gearwright {

namespace {

// The radii of a gear after a change of its tooth thickness, mm; none if there is no closed form.
struct Radii {
  std::optional<double> root, form;
};

// True if the blank determines the tip, so that the tip does not move with the rack.
bool has_plain_tip(const Gear& gear) {
  return gear.actual_tip_radius() == gear.tip_diameter / 2 &&
         gear.tip_form_radius() == gear.tip_diameter / 2;
}

Radii radii_of(const Gear& gear, double thickness) {
  const double root = gear.root_diameter / 2;
  const auto form = gear.root_form_radius();
  if (thickness == 0.0) return {root, form};
  const bool by_rack = gear.tooth && !gear.cut_by && !gear.spec.root_fillet;
  if (!by_rack || !has_plain_tip(gear)) return {};
  const double shift = thickness / (2 * std::tan(gear.spec.normal_pressure_angle.rad()));
  Radii radii{root + shift, {}};
  const ReferenceGeometry<double>& reference = gear.reference();
  const auto least = gear.undercut_free_shift();
  const double x_E = reference.generating_profile_shift + shift / gear.spec.normal_module;
  if (!form || gear.undercut || (least && x_E < *least)) return radii;
  const double r_b = gear.base_radius();
  const double rho =
      roll_length(*form, r_b) + shift / std::sin(reference.transverse_pressure_angle);
  if (!(rho < 0.0)) radii.form = std::hypot(r_b, rho);
  return radii;
}

}  // namespace

MemberClearances clearances_of(const ContactSetup& setup, const Deviation& deviation) {
  MemberClearances c;
  const Gear& g1 = setup.gear(1);
  const Gear& g2 = setup.gear(2);
  if (!g1.involute() || setup.place().axis_angle != Angle()) return c;
  const double a = setup.place().center_distance + deviation.errors.center_distance;
  const double sum = g2.base_radius() + g2.side() * g1.base_radius();
  if (!(a > std::abs(sum))) return c;
  const std::array<Radii, 2> radii{radii_of(g1, deviation.thickness[0]),
                                   radii_of(g2, deviation.thickness[1])};
  const auto tip =
      tip_clearances({g1.actual_tip_radius(), g2.actual_tip_radius()},
                     {radii[0].root.value_or(0.0), radii[1].root.value_or(0.0)}, a, g2.side());
  const MeshInput<double> input = mesh_input(g1, g2, {.center_distance = a});
  const auto contact_root = contact_root_radii(input, mesh_of(input));
  for (std::size_t i = 0; i < 2; ++i) {
    if (radii[1 - i].root) c.tip[i] = tip[i];
    if (contact_root[i] && radii[i].form)
      c.form[i] = setup.gear(static_cast<int>(i) + 1).side() * (*contact_root[i] - *radii[i].form);
  }
  return c;
}

}  // namespace gearwright
