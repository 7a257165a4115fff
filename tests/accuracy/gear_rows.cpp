#include <fmt/format.h>

#include <array>
#include <cmath>

#include "gearwright/base/testing/draw.hpp"
#include "gearwright/base/testing/numbers.hpp"
#include "gearwright/gear/reference.hpp"
#include "gearwright/pair/closed_forms.hpp"
#include "gearwright/pair/mesh.hpp"
#include "gearwright/pair/shift.hpp"
#include "tests/accuracy/ledger.hpp"

namespace gearwright::ledger {

namespace {

using testing::Draw;
using testing::kDegree;

ReferenceInput<double> drawn_gear(Draw& draw, int teeth) {
  ReferenceInput<double> in;
  in.teeth = teeth;
  in.normal_module = draw.uniform(0.1, 50.0);
  in.normal_pressure_angle = draw.uniform(14.5, 30.0) * kDegree;
  in.helix_angle = draw.whole(0, 3) == 0 ? 0.0 : draw.uniform(-60.0, 60.0) * kDegree;
  in.profile_shift = draw.uniform(-0.5, 1.0);
  in.thickness_allowance = draw.uniform(-0.1, 0.0) * in.normal_module;
  return in;
}

ReferenceInput<Exact> exact(const ReferenceInput<double>& in) {
  return {in.teeth,       in.normal_module, in.normal_pressure_angle,
          in.helix_angle, in.profile_shift, in.thickness_allowance};
}

std::string words(const ReferenceInput<double>& in) {
  return fmt::format("z {}, m_n {:.6g}, α_n {:.4f}°, β {:.4f}°, x {:.4f}", in.teeth,
                     in.normal_module, in.normal_pressure_angle / kDegree, in.helix_angle / kDegree,
                     in.profile_shift);
}

}  // namespace

std::vector<Row> gear_rows() {
  constexpr int kInputs = 4000;
  const std::string where =
      fmt::format("z ±1…±300, β ±60°, α_n 14.5…30°, x -0.5…1, {} inputs", kInputs);
  Row alpha_t{"reference.transverse_pressure_angle", where, "relative", 1e-15, 0.0, ""};
  Row beta_b{"reference.base_helix_angle", where, "relative", 1e-15, 0.0, ""};
  Row d{"reference.reference_diameter", where, "relative", 1e-15, 0.0, ""};
  Row d_b{"reference.base_diameter", where, "relative", 2e-15, 0.0, ""};
  Row s_n{"reference.tooth_thickness_normal", where, "modules", 2e-15, 0.0, ""};
  Row s_bt{"reference.base_tooth_thickness", where, "modules", 1e-13, 0.0, ""};
  Row s_y{
      "tooth_thickness_transverse", "d_y = d_b…d_b + 6 m_n; " + where, "modules", 2e-13, 0.0, ""};
  Draw draw(20250102);
  for (int i = 0; i < kInputs; ++i) {
    int z = draw.whole(1, 300);
    if (draw.whole(0, 4) == 0) z = -z;
    const auto in = drawn_gear(draw, z);
    const auto g = reference_geometry(in);
    const auto e = reference_geometry(exact(in));
    const std::string w = words(in);
    const double m = in.normal_module;
    alpha_t.see(relative_error(g.transverse_pressure_angle, e.transverse_pressure_angle), w);
    beta_b.see(relative_error(g.base_helix_angle, e.base_helix_angle), w);
    d.see(relative_error(g.reference_diameter, e.reference_diameter), w);
    d_b.see(relative_error(g.base_diameter, e.base_diameter), w);
    s_n.see(
        error_in_modules(g.reference_tooth_thickness_normal, e.reference_tooth_thickness_normal, m),
        w);
    s_bt.see(error_in_modules(g.base_tooth_thickness, e.base_tooth_thickness, m), w);
    const double d_y = g.base_diameter * (1 + 1e-9) + draw.uniform(0.0, 6.0) * m;
    s_y.see(
        error_in_modules(
            tooth_thickness_transverse(z, g.base_diameter, g.base_tooth_thickness, d_y),
            tooth_thickness_transverse(z, e.base_diameter, e.base_tooth_thickness, Exact(d_y)), m),
        w);
  }
  return {alpha_t, beta_b, d, d_b, s_n, s_bt, s_y};
}

namespace {

template <class T>
MeshInput<T> mesh_input(const ReferenceGeometry<T>& g1, const ReferenceGeometry<T>& g2, int z1,
                        int z2, double tip_1, double tip_2, double form_1, double form_2,
                        double face, double a) {
  MeshInput<T> in;
  in.gears = {base_gear(z1, g1), base_gear(z2, g2)};
  in.tip_form_radius = {T(tip_1), T(tip_2)};
  in.root_form_radius = {T(form_1), T(form_2)};
  in.face_width = {T(face), T(face)};
  in.center_distance = T(a);
  return in;
}

double backlash_in_lanes(const ReferenceInput<double>& in1, const ReferenceInput<double>& in2,
                         double a) {
  const std::array<double, BacklashColumns::kIn> row{static_cast<double>(in1.teeth),
                                                     static_cast<double>(in2.teeth),
                                                     in1.profile_shift,
                                                     in2.profile_shift,
                                                     std::sin(in1.helix_angle),
                                                     in1.thickness_allowance,
                                                     in2.thickness_allowance,
                                                     a};
  BacklashColumns columns;
  for (std::size_t k = 0; k < row.size(); ++k) columns.in[k] = &row[k];
  double j = 0.0;
  normal_backlashes({in1.normal_module, std::tan(in1.normal_pressure_angle)}, columns, &j, 1);
  return j;
}

}  // namespace

std::vector<Row> mesh_rows() {
  constexpr int kInputs = 4000;
  const std::string where = fmt::format(
      "external 8…150 : z1…300 and rings, Σx 0…1.2, a to 0.3 m_n over tight, {} pairs", kInputs);
  Row tight{"tight_center_distance", where, "relative", 2e-15, 0.0, ""};
  Row sum{"tight_shift_sum", where, "modules", 5e-13, 0.0, ""};
  Row alpha{"mesh.working_transverse_pressure_angle", where, "relative", 1e-13, 0.0, ""};
  Row alpha_n{"mesh.working_normal_pressure_angle", where, "relative", 1e-13, 0.0, ""};
  Row r_w{"mesh.working_pitch_radius",
          where + " (r_b2 − r_b1 of near rings cancels: 2ε (z2 + z1)/(z2 − z1))",
          "relative",
          2e-14,
          0.0,
          ""};
  Row rho_a{"mesh.rho1_A", where, "modules", 1e-12, 0.0, ""};
  Row rho_e{"mesh.rho1_E", where, "modules", 1e-12, 0.0, ""};
  Row eps{"mesh.transverse_contact_ratio", where, "relative", 1e-12, 0.0, ""};
  Row eps_true{"mesh.transverse_contact_ratio_true", where, "relative", 1e-12, 0.0, ""};
  Row eps_b{"mesh.overlap_ratio", where, "relative", 1e-14, 0.0, ""};
  Row beta_w{"mesh.working_helix_angle", where, "relative", 1e-14, 0.0, ""};
  Row r_w2{"mesh.working_pitch_radius_2", where + " (as r_w1)", "relative", 2e-14, 0.0, ""};
  Row rho_c{"mesh.rho1_B, C, D", where, "modules", 1e-12, 0.0, ""};
  Row length{"mesh.path_length", where, "modules", 1e-12, 0.0, ""};
  Row j_n{"mesh.backlash_normal, circumferential", where, "modules", 1e-12, 0.0, ""};
  Row j{"mesh.backlash_normal_base", where, "modules", 1e-12, 0.0, ""};
  Row j_rot{
      "mesh.backlash_rotation", where + ", as an arc at the tip circle", "modules", 1e-12, 0.0, ""};
  Row j_lanes{"normal_backlashes", "vector code; " + where, "modules", 1e-12, 0.0, ""};
  Row zeta{"specific_sliding", "at E; " + where, "relative", 1e-12, 0.0, ""};
  Draw draw(20250102);
  for (int i = 0; i < kInputs; ++i) {
    const bool ring = draw.whole(0, 4) == 0;
    const int z1 = draw.whole(8, 150);
    const int z2 = ring ? -(z1 + draw.whole(8, 150)) : z1 + draw.whole(0, 150);
    ReferenceInput<double> in1 = drawn_gear(draw, z1);
    ReferenceInput<double> in2 = in1;
    in2.teeth = z2;
    in2.helix_angle = ring ? in1.helix_angle : -in1.helix_angle;
    in1.profile_shift = draw.uniform(0.0, 0.6);
    in2.profile_shift = (ring ? -1.0 : 1.0) * draw.uniform(0.0, 0.6);
    const auto g1 = reference_geometry(in1);
    const auto g2 = reference_geometry(in2);
    const auto e1 = reference_geometry(exact(in1));
    const auto e2 = reference_geometry(exact(in2));
    const double m = in1.normal_module;
    const double sum_x = in1.profile_shift + in2.profile_shift;
    const double cos_beta = std::cos(in1.helix_angle);
    const Exact cos_beta_e = cos(Exact(in1.helix_angle));
    const Exact sum_x_e = Exact(in1.profile_shift) + Exact(in2.profile_shift);
    const double a_tight = tight_center_distance(z1, z2, m, in1.normal_pressure_angle,
                                                 g1.transverse_pressure_angle, cos_beta, sum_x);
    const std::string w = words(in1) + fmt::format("; z2 {}, x2 {:.4f}", z2, in2.profile_shift);
    tight.see(relative_error(a_tight, tight_center_distance(
                                          z1, z2, Exact(m), Exact(in1.normal_pressure_angle),
                                          e1.transverse_pressure_angle, cos_beta_e, sum_x_e)),
              w);
    const double a =
        a_tight + (ring ? -1.0 : 1.0) * (draw.whole(0, 2) == 0 ? 0.0 : draw.uniform(0.0, 0.3) * m);
    if (!(a > std::abs(g2.base_diameter - (ring ? 1 : -1) * g1.base_diameter) / 2 * (1 + 1e-3)))
      continue;
    sum.see(error_in_modules(tight_shift_sum(z1, z2, m, in1.normal_pressure_angle,
                                             g1.transverse_pressure_angle, cos_beta, a),
                             tight_shift_sum(z1, z2, Exact(m), Exact(in1.normal_pressure_angle),
                                             e1.transverse_pressure_angle, cos_beta_e, Exact(a)),
                             1.0),
            w);
    const double tip_1 = g1.reference_diameter / 2 + m * (1 + in1.profile_shift);
    const double tip_2 = g2.reference_diameter / 2 +
                         (ring ? -m * (1 + in2.profile_shift) : m * (1 + in2.profile_shift));
    if (ring && tip_2 < g2.base_diameter / 2 * 1.001) continue;
    const double form_1 = g1.base_diameter / 2 * (1 + draw.uniform(1e-4, 0.01));
    // The flank of an external gear starts above the base circle, and the flank of an internal gear
    // ends beyond the tip.
    const double form_2 =
        ring ? tip_2 + 2 * m : g2.base_diameter / 2 * (1 + draw.uniform(1e-4, 0.02));
    const double face = draw.uniform(5.0, 20.0) * m;
    const auto in = mesh_input<double>(g1, g2, z1, z2, tip_1, tip_2, form_1, form_2, face, a);
    const auto in_e = mesh_input<Exact>(e1, e2, z1, z2, tip_1, tip_2, form_1, form_2, face, a);
    const auto p = mesh_of(in);
    const auto e = mesh_of(in_e);
    alpha.see(relative_error(p.rack.sides[0].transverse_angle, e.rack.sides[0].transverse_angle),
              w);
    alpha_n.see(relative_error(p.rack.normal_pressure_angle, e.rack.normal_pressure_angle), w);
    r_w.see(relative_error(p.rack.sides[0].pitch_radius, e.rack.sides[0].pitch_radius), w);
    rho_a.see(error_in_modules(p.rho1_A, e.rho1_A, m), w);
    rho_e.see(error_in_modules(p.rho1_E, e.rho1_E, m), w);
    eps.see(relative_error(p.path_ratio, e.path_ratio), w);
    eps_true.see(relative_error(p.true_ratio, e.true_ratio), w);
    eps_b.see(relative_error(p.overlap_ratio, e.overlap_ratio), w);
    beta_w.see(relative_error(p.rack.sides[0].helix_angle, e.rack.sides[0].helix_angle), w);
    r_w2.see(relative_error(p.rack.sides[1].pitch_radius, e.rack.sides[1].pitch_radius), w);
    rho_c.see(error_in_modules(p.rho1_B, e.rho1_B, m), w);
    rho_c.see(error_in_modules(p.rho1_C, e.rho1_C, m), w);
    rho_c.see(error_in_modules(p.rho1_D, e.rho1_D, m), w);
    length.see(error_in_modules(p.path_length, e.path_length, m), w);
    j_n.see(error_in_modules(p.backlash.normal, e.backlash.normal, m), w);
    j_n.see(error_in_modules(p.backlash.circumferential[0], e.backlash.circumferential[0], m), w);
    j_lanes.see(error_in_modules(backlash_in_lanes(in1, in2, a), e.backlash.normal, m), w);
    j.see(error_in_modules(p.backlash.normal_base, e.backlash.normal_base, m), w);
    j_rot.see(
        error_in_modules(p.backlash.rotation[0] * tip_1, e.backlash.rotation[0] * Exact(tip_1), m),
        w);
    const auto s = specific_sliding(in, p, p.rho1_E);
    const auto s_e = specific_sliding(in_e, e, e.rho1_E);
    if (s.zeta_1 && s_e.zeta_1) zeta.see(relative_error(1 - *s.zeta_1, 1 - *s_e.zeta_1), w);
  }
  return {tight,  sum, alpha,    alpha_n, beta_w, r_w, r_w2,  rho_a,   rho_c, rho_e,
          length, eps, eps_true, eps_b,   j,      j_n, j_rot, j_lanes, zeta};
}

}  // namespace gearwright::ledger
