#include "gearwright/gear/basic.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "gearwright/base/error.hpp"
#include "gearwright/gear/reference.hpp"

namespace gearwright {

Result<StraightRack> rack_leaving_root(const CylindricalSpec& spec, double root_diameter,
                                       std::optional<double> root_form_diameter) {
  const auto g = reference_geometry<double>(
      {spec.teeth, spec.normal_module, spec.normal_pressure_angle.rad(), spec.helix_angle.rad(),
       spec.profile_shift, spec.thickness_allowance});
  const double m = spec.normal_module;
  const double x_E = g.generating_profile_shift;
  const bool ring = spec.teeth < 0;
  const double side = side_of(spec.teeth);
  const double d = g.reference_diameter;
  StraightRack rack = spec.straight_rack();
  rack.dedendum = x_E + side * (d - root_diameter) / (2 * m);
  if (!(rack.dedendum > 0.0)) {
    return refused("root_diameter", root_diameter, {d + side * 2 * m * x_E},
                   fmt::format("at this root diameter the rack has no teeth; the root diameter "
                               "must be {} than {{}} mm",
                               ring ? "greater" : "less"));
  }
  if (!root_form_diameter) return rack;
  const double d_Ff = *root_form_diameter;
  if (ring) {
    return refused("root_form_diameter", d_Ff,
                   "is not supported for an internal gear in this version, because its root fillet "
                   "depends on the pinion cutter");
  }
  const double sin_n = std::sin(spec.normal_pressure_angle.rad());
  const double sin_t = std::sin(g.transverse_pressure_angle);
  const double r_b = g.base_diameter / 2;
  const double rho_C = r_b * std::tan(g.transverse_pressure_angle);
  // The diameter of the point that the rack cuts with its flank at the depth h* below the datum
  // line.
  const auto form_at = [&](double h) { return 2 * std::hypot(r_b, rho_C - (h - x_E) * m / sin_t); };
  rack.root_fillet_radius = 0.0;
  const double full = full_radius(rack, spec.normal_pressure_angle);
  const double sharp_depth = rack.dedendum;
  const double round_depth = rack.dedendum - full * (1 - sin_n);
  const double least = std::max(g.base_diameter, form_at(sharp_depth));
  const double most = form_at(round_depth);
  const bool undercut = rho_C - (sharp_depth - x_E) * m / sin_t < 0.0;
  if (!(d_Ff > g.base_diameter && d_Ff <= most && (undercut || d_Ff >= least))) {
    return refused(
        "root_form_diameter", d_Ff, {undercut ? g.base_diameter : least, most},
        "no tip rounding of the rack gives both this diameter and the root diameter; the root form "
        "diameter must lie between {} mm (sharp corner) and {} mm (full radius)");
  }
  const double rho_F = std::sqrt((d_Ff / 2 - r_b) * (d_Ff / 2 + r_b));
  const double depth = x_E - (rho_F - rho_C) * sin_t / m;
  rack.root_fillet_radius = std::clamp((rack.dedendum - depth) / (1 - sin_n), 0.0, full);
  return rack;
}

}  // namespace gearwright
