#include "gearwright/pair/interference.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "gearwright/base/numbers.hpp"
#include "gearwright/gear/gear.hpp"
#include "gearwright/math/involute.hpp"
#include "gearwright/math/lowest.hpp"
#include "gearwright/pair/clearances.hpp"

namespace gearwright::detail {

namespace {

double noise(const InvolutePair& p) {
  return kNoCollision * p.gears[0].reference().base_pitch_normal;
}

// Reports that a tip reaches beyond the flank of the mating gear. If undercut has removed this part
// of the flank, contact is lost there. Otherwise the tip interferes.
void past_the_flank(InvolutePair& p, WarningCode code, int gear, double amount,
                    const std::string& where) {
  const int mate = 3 - gear;
  if (p.gears[gear - 1].undercut) {
    p.warnings.push_back({WarningCode::contact_lost_to_undercut,
                          fmt::format("The tip of gear {} reaches {:.4f} mm {} of gear {}, where "
                                      "undercut has removed the flank and contact is lost.",
                                      mate, -amount, where, gear),
                          gear});
    return;
  }
  p.interference.push_back(
      {code, gear, amount,
       fmt::format(
           "The tip of gear {} reaches {:.4f} mm {} of gear {}, where there is no involute.", mate,
           -amount, where, gear)});
}

// Returns the reduction of the clearance between a tip and the mating roots, compared with the
// clearance on the centre line. In a crossed internal pair, the clearance is least at an end of the
// region in which both faces overlap. In other pairs, it is least on the centre line. [T4.37]
double nearer_at_ends(const InvolutePair& p, int tip) {
  if (!p.crossed_inside()) return 0.0;
  const bool ring = tip == 2;
  const std::size_t i = tip - 1;
  const double r = p.gears[i].actual_tip_radius();
  const double half = p.gears[i].spec.face_width / 2;
  const double half_mate = p.gears[1 - i].spec.face_width / 2;
  const double apart = ring ? -p.center_distance : p.center_distance;
  const double cosine = std::cos(p.shaft_angle.rad());
  const double sine = std::abs(std::sin(p.shaft_angle.rad()));
  // Returns the distance of the tip cylinder from the mating axis at the angle ψ from the mesh. For
  // the tip of the pinion, which points outwards, the distance is negated, so that the least value
  // always belongs to the point closest to the mating roots. The sign of y does not matter, because
  // the pair is symmetric about the centre line.
  const auto distance = [&](double psi) {
    const double y = r * std::sin(psi);
    const double lo = std::max(-half, (-half_mate + y * sine) / cosine);
    const double hi = std::min(half, (half_mate + y * sine) / cosine);
    if (lo > hi) return kInfinity;  // the faces do not overlap at this angle
    const auto at = [&](double z) {
      return std::hypot(apart + r * std::cos(psi), y * cosine + z * sine);
    };
    return ring ? at(std::clamp(-y * cosine / sine, lo, hi)) : -std::max(at(lo), at(hi));
  };
  const double on_centre_line = ring ? apart + r : -(apart + r);
  return on_centre_line - distance(place_of_least(distance, -kHalfPi, kHalfPi));
}

}  // namespace

// Computes, for each gear, the diameter down to which the mating tip touches the gear, and the
// radial distance of this diameter from the start of the usable flank. [T2.25]
void find_form_clearance(InvolutePair& p) {
  const std::array<double, 2> rho{p.mesh.rho1_A, p.mesh.rho2(p.mesh.rho1_E)};
  const auto contact_root = contact_root_radii(p.input, p.mesh);
  for (int i : {0, 1}) {
    if (!contact_root[i]) {
      past_the_flank(p, WarningCode::base_tangent, i + 1, rho[i], "past the base tangent point");
      continue;
    }
    p.contact_root_diameter[i] = 2 * *contact_root[i];
    const auto form = p.gears[i].root_form_radius();
    if (!form) continue;
    p.form_clearance[i] = p.gears[i].side() * (*p.contact_root_diameter[i] / 2 - *form);
    if (*p.form_clearance[i] < -noise(p)) {
      past_the_flank(
          p, WarningCode::form_circle, i + 1, *p.form_clearance[i],
          fmt::format("below the start of the usable flank (d_Ff = {:.4f} mm)", 2 * *form));
    }
  }
}

void find_tip_clearance(InvolutePair& p) {
  const Gear& g1 = p.gears[0];
  const Gear& g2 = p.gears[1];
  p.tip_clearance =
      tip_clearances({g1.actual_tip_radius(), g2.actual_tip_radius()},
                     {g1.root_diameter / 2, g2.root_diameter / 2}, p.center_distance, p.side());
  for (int i : {0, 1}) {
    p.tip_clearance[i] -= nearer_at_ends(p, i + 1);
    if (std::abs(p.tip_clearance[i]) <= noise(p)) {
      const double m = p.gears[0].spec.normal_module;
      p.warnings.push_back(
          {WarningCode::no_tip_clearance,
           fmt::format(
               "The tip of gear {} has no clearance to the root of gear {}. A clearance of 0.2 m_n "
               "+ 0.05 mm = {:.3f} mm is usual.{}",
               i + 1, 2 - i, 0.2 * m + 0.05,
               p.gears[1 - i].cut_by
                   ? fmt::format(
                         " If this tip has cut gear {}, give a cutter with a longer tip in `{}`.",
                         2 - i, gear_field(2 - i, "cut_by"))
                   : ""),
           i + 1});
    } else if (p.tip_clearance[i] < 0.0) {
      p.interference.push_back(
          {WarningCode::root, 2 - i, p.tip_clearance[i],
           fmt::format("The tip of gear {} cuts {:.4f} mm into the root of gear {}.", i + 1,
                       -p.tip_clearance[i], 2 - i)});
    }
  }
}

void find_internal_margins(ParallelPair& p) {
  InternalMargins& margins = p.margins.emplace();
  const Gear& g1 = p.gears[0];
  const Gear& g2 = p.gears[1];
  const double a = p.center_distance;
  const double r_a1 = g1.actual_tip_radius();
  // The radius at which the flank of the internal gear ends, without a tip rounding.
  const double r_a2 = g2.tooth ? g2.tip_form_radius() : g2.actual_tip_radius();
  const double z1 = g1.spec.teeth;
  const double z2 = std::abs(g2.spec.teeth);
  const double inv_w = involute(p.mesh.rack.sides[0].transverse_angle);
  const auto roll = [](double r, double r_b) { return roll_length(r, r_b) / r_b; };
  const double inv_a1 = involute_of_roll(roll(r_a1, g1.base_radius()));
  const double inv_a2 = involute_of_roll(roll(r_a2, g2.base_radius()));
  if (const auto form = g1.root_form_radius()) {
    margins.involute = p.mesh.rho1_A - roll(*form, g1.base_radius()) * g1.base_radius();
  }
  const auto clamp = [](double v) { return std::clamp(v, -1.0, 1.0); };
  // If the tip circles do not intersect, no tip collides with a mating tip.
  if (r_a2 < a + r_a1) {
    const double theta_1 =
        std::acos(clamp((r_a2 * r_a2 - r_a1 * r_a1 - a * a) / (2 * a * r_a1))) + inv_a1 - inv_w;
    const double theta_2 = std::acos(clamp((a * a + r_a2 * r_a2 - r_a1 * r_a1) / (2 * a * r_a2)));
    margins.trochoid = Angle::radians(theta_1 * z1 / z2 + inv_w - inv_a2 - theta_2);
  }

  const double cos_a1 = g1.base_radius() / r_a1;
  const double cos_a2 = std::min(1.0, g2.base_radius() / r_a2);
  const double ratio = cos_a1 / cos_a2;
  if (ratio < 1.0) {
    const double phi_1 =
        std::asin(std::sqrt(clamp((1 - ratio * ratio) / (1 - (z1 / z2) * (z1 / z2)))));
    const double phi_2 =
        std::asin(std::sqrt(clamp((1 / (ratio * ratio) - 1) / ((z2 / z1) * (z2 / z1) - 1))));
    margins.trimming = Angle::radians(phi_1 + inv_a1 - inv_w - z2 / z1 * (phi_2 + inv_a2 - inv_w));
  }
  if (margins.trochoid && margins.trochoid->rad() < 0.0) {
    p.interference.push_back(
        {WarningCode::trochoid, 2, *margins.trochoid,
         "Trochoid interference: the tip of the pinion collides with the tip of the internal "
         "gear."});
  }
  if (margins.trimming && margins.trimming->rad() < 0.0) {
    // Trimming interference prevents only assembly. It causes no collision of mounted gears.
    p.warnings.push_back({WarningCode::trimming,
                          "Trimming interference: the pinion cannot be mounted radially with a "
                          "tooth space on the centre line. Mount the pinion axially.",
                          2});
  }
}

void find_fillet_clearance(ParallelPair& p) {
  for (int i : {0, 1}) {
    p.fillet_clearance[i] = fillet_clearance(p, i + 1);
    if (p.fillet_clearance[i] && *p.fillet_clearance[i] < -noise(p)) {
      p.interference.push_back(
          {WarningCode::tip_to_fillet, i + 1, *p.fillet_clearance[i],
           fmt::format("The tip corner of gear {} cuts {:.4f} mm into the root fillet of gear {}.",
                       2 - i, -*p.fillet_clearance[i], i + 1)});
    }
  }
}

}  // namespace gearwright::detail
