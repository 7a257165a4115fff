#include "gearwright/gear/basic.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "gearwright/base/error.hpp"
#include "gearwright/base/units.hpp"
#include "gearwright/gear/reference.hpp"

namespace gearwright {

namespace {

// Descriptions of a rack count as equal if they differ by at most one part in a million, because
// users round the input.
constexpr double kSameRack = 1e-6;
// Greatest normal pressure angle of the rack in degrees, the same as for a gear.
constexpr double kMaxRackAngle = 60.0;

}  // namespace

Result<ReferenceInput<double>> as_rack(const Gear& gear, const WantedRack& rack) {
  GW_EXPECTS(rack.normal_module || rack.normal_pressure_angle);
  if (!gear.involute()) {
    return Error{"rack", "",
                 "only involute teeth can be described by a rack of another pressure angle"};
  }
  const BaseGear<double> base = base_gear(gear.spec.teeth, gear.reference());
  const double m_cos = normal_base_pitch(base) / std::numbers::pi;
  double alpha = rack.normal_pressure_angle.value_or(Angle()).rad();
  if (rack.normal_module) {
    const double m = *rack.normal_module;
    if (!(m > m_cos)) {
      return Error{"normal_module", format_number(m, m_cos),
                   fmt::format("no rack of this module describes the gear; the module must be "
                               "greater than m_n cos α_n = {}\u00a0mm",
                               format_number(m_cos, m))};
    }
    const double of_module = std::acos(m_cos / m);
    const double m_max = m_cos / std::cos(kMaxRackAngle * kRadPerDeg);
    if (m > m_max) {
      return Error{
          "normal_module", format_number(m, m_max),
          fmt::format("with this module and the base pitch of the gear, the pressure angle would "
                      "be {}°, but at most {}° is allowed; the module must be at most {}\u00a0mm",
                      format_number(deg(of_module), kMaxRackAngle), kMaxRackAngle,
                      format_number(m_max, m))};
    }
    if (!rack.normal_pressure_angle) {
      alpha = of_module;
    } else if (std::abs(m * std::cos(alpha) - m_cos) > kSameRack * m_cos) {
      return Error{
          "rack", fmt::format("{:.9g},{:.9g}", m, deg(alpha)),
          fmt::format("the base pitch of this rack differs from the base pitch of the gear; for "
                      "the pressure angle {:.9g}° the module must be {:.9g}\u00a0mm, or for the "
                      "module {:.9g}\u00a0mm the pressure angle must be {:.9g}°",
                      deg(alpha), m_cos / std::cos(alpha), m, deg(of_module))};
    }
  }
  if (!has_rack(base, alpha)) {
    const double limit = 90 - std::abs(deg(base.helix_angle));
    return Error{"normal_pressure_angle", format_number(deg(alpha), limit),
                 fmt::format("no rack of this pressure angle describes the gear; the pressure "
                             "angle must be less than {}°, which is 90° minus the base helix angle",
                             format_number(limit, deg(alpha)))};
  }
  return as_rack(base, alpha);
}

Result<StraightRack> rack_leaving_root(const CylindricalSpec& spec, double root_diameter,
                                       std::optional<double> root_form_diameter) {
  const auto g = reference_geometry(spec.reference_input());
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
