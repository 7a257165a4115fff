#include "gearwright/pair/pair.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gearwright {

namespace {

Error bad(std::string key, double value, const std::string& why) {
  std::string message = fmt::format("{} = {}: {}", key, value, why);
  return {std::move(key), fmt::format("{}", value), std::move(message)};
}

// Base pitches and helices agree when they do so to 1e-9: input given in degrees and in rounded
// millimetres must pass, another helix must not.
constexpr double kSamePitch = 1e-9;

std::optional<Error> check_partners(const Gear& g1, const Gear& g2) {
  const int z1 = g1.spec.teeth;
  const int z2 = g2.spec.teeth;
  if (z1 < 0) {
    return bad("gear1.teeth", z1, "the ring of an internal pair is gear2; exchange the two tables");
  }
  if (z2 < 0 && -z2 <= z1) {
    return bad("gear2.teeth", z2,
               fmt::format("a ring must have more teeth than its pinion (gear1.teeth = {})", z1));
  }
  const double p1 = g1.reference.base_pitch_normal;
  const double p2 = g2.reference.base_pitch_normal;
  if (std::abs(p1 - p2) > kSamePitch * p1) {
    return bad(
        "gear2.normal_module_mm", g2.spec.normal_module,
        fmt::format("the normal base pitches differ: gear1 has {} mm, gear2 {} mm; gears mesh only "
                    "with equal m_n cos α_n",
                    p1, p2));
  }
  const double b1 = g1.reference.base_helix_angle;
  const double b2 = g2.reference.base_helix_angle;
  const double sum = z2 > 0 ? b1 + b2 : b1 - b2;
  if (std::abs(sum) > kSamePitch) {
    const double wanted = z2 > 0 ? -g1.spec.helix_angle.deg() : g1.spec.helix_angle.deg();
    return bad(
        "gear2.helix_angle_deg", g2.spec.helix_angle.deg(),
        fmt::format("the axes would cross (shaft angle {:.6g}°), and this version mounts gears on "
                    "parallel axes only; these need {}° ({} hand)",
                    Angle::radians(sum).deg(), wanted, z2 > 0 ? "the opposite" : "the same"));
  }
  return std::nullopt;
}

double diameter_of(double base_radius, double rho) { return 2 * std::hypot(base_radius, rho); }

// Past the flank that an undercut took nothing strikes: contact is lost. Elsewhere it is
// interference.
void past_the_flank(Pair& p, const char* code, int gear, double amount, const std::string& where) {
  const int mate = 3 - gear;
  if (p.gears[gear - 1].undercut) {
    p.warnings.push_back(
        {"contact_lost",
         fmt::format(
             "The tip of gear {} reaches {:.4f} mm {} of gear {}: contact is lost there, the "
             "undercut has taken the flank.",
             mate, -amount, where, gear),
         gear});
    return;
  }
  p.interference.push_back(
      {code, gear, amount,
       fmt::format(
           "The tip of gear {} reaches {:.4f} mm {} of gear {}, where there is no involute: "
           "shorten the tip or shift gear {} outward.",
           mate, -amount, where, gear, gear)});
}

// Where the mate's tip touches each gear deepest, and how far that is from the usable flank's
// start.
void find_form_clearance(Pair& p) {
  const double N = p.mesh.base_tangent_distance;
  const std::array<double, 2> rho{
      p.mesh.rho1_A, p.kind == PairKind::parallel_external ? N - p.mesh.rho1_E : p.mesh.rho1_E + N};
  for (int i : {0, 1}) {
    if (rho[i] < 0.0) {
      past_the_flank(p, "base_tangent", i + 1, rho[i], "past the base tangent point");
      continue;
    }
    p.contact_root_diameter[i] = diameter_of(p.gears[i].base_radius(), rho[i]);
    const auto form = p.gears[i].root_form_radius();
    if (!form) continue;
    p.form_clearance[i] = *p.contact_root_diameter[i] / 2 - *form;
    if (*p.form_clearance[i] < 0.0) {
      past_the_flank(
          p, "form_circle", i + 1, *p.form_clearance[i],
          fmt::format("below the start of the usable flank (d_Ff = {:.4f} mm)", 2 * *form));
    }
  }
}

void find_tip_clearance(Pair& p) {
  const double a = p.center_distance;
  const Gear& g1 = p.gears[0];
  const Gear& g2 = p.gears[1];
  if (p.kind == PairKind::parallel_external) {
    p.tip_clearance = {a - g1.actual_tip_radius() - g2.root_diameter / 2,
                       a - g2.actual_tip_radius() - g1.root_diameter / 2};
  } else {
    p.tip_clearance = {g2.root_diameter / 2 - a - g1.actual_tip_radius(),
                       g2.tip_diameter / 2 - a - g1.root_diameter / 2};
  }
  for (int i : {0, 1}) {
    if (p.tip_clearance[i] < 0.0) {
      p.interference.push_back(
          {"root", 2 - i, p.tip_clearance[i],
           fmt::format("The tip of gear {} cuts {:.4f} mm into the root of gear {}.", i + 1,
                       -p.tip_clearance[i], 2 - i)});
    }
  }
}

// Internal pairs: involute, trochoid and trimming interference. [T2.27, T2.28]
void find_internal_margins(Pair& p) {
  const Gear& g1 = p.gears[0];
  const Gear& g2 = p.gears[1];
  const double a = p.center_distance;
  const double r_a1 = g1.actual_tip_radius();
  const double r_a2 = g2.tip_diameter / 2;
  const double z1 = g1.spec.teeth;
  const double z2 = std::abs(g2.spec.teeth);
  const double inv_w = involute(p.mesh.working_transverse_pressure_angle);
  const auto roll = [](double r, double r_b) {
    return std::sqrt(std::max(0.0, (r - r_b) * (r + r_b))) / r_b;
  };
  const double inv_a1 = involute_of_roll(roll(r_a1, g1.base_radius()));
  const double inv_a2 = involute_of_roll(roll(r_a2, g2.base_radius()));
  if (const auto form = g1.root_form_radius()) {
    p.involute_margin = p.mesh.rho1_A - roll(*form, g1.base_radius()) * g1.base_radius();
  }
  const auto clamp = [](double v) { return std::clamp(v, -1.0, 1.0); };
  // Where the tip circles do not meet no tip passes another.
  if (r_a2 < a + r_a1) {
    const double theta_1 =
        std::acos(clamp((r_a2 * r_a2 - r_a1 * r_a1 - a * a) / (2 * a * r_a1))) + inv_a1 - inv_w;
    const double theta_2 = std::acos(clamp((a * a + r_a2 * r_a2 - r_a1 * r_a1) / (2 * a * r_a2)));
    p.trochoid_margin = theta_1 * z1 / z2 + inv_w - inv_a2 - theta_2;
  }

  const double cos_a1 = g1.base_radius() / r_a1;
  const double cos_a2 = std::min(1.0, g2.base_radius() / r_a2);
  const double ratio = cos_a1 / cos_a2;
  if (ratio < 1.0) {
    const double phi_1 =
        std::asin(std::sqrt(clamp((1 - ratio * ratio) / (1 - (z1 / z2) * (z1 / z2)))));
    const double phi_2 =
        std::asin(std::sqrt(clamp((1 / (ratio * ratio) - 1) / ((z2 / z1) * (z2 / z1) - 1))));
    p.trimming_margin = phi_1 + inv_a1 - inv_w - z2 / z1 * (phi_2 + inv_a2 - inv_w);
  }
  if (p.trochoid_margin && *p.trochoid_margin < 0.0) {
    p.interference.push_back(
        {"trochoid", 2, *p.trochoid_margin,
         "Trochoid interference: the pinion's tip strikes the ring's tip on its way out; "
         "shorten a tip or choose tooth numbers further apart."});
  }
  if (p.trimming_margin && *p.trimming_margin < 0.0) {
    p.interference.push_back(
        {"trimming", 2, *p.trimming_margin,
         "Trimming interference: the pinion cannot be put into the ring radially with a "
         "space on the centre line; slide it in along the axis."});
  }
}

void warn_about_mesh(Pair& p) {
  const auto warn = [&](const std::string& code, std::string message, int gear = 0) {
    p.warnings.push_back({code, std::move(message), gear});
  };
  // Rounding of a backlash-free distance is not a backlash: 1e-12 of the base pitch.
  const double noise = 1e-12 * p.gears[0].reference.base_pitch_normal;
  if (p.mesh.backlash_normal_base < -noise) {
    const std::string distance = p.backlash_free_center_distance
                                     ? fmt::format("{:.4f} mm", *p.backlash_free_center_distance)
                                     : "none";
    warn("negative_backlash",
         fmt::format(
             "Negative backlash: the teeth are too thick by {:.4f} mm (normal) at this centre "
             "distance; the backlash-free one is {}.",
             -p.mesh.backlash_normal, distance));
  }
  if (p.contact_ratio_true() == 0.0) {
    warn("no_contact",
         p.flanks_meet()
             ? "No contact: what the tips reach of the line of action lies outside the usable "
               "flanks."
             : "No contact: at this centre distance the teeth do not reach each other's flanks.");
  } else if (p.contact_ratio_true() < 1.0) {
    warn("contact_ratio",
         fmt::format("Total contact ratio {:.3f}: below 1, motion is not passed on continuously.",
                     p.contact_ratio_true()));
  } else if (p.mesh.transverse_contact_ratio_true < 1.0) {
    warn("transverse_contact_ratio",
         fmt::format(
             "Transverse contact ratio {:.3f}: these run only as helical gears; a face width of at "
             "least {:.2f} mm is needed.",
             p.mesh.transverse_contact_ratio_true,
             (1 - p.mesh.transverse_contact_ratio_true) * p.input.face_width /
                 p.mesh.overlap_ratio));
  }
  for (const Interference& i : p.interference) warn(i.code, i.message, i.gear);
}

}  // namespace

ParallelMeshInput<double> mesh_input(const Gear& g1, const Gear& g2, double a) {
  ParallelMeshInput<double> in;
  in.z1 = g1.spec.teeth;
  in.z2 = g2.spec.teeth;
  in.base_radius_1 = g1.base_radius();
  in.base_radius_2 = g2.base_radius();
  in.base_thickness_1 = g1.reference.base_tooth_thickness;
  in.base_thickness_2 = g2.reference.base_tooth_thickness;
  in.base_helix_angle = std::abs(g1.reference.base_helix_angle);
  in.tip_form_radius_1 = g1.tip_form_radius();
  in.tip_form_radius_2 = g2.tip_form_radius();
  in.root_form_radius_1 = g1.root_form_radius();
  in.root_form_radius_2 = g2.root_form_radius();
  in.face_width = std::min(g1.spec.face_width, g2.spec.face_width);
  in.center_distance = a;
  return in;
}

double Pair::gear_ratio() const { return static_cast<double>(input.z2) / input.z1; }

bool Pair::flanks_meet() const {
  const auto has_flank = [](const Gear& g) { return !g.tooth || g.tooth->form_radius.has_value(); };
  return mesh.path_length > 0.0 && has_flank(gears[0]) && has_flank(gears[1]);
}

double Pair::path_length() const { return flanks_meet() ? mesh.path_length : 0.0; }

double Pair::transverse_contact_ratio() const {
  return flanks_meet() ? mesh.transverse_contact_ratio : 0.0;
}

double Pair::contact_ratio() const {
  return flanks_meet() ? mesh.transverse_contact_ratio + mesh.overlap_ratio : 0.0;
}

double Pair::contact_ratio_true() const {
  const bool any = flanks_meet() && mesh.transverse_contact_ratio_true > 0.0;
  return any ? mesh.transverse_contact_ratio_true + mesh.overlap_ratio : 0.0;
}

Point<Housing> Pair::on_line_of_action(double rho1) const {
  // Pitch point at +r_w1 (external) or −r_w1 (internal); gear 1 turns clockwise, so the leading
  // flanks' normal there is (sin α, −cos α), turned half a turn for internal pairs. [T1.6]
  const double side = kind == PairKind::parallel_external ? 1.0 : -1.0;
  const double alpha = mesh.working_transverse_pressure_angle;
  const double u = rho1 - mesh.rho1_C;
  return {side *
          Vec3(mesh.working_pitch_radius_1 + u * std::sin(alpha), -u * std::cos(alpha), 0.0)};
}

Point<Housing> Pair::on_trailing_line(double rho1) const {
  Point<Housing> p = on_line_of_action(rho1);
  p.r.y() = 0.0 - p.r.y();
  p.r.z() = 0.0 - p.r.z();
  return p;
}

Pose<Housing, Gear1> Pair::pose_1() const {
  // Tooth 0 points to the mesh: +x for external pairs, −x for internal ones.
  Eigen::Isometry3d x = Eigen::Isometry3d::Identity();
  if (kind == PairKind::parallel_internal) x.linear().diagonal() << -1.0, -1.0, 1.0;
  return Pose<Housing, Gear1>(x);
}

Pose<Housing, Gear2> Pair::pose_2() const {
  // Space 0, half a pitch from tooth 0, points to the mesh at −x.
  const int z2 = std::abs(input.z2);
  const SinCos t = sincos_turn(z2 - 1, 2LL * z2);
  Eigen::Isometry3d x = Eigen::Isometry3d::Identity();
  x.linear() << t.cos, -t.sin, 0.0, t.sin, t.cos, 0.0, 0.0, 0.0, 1.0;
  x.translation() = Vec3(center_distance, 0.0, 0.0);
  return Pose<Housing, Gear2>(x);
}

Result<Pair> mount_parallel(Gear gear_1, Gear gear_2, const PairSpec& spec) {
  if (auto error = check_partners(gear_1, gear_2)) return *error;
  for (const Gear* g : {&gear_1, &gear_2}) {
    if (g->exists()) continue;
    const std::string key = g == &gear_1 ? "gear1.profile_shift" : "gear2.profile_shift";
    return Error{
        key, fmt::format("{}", g->spec.profile_shift),
        fmt::format("{} = {}: {}", key, g->spec.profile_shift, g->warnings.back().message)};
  }
  Pair p{};
  p.kind = gear_2.internal() ? PairKind::parallel_internal : PairKind::parallel_external;
  p.center_distance = spec.center_distance;
  p.input = mesh_input(gear_1, gear_2, spec.center_distance);
  const double least = base_radius_sum(p.input);
  if (!(p.center_distance > least && p.center_distance <= kGreatestDistance * least)) {
    return bad(
        "pair.center_distance_mm", p.center_distance,
        fmt::format(
            "there is no working pressure angle; it must be greater than {} mm and at most {} "
            "times that",
            least, kGreatestDistance));
  }
  p.gears = {std::move(gear_1), std::move(gear_2)};
  const Gear& g1 = p.gears[0];
  const Gear& g2 = p.gears[1];
  p.mesh = parallel_mesh(p.input);

  const double sign = p.kind == PairKind::parallel_external ? 1.0 : -1.0;
  p.reference_center_distance =
      (g2.reference.reference_diameter + sign * g1.reference.reference_diameter) / 2;
  const double inv_0 = backlash_free_involute(p.input);
  if (inv_0 >= 0.0) p.backlash_free_center_distance = least / std::cos(inverse_involute(inv_0));
  const double x_m_1 = g1.spec.profile_shift * g1.spec.normal_module;
  const double x_m_2 = g2.spec.profile_shift * g2.spec.normal_module;
  p.extended_center_distance = p.reference_center_distance + sign * (x_m_1 + x_m_2);
  p.tip_shortening = sign * (p.center_distance - p.extended_center_distance);

  p.sliding_A = specific_sliding(p.input, p.mesh, p.mesh.rho1_A);
  p.sliding_E = specific_sliding(p.input, p.mesh, p.mesh.rho1_E);
  find_form_clearance(p);
  find_tip_clearance(p);
  if (p.kind == PairKind::parallel_internal) find_internal_margins(p);
  for (int i : {0, 1}) {
    p.fillet_clearance[i] = fillet_clearance(p, i + 1);
    if (p.fillet_clearance[i] && *p.fillet_clearance[i] < 0.0) {
      p.interference.push_back(
          {"tip_to_fillet", i + 1, *p.fillet_clearance[i],
           fmt::format("The tip corner of gear {} cuts {:.4f} mm into the root fillet of gear {}.",
                       2 - i, -*p.fillet_clearance[i], i + 1)});
    }
  }
  warn_about_mesh(p);
  return p;
}

}  // namespace gearwright
