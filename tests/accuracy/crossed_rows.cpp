#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "gearwright/base/testing/draw.hpp"
#include "gearwright/base/testing/numbers.hpp"
#include "gearwright/pair/mesh.hpp"
#include "tests/accuracy/ledger.hpp"

namespace gearwright::ledger {

namespace {

using testing::Draw;
using testing::kDegree;

BasePair<Exact> exact(const BasePair<double>& g) {
  BasePair<Exact> e;
  for (int i : {0, 1}) {
    e[i] = {g[i].teeth, Exact(g[i].radius), Exact(g[i].tooth_thickness), Exact(g[i].helix_angle)};
  }
  return e;
}

// Two gears with the same normal base pitch whose axes cross. abs(β_b1 + β_b2) lies between the
// limits.
BasePair<double> crossed_gears(Draw& draw, double lo_deg, double hi_deg) {
  BasePair<double> g;
  for (;;) {
    const double b1 = draw.uniform(-68.0, 68.0);
    const double b2 = draw.uniform(-68.0, 68.0);
    if (std::abs(b1 + b2) < lo_deg || std::abs(b1 + b2) > hi_deg) continue;
    const double p_bn = draw.uniform(1.0, 20.0);
    const std::array<double, 2> b{b1 * kDegree, b2 * kDegree};
    for (int i : {0, 1}) {
      g[i].teeth = draw.whole(1, 120);
      g[i].helix_angle = b[i];
      g[i].radius = p_bn * g[i].teeth / (2 * std::numbers::pi * std::cos(b[i]));
      // Tooth thickness: half a pitch at the reference cylinder for a 20° rack, changed by a
      // profile shift.
      const double alpha = 0.35;
      const double u =
          std::sqrt(std::max(0.05, std::pow(std::cos(alpha), 2) - std::pow(std::sin(b[i]), 2)));
      const double half = std::numbers::pi / 2 + draw.uniform(-0.3, 0.6);
      g[i].tooth_thickness =
          2 * g[i].radius * (half / g[i].teeth + involute(std::atan(std::sin(alpha) / u)));
    }
    return g;
  }
}

std::string words(const BasePair<double>& g) {
  return fmt::format("z {}/{}, β_b {:.4f}°/{:.4f}°, r_b {:.6g}/{:.6g}", g[0].teeth, g[1].teeth,
                     g[0].helix_angle / kDegree, g[1].helix_angle / kDegree, g[0].radius,
                     g[1].radius);
}

// The error of a length that is a difference of lengths, relative to the centre distance a.
double of_distance(double got, const Exact& e, double a) {
  return std::abs(static_cast<double>((Exact(got) - e) / Exact(a)));
}

struct CrossedRows {
  Row alpha, helix, a, radius, X, z_L, backlash, contact, face, min_a, min_angle, two;
};

// `more` is the factor by which nearly parallel axes increase the errors. It is due to the division
// by sin Σ.
CrossedRows rows_of(const std::string& prefix, const std::string& where, double more) {
  const auto row = [&](const char* name, const char* unit, double claim) {
    return Row{prefix + name, where, unit, claim, 0.0, ""};
  };
  return {row("normal_pressure_angle", "relative", 1e-14 * more),
          row("helix_angle", "relative", 5e-15),
          row("center_distance", "relative", 1e-14 * more),
          row("pitch_radius", "relative", 5e-14),
          row("plane_distance", "of a", 1e-13 * more),
          row("line_offset", "of a", 1e-13 * more),
          row("backlash", "of a", 1e-12 * more),
          row("rho1_A, rho1_E", "of a", 5e-14 * more),
          row("axial_place", "of a", 1e-13 * more),
          row("least_distance", "relative", 2e-15),
          row("least_distance.shaft_angle", "relative", 1e-14 * more),
          row("angles_at_distance", "relative", 1e-12)};
}

void see_mesh(CrossedRows& rows, const BasePair<double>& g, Draw& draw) {
  const auto e = exact(g);
  const std::string w = words(g);
  const auto range = shaft_angle_range(g);
  const double sigma = range.from + (range.to - range.from) * draw.uniform(0.02, 0.9);
  const auto rack = common_rack(g, angles_at_shaft_angle(g, sigma));
  const auto rack_e = common_rack(e, angles_at_shaft_angle(e, Exact(sigma)));
  rows.alpha.see(relative_error(rack.normal_pressure_angle, rack_e.normal_pressure_angle), w);
  for (int i : {0, 1}) {
    rows.helix.see(relative_error(rack.sides[i].helix_angle, rack_e.sides[i].helix_angle), w);
    rows.radius.see(relative_error(rack.sides[i].pitch_radius, rack_e.sides[i].pitch_radius), w);
  }
  const double a = conjugate_center_distance(g, rack);
  const Exact a_e = conjugate_center_distance(e, rack_e);
  if (!(a > 0.1 * (g[0].radius + g[1].radius))) return;  // the gears cannot mesh here
  rows.a.see(relative_error(a, a_e), w);
  MeshInput<double> in;
  in.gears = g;
  in.center_distance = a + draw.uniform(0.0, 0.3);
  in.shaft_angle = sigma;
  in.tip_form_radius = {rack.sides[0].pitch_radius * 1.1, rack.sides[1].pitch_radius * 1.1};
  in.face_width = {50.0, 50.0};
  MeshInput<Exact> in_e;
  in_e.gears = e;
  in_e.center_distance = Exact(in.center_distance);
  in_e.shaft_angle = Exact(sigma);
  for (int i : {0, 1}) {
    in_e.tip_form_radius[i] = Exact(in.tip_form_radius[i]);
    in_e.face_width[i] = Exact(in.face_width[i]);
  }
  const auto m = mesh_of(in);
  const auto m_e = mesh_of(in_e);
  rows.X.see(of_distance(m.pitch_plane_distance, m_e.pitch_plane_distance, a), w);
  rows.z_L.see(of_distance(m.line_offset, m_e.line_offset, a), w);
  rows.backlash.see(of_distance(m.backlash.normal_base, m_e.backlash.normal_base, a), w);
  rows.contact.see(of_distance(m.rho1_A, m_e.rho1_A, a), w);
  rows.contact.see(of_distance(m.rho1_E, m_e.rho1_E, a), w);
  const auto s = axial_place(m, m.rho1_A);
  const auto s_e = axial_place(m_e, m_e.rho1_A);
  for (int i : {0, 1}) rows.face.see(of_distance(s[i], s_e[i], a), w);
}

void see_min(CrossedRows& rows, const BasePair<double>& g, Draw& draw) {
  const auto e = exact(g);
  const std::string w = words(g);
  const auto alpha = transverse_angle_at_min_distance(g);
  if (!alpha) return;
  const auto alpha_e = *transverse_angle_at_min_distance(e);
  const auto rack = common_rack(g, angles_at_transverse(g, *alpha));
  const auto rack_e = common_rack(e, angles_at_transverse(e, alpha_e));
  const double a = detail::distance_and_line(g, *alpha).a.value;
  rows.min_a.see(relative_error(a, detail::distance_and_line(e, alpha_e).a.value), w);
  rows.min_angle.see(relative_error(rack.shaft_angle, rack_e.shaft_angle), w);
  // The two positions for a centre distance above the minimum. At the minimum itself, their
  // condition number is unbounded.
  const double more = a * (1 + draw.uniform(1e-3, 0.05));
  const auto two = transverse_angles_at_distance(g, more);
  const auto two_e = transverse_angles_at_distance(e, Exact(more));
  for (std::size_t i = 0; i < two.size() && i < two_e.size(); ++i)
    rows.two.see(relative_error(two[i], two_e[i]), w);
}

}  // namespace

std::vector<Row> crossed_rows() {
  constexpr int kInputs = 600;
  Draw draw(20250302);
  std::vector<Row> all;
  struct Part {
    const char* prefix;
    double lo, hi, more;
  };
  for (const Part& part :
       {Part{"crossed.", 5.0, 136.0, 1.0}, Part{"nearly_parallel.", 0.5, 5.0, 10.0}}) {
    CrossedRows rows = rows_of(
        part.prefix,
        fmt::format("z 1…120, β_b ±68°, abs(β_b1 + β_b2) {}…{}°, Σ over 88 % of its range, {} "
                    "pairs",
                    part.lo, part.hi, kInputs),
        part.more);
    for (int i = 0; i < kInputs; ++i) {
      const BasePair<double> g = crossed_gears(draw, part.lo, part.hi);
      see_mesh(rows, g, draw);
      if (i % 5 == 0) see_min(rows, g, draw);
    }
    for (Row* row :
         {&rows.alpha, &rows.helix, &rows.a, &rows.radius, &rows.X, &rows.z_L, &rows.backlash,
          &rows.contact, &rows.face, &rows.min_a, &rows.min_angle, &rows.two})
      all.push_back(std::move(*row));
  }
  Row shift{"as_rack.profile_shift",
            "z ±1…120, β_b ±60°, α_n 14.5…25°, 600 gears",
            "modules",
            1e-12,
            0.0,
            ""};
  Row module{"as_rack.normal_module", shift.where, "relative", 2e-15, 0.0, ""};
  Row helix{"as_rack.helix_angle", shift.where, "relative", 1e-14, 0.0, ""};
  for (int i = 0; i < kInputs; ++i) {
    ReferenceInput<double> in;
    in.teeth = draw.whole(1, 120) * (draw.whole(0, 3) == 0 ? -1 : 1);
    in.normal_module = draw.uniform(0.2, 20.0);
    in.normal_pressure_angle = draw.uniform(14.5, 25.0) * kDegree;
    in.helix_angle = draw.uniform(-60.0, 60.0) * kDegree;
    in.profile_shift = draw.uniform(-0.5, 1.0);
    const BaseGear<double> g = base_gear(in.teeth, reference_geometry(in));
    const BaseGear<Exact> e{g.teeth, Exact(g.radius), Exact(g.tooth_thickness),
                            Exact(g.helix_angle)};
    const double alpha = draw.uniform(14.5, 25.0) * kDegree;
    if (!has_rack(g, alpha * 1.01)) continue;
    const auto r = as_rack(g, alpha);
    const auto r_e = as_rack(e, Exact(alpha));
    const std::string w = fmt::format("z {}, β_b {:.4f}°, to α_n {:.4f}°", g.teeth,
                                      g.helix_angle / kDegree, alpha / kDegree);
    shift.see(error_in_modules(r.profile_shift, r_e.profile_shift, 1.0), w);
    module.see(relative_error(r.normal_module, r_e.normal_module), w);
    helix.see(relative_error(r.helix_angle, r_e.helix_angle), w);
  }
  for (Row* row : {&module, &helix, &shift}) all.push_back(std::move(*row));
  return all;
}

}  // namespace gearwright::ledger
