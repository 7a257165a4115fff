#include "gearwright/rating/distribution.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "gearwright/base/contract.hpp"
#include "gearwright/base/numbers.hpp"
#include "gearwright/base/units.hpp"

namespace gearwright {

namespace {

// Returns the reduction of the misalignment f by running-in for one material, µm. The reduction is
// a fraction of f, up to a limit. For hardened surfaces, the limit is the same at all speeds v. For
// other materials, there is no limit up to 5 m/s, one limit from 5 to 10 m/s, and a smaller limit
// above 10 m/s.
double helix_running_in(const Material& m, double f, double v) {
  using K = MaterialKind;
  if (m.surface_hardened()) return std::min(0.15 * f, 6.0);
  double share = 320.0 / m.sigma_Hlim;
  double medium = 25600.0 / m.sigma_Hlim;
  double fast = 12800.0 / m.sigma_Hlim;
  if (m.kind == K::cast || m.kind == K::nodular_ferritic) {
    share = 0.55;
    medium = 45.0;
    fast = 22.0;
  }
  return std::min({share * f, v > 10.0 ? fast : v > 5.0 ? medium : kInfinity, f});
}

// The numbers of one of the five arrangements. They are K' with stiffening (`stiff`), K' without
// stiffening (`loose`), and the greatest s/l for which the figure is valid (`most`).
struct Arrangement {
  double stiff, loose, most;
};
constexpr std::array<Arrangement, 5> kArrangements{{{0.48, 0.80, 0.3},
                                                    {-0.48, -0.80, 0.3},
                                                    {1.33, 1.33, 0.5},
                                                    {-0.36, -0.60, 0.3},
                                                    {-0.60, -1.00, 0.3}}};

// Returns the reduction of the misalignment f by running-in, µm, as the mean of both materials.
//
// Formula   ISO 6336-1, 7.5.2.4, by kind of material and pitch line velocity
double running_in_misalignment(const std::array<Material, 2>& materials, double f,
                               double velocity) {
  return (helix_running_in(materials[0], f, velocity) +
          helix_running_in(materials[1], f, velocity)) /
         2;
}

}  // namespace

FaceLoad face_load(const RatedPair& pair, const PinionMounting& mounting,
                   const std::array<Material, 2>& materials, double mean_load, double c_gamma_beta,
                   const std::array<double, 2>& f_Hbeta, double velocity) {
  const Arrangement& a = kArrangements[static_cast<std::size_t>(mounting.arrangement)];
  const double d1 = pair.gears[0].reference_diameter;
  const double b = pair.face_width;
  const double k = mounting.stiffening ? a.stiff : a.loose;
  const double lever = k * mounting.bearing_span * mounting.offset / (d1 * d1) *
                       std::pow(d1 / mounting.shaft_diameter, 4);
  const double f_sh = mean_load * 0.023 * (std::abs(1.0 + lever - 0.3) + 0.3) * (b / d1) * (b / d1);
  const double f_ma = mounting.manufacture.value_or(std::hypot(f_Hbeta[0], f_Hbeta[1]));
  FaceLoad out =
      face_load({f_sh, "ISO 6336-1, 7.5.3", mounting.stiffening ? "with stiffening" : "without"},
                f_ma, materials, mean_load, c_gamma_beta, f_Hbeta, velocity);
  out.offset_in_range = mounting.offset <= a.most * mounting.bearing_span;
  return out;
}

FaceLoad face_load(const Factor& f_sh, double f_ma, const std::array<Material, 2>& materials,
                   double mean_load, double c_gamma_beta, const std::array<double, 2>& f_Hbeta,
                   double velocity) {
  FaceLoad out;
  const double least = std::max(0.005 * mean_load, 0.5 * std::max(f_Hbeta[0], f_Hbeta[1]));
  const double f_x = 1.33 * f_sh.value + f_ma;
  const double f_betax = std::max(f_x, least);
  const double f_betay = f_betax - running_in_misalignment(materials, f_betax, velocity);
  out.f_sh = f_sh;
  out.F_betax = Factor{f_betax, "ISO 6336-1, 7.5.2, (52)",
                       f_x >= least ? "1.33 f_sh + f_ma" : "the least value, F_βx min"};
  out.F_betay = Factor{f_betay, "ISO 6336-1, 7.5.2", ""};
  const double r = f_betay * c_gamma_beta / (2 * mean_load);
  out.K_Hbeta = r >= 1.0 ? Factor{2 * std::sqrt(r), "ISO 6336-1, 7.5.1, (41)",
                                  "part of the face carries load: F_βy c_γβ/(2 F_m/b) ≥ 1"}
                         : Factor{1.0 + r, "ISO 6336-1, 7.5.1, (43)",
                                  "the whole face carries load: F_βy c_γβ/(2 F_m/b) < 1"};
  return out;
}

Factor face_load_root(const RatedPair& pair, double K_Hbeta) {
  double slender = kInfinity;
  for (const RatedGear& g : pair.gears) slender = std::min(slender, g.face_width / g.tooth_height);
  const bool low = slender < 3.0;
  if (low) slender = 3.0;
  const double q = 1 / slender;
  return {std::pow(K_Hbeta, 1 / (1 + q + q * q)), "ISO 6336-1, 7.6",
          low ? "b/h < 3, so 3 is used" : "b/h ≥ 3"};
}

TransverseLoad transverse_load(const RatedPair& pair, double c_gamma_alpha, double deviation,
                               double load, double Z_epsilon) {
  const double e = pair.epsilon_gamma();
  const double q = c_gamma_alpha * deviation / load;
  const bool low = e <= 2.0;
  const double k = low ? e / 2 * (0.9 + 0.4 * q) : 0.9 + 0.4 * std::sqrt(2 * (e - 1) / e) * q;
  const auto limited = [&](double most) {
    if (k < 1.0) return Factor{1.0, "ISO 6336-1, 8.3", "below 1, so 1 is used"};
    if (k > most)
      return Factor{std::max(1.0, most), "ISO 6336-1, 8.3",
                    "one tooth pair carries the whole load"};
    return Factor{k, "ISO 6336-1, 8.3",
                  low ? "ε_γ ≤ 2, with the greater of f_pb and f_fα"
                      : "ε_γ > 2, with the greater of f_pb and f_fα"};
  };
  return {limited(e / (pair.epsilon_alpha * Z_epsilon * Z_epsilon)),
          limited(e / (0.25 * pair.epsilon_alpha + 0.75))};
}

std::vector<double> shaft_deviation(const RatedPair& pair, const MeshShafts& shafts, double F_t) {
  const double b = pair.face_width;
  std::vector<double> z;
  z.reserve(kShaftPoints);
  for (int k = 0; k < kShaftPoints; ++k) z.push_back(b * (k / (kShaftPoints - 1.0) - 0.5));

  // Gear 1 turns clockwise seen from +z, so it pushes gear 2 towards −y if it drives.
  const double push = shafts.gear2_drives ? 1.0 : -1.0;
  const double F_bt = F_t * pair.gears[0].reference_diameter / pair.gears[0].base_diameter;
  // The tilting moment is T_i tan β_w sin α_wt = F_bt r_bi tan β_b tan α_wt, because
  // tan β_w = tan β_b/cos α_wt.
  const double tilt = std::tan(pair.beta_b) * std::tan(pair.alpha_wt);
  std::vector<double> f(z.size(), 0.0);
  for (const int which : {1, 2}) {
    const auto& shaft = shafts.of[which - 1];
    if (!shaft) continue;
    const RatedGear& gear = pair.gears[pair.place(which)];
    GW_EXPECTS(!gear.internal());
    const double r_b = gear.base_diameter / 2;
    // In an external pair, the hand of gear 2 is opposite to the hand of gear 1. In an internal
    // pair, the hands are equal, but both gears turn in the same sense, so −hand1 is also correct.
    const double hand = which == 1 ? shafts.hand1 : -shafts.hand1;
    const ShaftLoad load{F_bt, push * hand * F_bt * r_b * tilt, -b / 2, b / 2};
    const std::vector<double> w = shaft_deflection(*shaft, load, z).w;
    const std::vector<double> twist =
        shaft_twist(*shaft, F_bt * r_b, gear.root_diameter, load.lo, load.hi, z);
    for (std::size_t k = 0; k < z.size(); ++k) f[k] += (w[k] + r_b * twist[k]) / kMmPerUm;
  }
  return f;
}

double shaft_misalignment(const RatedPair& pair, const MeshShafts& shafts, double F_t) {
  const std::vector<double> f = shaft_deviation(pair, shafts, F_t);
  const auto [least, greatest] = std::minmax_element(f.begin(), f.end());
  return *greatest - *least;
}

}  // namespace gearwright
